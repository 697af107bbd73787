// SPDX-License-Identifier: MIT
// Points and tetrahedra written as text, a row of numbers to each.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cli/formats/file_mesh.hpp"
#include "cli/output_file.hpp"

namespace mgdt::cli {

// What a row has besides its numbers.
struct RowStyle {
    std::optional<std::int64_t> first_number;  // rows are numbered from it on, or have no number
    const char* begin = "";                    // behind the number of the row, if there is one
    const char* between = " ";                 // of the numbers
    const char* end = "\n";
};

// Three coordinates to a row.
void write_points(const std::vector<double>& points, const RowStyle& style, OutputFile& out);

// Four to a row, each with `base` added, but for -1, which stands for none.
void write_rows_of_4(const std::vector<MeshIndex>& values, std::int64_t base, const RowStyle& style,
                     OutputFile& out);

}  // namespace mgdt::cli
