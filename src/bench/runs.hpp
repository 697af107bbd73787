// SPDX-License-Identifier: MIT
// Runs of mgdt and of its peers on a set of points, each in a process of its own.
#pragma once

#include <functional>
#include <string>

#include "bench/point_set.hpp"
#include "bench/row.hpp"

namespace mgdt::cli::bench {

// Called now and then; the fraction is 0 as long as nothing is known.
using Watcher = std::function<void(double fraction)>;

// Both fill in the status and the figures of a row that says what to run; the status is empty if
// this program is to end. The time limit is in seconds, 0 for none.
void run_mgdt(const PointSet& set, double time_limit, const Watcher& watch, Row& row);

// `runner` is the path of a program that reads doubles from standard input to their end, builds
// the triangulation and prints, as its last line, its library's version, the seconds that this
// took, the number of tetrahedra, and by how many bytes it made the process grow at most. One
// that fails says why in its last line and exits with another code than 0: 5 for out of memory.
void run_peer(const PointSet& set, const std::string& runner, double time_limit,
              const Watcher& watch, Row& row);

}  // namespace mgdt::cli::bench
