// SPDX-License-Identifier: MIT
// Numbers of things, in arguments and in messages.
#pragma once

#include <cstddef>
#include <string>

namespace mgdt::cli {

// Parses an integer, which may be written as 1e6. `name` is the name of the argument, for messages.
std::size_t parse_point_count(const std::string& name, const std::string& text);

// "1 point", "2 points".
std::string counted(std::size_t n, const char* singular, const char* plural);

}  // namespace mgdt::cli
