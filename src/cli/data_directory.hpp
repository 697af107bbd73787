// SPDX-License-Identifier: MIT
// The folder of the meshes that some distributions use.
#pragma once

#include <string>

namespace mgdt::cli {

// The folder relative to the program, which may have been moved together with it. If that does not
// exist, the folder of the installation.
std::string default_data_directory();

}  // namespace mgdt::cli
