// SPDX-License-Identifier: MIT
// The folder of the meshes that some distributions use.
#pragma once

#include <string>
#include <vector>

#include "cli/file_identity.hpp"

namespace mgdt::cli {

// The folder relative to the program, which may have been moved together with it. If that does not
// exist, the folder of the installation.
std::string default_data_directory();

// The data files that these distributions need.
std::vector<FileIdentity> data_files(const std::vector<std::string>& names,
                                     const std::string& directory);

}  // namespace mgdt::cli
