// SPDX-License-Identifier: MIT
// Where the meshes are that some kinds of points are made from.
#pragma once

#include <string>

namespace mgdt::cli {

// Beside the program, which may have been moved together with them, or else where they were to be
// installed.
std::string default_data_directory();

}  // namespace mgdt::cli
