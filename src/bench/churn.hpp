// SPDX-License-Identifier: MIT
// mgdt-bench --churn: points that leave, move, and come and go, beside their insertion.
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

// Prints a table of medians. Each run proves what it ends with, and that memory stays. Throws
// Error.
void run_churn(const ChurnOptions& options);

}  // namespace mgdt::cli::bench
