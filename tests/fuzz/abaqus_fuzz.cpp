// SPDX-License-Identifier: MIT
// Abaqus, text.
#include "reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes = fuzz::text_of(data, size);
    fuzz::guess(bytes);
    if (const auto mesh = fuzz::read(mgdt::cli::abaqus_format(), bytes))
        fuzz::mesh_returns(mgdt::cli::abaqus_format(), *mesh);
    fuzz::facets_and_markers_read(mgdt::cli::abaqus_format(), bytes);
    return 0;
}
