// SPDX-License-Identifier: MIT
// The plan of a measurement: which runs there are, and in which order.
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
    // An empty list stands for the default. With `paper`, the distributions select among those of
    // the paper, and the sizes are the paper's.
    std::vector<std::string> distributions;
    std::vector<std::size_t> sizes;
    std::vector<std::string> schemes;
    std::vector<int> threads;
    std::vector<std::string> peers;
    std::size_t largest = 2000000;  // the largest of the paper's sets to run
    bool compact = false;           // also runs each scheme in compact storage
    int runs = 0;                   // 0 stands for 1 with the paper's sets and 3 otherwise
    std::uint64_t seed = 1;
};

// One set of points and its runs. In each round all contenders have one run, so that they meet the
// same noise of the machine.
struct PlannedSet {
    PointSetName name;
    std::vector<Row> rows;
};

struct Plan {
    std::vector<PlannedSet> sets;
    // The sets of the paper that this plan leaves out because of their size: "galaxy 3000000".
    std::vector<std::string> left_out;

    std::size_t row_count() const;
};

inline const std::vector<std::string> peer_names{"cgal", "tetgen", "qhull"};

// Makes the plan. Throws Error for an unknown name or a plan without runs.
Plan make_plan(const PlanOptions& options);

}  // namespace mgdt::cli::bench
