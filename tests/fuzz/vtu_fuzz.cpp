// SPDX-License-Identifier: MIT
// VTK's XML unstructured grids, arrays as text, binary and compressed.
#include "reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes = fuzz::text_of(data, size);
    fuzz::guess(bytes);
    if (const auto mesh = fuzz::read(mgdt::cli::vtu_format(), bytes)) {
        fuzz::mesh_returns(mgdt::cli::vtu_format(), *mesh);
        if (mgdt::cli::can_compress())
            fuzz::mesh_returns(mgdt::cli::vtu_format(), *mesh, {0, true});
    }
    fuzz::fields_return(mgdt::cli::vtu_format(), bytes);
    fuzz::facets_and_markers_read(mgdt::cli::vtu_format(), bytes);
    fuzz::facets_and_markers_read(mgdt::cli::vtp_format(), bytes);
    return 0;
}
