// SPDX-License-Identifier: MIT
// Medians over the runs of everyone on every set, and how peers compare.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/row.hpp"

namespace mgdt::cli::bench {

// Of an even number the mean of the two in the middle. At least one value.
double median(std::vector<double> values);

// The runs of one subject as one row: medians of the figures of those that went well, or the
// status of the first if none did. `run` is how many went well.
struct Median {
    Row row;
    int runs = 0;  // all of them
    // Peers' seconds by ours, on the same set, of those that have both.
    std::map<std::string, double> ratios;
    // Of a peer: the number of tetrahedra that mgdt has on the same set, if it is another.
    std::optional<double> other_count;
};

std::vector<Median> medians(const std::vector<Row>& rows);

// Over the sets, of one scheme and number of threads against one peer.
struct Comparison {
    std::string scheme;
    int threads;
    std::string peer;
    double geometric_mean, least;
    std::size_t sets;
};

std::vector<Comparison> comparisons(const std::vector<Median>& medians);

// The first two rows of mgdt on one set whose numbers of tetrahedra differ, which they may not;
// empty if there are none.
std::string disagreement(const std::vector<Row>& rows);

}  // namespace mgdt::cli::bench
