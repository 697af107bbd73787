// SPDX-License-Identifier: MIT
// The points of a file for one of several readers.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cli/commands.hpp"

namespace mgdt::cli {

struct Share {
    std::vector<double> points;
    std::int64_t first = 0;          // the place of the first of them in the file
    std::size_t mid_side_nodes = 0;  // left out, by the one who read the whole file
    std::vector<FileIdentity> inputs;
};

// Where the points are, in files that have them as rows of bytes; nothing for others.
std::optional<RowLayout> shared_layout(const InputOptions& options);

// Each reader reads its rows where there is a layout, which has to be the same for all of them;
// where there is none, the first reader reads all.
Share read_share(const InputOptions& options, const std::optional<RowLayout>& layout, int reader,
                 int readers);

}  // namespace mgdt::cli
