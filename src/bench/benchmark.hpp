// SPDX-License-Identifier: MIT
// What is asked of mgdt-bench.
#pragma once

#include <string>
#include <vector>

#include "bench/plan.hpp"

namespace mgdt::cli::bench {

struct BenchOptions {
    PlanOptions plan;
    std::vector<std::string> sizes;  // of the plan, as they were typed
    std::string largest;
    double time_limit = 0;  // seconds a run; 0 for none
    std::string csv, json;  // files, or empty
    std::string data_directory;
    std::string peer_directory;  // empty: beside the program
    std::string command;         // as it was typed
    bool churn = false;          // measure removal and motion instead
    bool quiet = false;
};
// Runs what is asked for, and prints it. Returns an exit code or throws Error.
int run(const BenchOptions& options);

}  // namespace mgdt::cli::bench
