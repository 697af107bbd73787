// SPDX-License-Identifier: MIT
// The share of one of several readers in the points of a file.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cli/opening.hpp"

namespace mgdt::cli {

struct Share {
    std::vector<double> points;
    std::int64_t first = 0;          // the position of the first of them in the file
    std::size_t mid_side_nodes = 0;  // how many were left out; 0 if several readers share the file
    std::vector<FileIdentity> inputs;
};

// The layout of the points, if the file has them as rows of bytes; nothing for other files.
std::optional<RowLayout> shared_layout(const InputOptions& options);

// Reads the share of a reader. With a layout, which has to be the same for all readers, each reader
// reads its rows; without, the first reader reads everything.
Share read_share(const InputOptions& options, const std::optional<RowLayout>& layout, int reader,
                 int readers);

}  // namespace mgdt::cli
