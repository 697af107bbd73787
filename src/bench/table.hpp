// SPDX-License-Identifier: MIT
// The text that a measurement prints: one line per run, then medians and ratios.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "bench/row.hpp"
#include "bench/summary.hpp"

namespace mgdt::cli::bench {

void print_heading(std::FILE* out);
void print_row(std::FILE* out, const Row& row);
// Prints the medians, with a column of ratios for each of the peers.
void print_summary(std::FILE* out, const std::vector<Median>& medians,
                   const std::vector<std::string>& peers);

}  // namespace mgdt::cli::bench
