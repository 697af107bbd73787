// SPDX-License-Identifier: MIT
// The points in TetGen's files.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/formats/lines.hpp"

namespace mgdt::cli {

// Reads points. The current line has the counts: points, dimension, attributes, markers. Returns
// the number of the first point, 0 or 1.
std::int64_t read_node_rows(LineReader& lines, std::vector<double>& points);

// Reads a whole .node file.
std::int64_t read_nodes(const Source& source, std::vector<double>& points);

// The path of the .node file beside a file; that of the compressed one if the plain one does not
// exist.
std::string beside_node_file(const Source& source);

}  // namespace mgdt::cli
