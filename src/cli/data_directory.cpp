// SPDX-License-Identifier: MIT
#include "cli/data_directory.hpp"

#include <filesystem>

#include "cli/point_sets/distributions.hpp"
#include "cli/system.hpp"

namespace mgdt::cli {

std::string default_data_directory() {
    if (const auto program = system::program_file()) {
        const std::filesystem::path folder = std::filesystem::u8path(*program).parent_path();
        std::string moved = (folder / MGDT_DATA_FROM_PROGRAM).lexically_normal().u8string();
        const auto status = system::status(moved);
        if (status && status->kind == system::FileKind::directory) return moved;
    }
    return MGDT_DATA_DIRECTORY;
}

std::vector<FileIdentity> data_files(const std::vector<std::string>& names,
                                     const std::string& directory) {
    std::vector<FileIdentity> files;
    for (const std::string& name : names) {
        if (const auto file = identity_of_input(data_path(name, directory))) files.push_back(*file);
    }
    return files;
}

}  // namespace mgdt::cli
