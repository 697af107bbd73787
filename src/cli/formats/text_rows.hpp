// SPDX-License-Identifier: MIT
// Writes points and tetrahedra as rows of text.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "cli/formats/file_mesh.hpp"
#include "cli/output_file.hpp"

namespace mgdt::cli {

// The text of a row around its numbers.
struct RowStyle {
    std::optional<std::int64_t> first_number;  // the number of the first row, if rows are numbered
    const char* begin = "";                    // between the number of the row and the first value
    const char* between = " ";                 // between two values
    const char* end = "\n";
};

// Writes three coordinates per row.
void write_points(const std::vector<double>& points, const RowStyle& style, OutputFile& out);

// Writes four values per row. `base` is added to each, except to -1, which stands for none.
void write_rows_of_4(const std::vector<MeshIndex>& values, std::int64_t base, const RowStyle& style,
                     OutputFile& out);

// Writes rows of indices, `width` of them per row, with `base` added, and a marker after each row,
// or 0 if there are no markers.
void write_marked_rows(const std::vector<MeshIndex>& values, std::size_t width, std::int64_t base,
                       const std::vector<std::int32_t>& markers, const RowStyle& style,
                       OutputFile& out);

}  // namespace mgdt::cli
