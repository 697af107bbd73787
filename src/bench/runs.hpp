// SPDX-License-Identifier: MIT
// Runs mgdt and its peers on a set of points, each in a process of its own.
#pragma once

#include <functional>
#include <string>

#include "bench/point_set.hpp"
#include "bench/row.hpp"

namespace mgdt::cli::bench {

// Called repeatedly during a run. The fraction is 0 as long as it is not known.
using Watcher = std::function<void(double fraction)>;

// Both functions run what the row says, and set its status and figures. The status is empty if this
// program has to end. The time limit is in seconds; 0 means none.
void run_mgdt(const PointSet& set, double time_limit, const Watcher& watch, Row& row);

// `runner` is the path of a program that reads doubles from standard input to the end and builds
// the triangulation. Its last line is the version of its library, the seconds of the construction,
// the number of tetrahedra, and the largest growth of the process in bytes. If it fails, its last
// line says why and its exit code is not 0; 5 means out of memory.
void run_peer(const PointSet& set, const std::string& runner, double time_limit,
              const Watcher& watch, Row& row);

}  // namespace mgdt::cli::bench
