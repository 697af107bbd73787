// SPDX-License-Identifier: MIT
// The points of a file for one of several readers.
#pragma once

#include <cstdint>
#include <vector>

#include "cli/commands.hpp"

namespace mgdt::cli {

struct Share {
    std::vector<double> points;
    std::int64_t first = 0;  // the place of the first of them in the file
    std::vector<FileIdentity> inputs;
};

// Of files whose points are rows of bytes, each reader reads its rows; of others the first reader
// reads all.
Share read_share(const InputOptions& options, int reader, int readers);

}  // namespace mgdt::cli
