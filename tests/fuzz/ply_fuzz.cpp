// SPDX-License-Identifier: MIT
// PLY, text and binary.
#include "reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes = fuzz::text_of(data, size);
    fuzz::guess(bytes);
    if (const auto mesh = fuzz::read(mgdt::cli::ply_format(), bytes))
        fuzz::points_return(mgdt::cli::ply_format(), mesh->points);
    mgdt::cli::ReadOptions with_facets;
    with_facets.has_facets = true;
    fuzz::read(mgdt::cli::ply_format(), bytes, "", with_facets);
    return 0;
}
