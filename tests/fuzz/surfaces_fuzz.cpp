// SPDX-License-Identifier: MIT
// OBJ, OFF, STL, text and binary, and TetGen's facets: vertices, and facets too.
#include "reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes = fuzz::text_of(data, size);
    fuzz::guess(bytes);
    fuzz::read(mgdt::cli::obj_format(), bytes);
    fuzz::read(mgdt::cli::off_format(), bytes);
    fuzz::read(mgdt::cli::stl_format(), bytes);
    mgdt::cli::ReadOptions with_facets;
    with_facets.has_facets = true;
    for (const mgdt::cli::Format* const format :
         {&mgdt::cli::obj_format(), &mgdt::cli::off_format(), &mgdt::cli::stl_format()})
        fuzz::read(*format, bytes, "", with_facets);
    fuzz::read(mgdt::cli::poly_format(), bytes, "no-such-file.poly", with_facets);
    fuzz::read(mgdt::cli::poly_format(), bytes, "no-such-file.smesh", with_facets);
    return 0;
}
