// SPDX-License-Identifier: MIT
// OBJ, OFF, and STL, text and binary: their vertices.
#include "reader.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes = fuzz::text_of(data, size);
    fuzz::guess(bytes);
    fuzz::read(mgdt::cli::obj_format(), bytes);
    fuzz::read(mgdt::cli::off_format(), bytes);
    fuzz::read(mgdt::cli::stl_format(), bytes);
    return 0;
}
