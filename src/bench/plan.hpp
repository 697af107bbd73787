// SPDX-License-Identifier: MIT
// What is to be run, and in which order.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "bench/point_set.hpp"
#include "bench/row.hpp"

namespace mgdt::cli::bench {

struct PlanOptions {
    bool paper = false;
    // Empty for the defaults. With `paper` the distributions choose among the paper's, and the
    // sizes are the paper's.
    std::vector<std::string> distributions;
    std::vector<std::size_t> sizes;
    std::vector<std::string> schemes;
    std::vector<int> threads;
    std::vector<std::string> peers;
    std::size_t largest = 2000000;  // of the paper's sets
    bool compact = false;           // each scheme in compact storage too
    int runs = 0;                   // 0: 1 for the paper's sets, else 3
    std::uint64_t seed = 1;
};

// One set of points and the rows that are to be filled in on it: in each run everyone has a turn,
// so that all meet the same noise of the machine.
struct PlannedSet {
    PointSetName name;
    std::vector<Row> rows;
};

struct Plan {
    std::vector<PlannedSet> sets;
    // What the paper ran and this plan leaves out for its size: "galaxy 3000000".
    std::vector<std::string> left_out;

    std::size_t row_count() const;
};

inline const std::vector<std::string> peer_names{"cgal", "tetgen", "qhull"};

// Throws Error for a name that is unknown or a list that leaves nothing to run.
Plan make_plan(const PlanOptions& options);

}  // namespace mgdt::cli::bench
