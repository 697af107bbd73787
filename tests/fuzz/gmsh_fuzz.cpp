// SPDX-License-Identifier: MIT
// Gmsh, versions 2.2 and 4.1, text and binary.
#include "reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes = fuzz::text_of(data, size);
    fuzz::guess(bytes);
    if (const auto mesh = fuzz::read(mgdt::cli::gmsh_format(), bytes)) {
        fuzz::mesh_returns(mgdt::cli::gmsh_format(), *mesh);
        fuzz::mesh_returns(mgdt::cli::gmsh2_format(), *mesh);
    }
    fuzz::facets_and_markers_read(mgdt::cli::gmsh_format(), bytes);
    return 0;
}
