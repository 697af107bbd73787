// SPDX-License-Identifier: MIT
// mgdt-bench --churn: removals, moves, and rounds of removals and insertions, compared with plain
// insertions.
#pragma once

#include <string>
#include <vector>

#include "bench/point_set.hpp"

namespace mgdt::cli::bench {

struct ChurnOptions {
    std::vector<PointSetName> sets;
    int threads = 1, runs = 3;
    bool compact = false;
    std::string data_directory;
};

// Prints a table of medians. Each run checks its final triangulation, and that memory does not
// grow. Throws Error.
void run_churn(const ChurnOptions& options);

}  // namespace mgdt::cli::bench
