// SPDX-License-Identifier: MIT
// Reads files that are compressed by gzip.
#pragma once

#include <string>
#include <string_view>

namespace mgdt::cli {

// Whether a file's name says that it is compressed.
bool is_gzip_name(std::string_view path);

// The expanded bytes. Throws Error with the name of the input if the bytes are not gzip's, are
// damaged or cut short, or if this program was built without zlib.
std::string expand_gzip(std::string_view bytes, const std::string& name);

}  // namespace mgdt::cli
