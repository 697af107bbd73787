// SPDX-License-Identifier: MIT
#include "cli/data_directory.hpp"

#include <filesystem>

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

}  // namespace mgdt::cli
