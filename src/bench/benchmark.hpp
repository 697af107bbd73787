// SPDX-License-Identifier: MIT
// The options of mgdt-bench, and the function that does what they ask for.
#pragma once

#include <string>
#include <vector>

#include "bench/plan.hpp"

namespace mgdt::cli::bench {

struct BenchOptions {
    PlanOptions plan;
    std::vector<std::string> sizes;  // the numbers of points, as they were typed
    std::string largest;
    double time_limit = 0;  // seconds per run; 0 for no limit
    std::string csv, json;  // paths of files, or empty
    std::string data_directory;
    std::string peer_directory;  // empty for the folder of the program
    std::string command;         // the command line as it was typed
    bool churn = false;          // measure removal and motion instead
    bool quiet = false;
};
// Runs the measurements and prints them. Returns an exit code or throws Error.
int run(const BenchOptions& options);

}  // namespace mgdt::cli::bench
