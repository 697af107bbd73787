// SPDX-License-Identifier: MIT
// Files that gzip has compressed.
#pragma once

#include <string>
#include <string_view>

namespace mgdt::cli {

// Whether a file's name says that it is compressed.
bool is_gzip_name(std::string_view path);

// What the compressed bytes stand for. Throws Error, naming the input, where they are not gzip's,
// are damaged or cut short, or where this program was built without zlib.
std::string expand_gzip(std::string_view bytes, const std::string& name);

}  // namespace mgdt::cli
