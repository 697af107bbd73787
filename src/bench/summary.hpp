// SPDX-License-Identifier: MIT
// Medians over the runs of each contender on each set, and comparisons with peers.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "bench/row.hpp"

namespace mgdt::cli::bench {

// The median of at least one value. For an even number it is the mean of the two in the middle.
double median(std::vector<double> values);

// The runs of one subject as one row. It has the medians of the successful runs, or the status of
// the first run if none was successful. `run` is the number of successful runs.
struct Median {
    Row row;
    int runs = 0;  // the number of all runs
    // By peer: its time divided by that of mgdt on the same set, if both are known.
    std::map<std::string, double> ratios;
    // For a peer whose number of tetrahedra differs from that of mgdt: the number of mgdt.
    std::optional<double> other_count;
};

std::vector<Median> medians(const std::vector<Row>& rows);

// A comparison of one scheme and number of threads with one peer, over all sets.
struct Comparison {
    std::string scheme;
    int threads;
    std::string peer;
    double geometric_mean, least;
    std::size_t sets;
};

std::vector<Comparison> comparisons(const std::vector<Median>& medians);

// Describes the first two rows of mgdt on the same set that differ in the number of tetrahedra,
// which is an error. Empty if there are none.
std::string disagreement(const std::vector<Row>& rows);

}  // namespace mgdt::cli::bench
