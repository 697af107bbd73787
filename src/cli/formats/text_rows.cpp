// SPDX-License-Identifier: MIT
#include "cli/formats/text_rows.hpp"

namespace mgdt::cli {
namespace {

// Calls write(i) for each of the values, `width` of them per row.
template <class Write>
void write_rows(std::size_t count, std::size_t width, const RowStyle& style, OutputFile& out,
                const Write& write) {
    std::int64_t number = style.first_number.value_or(0);
    for (std::size_t i = 0; i < count; i += width) {
        if (style.first_number) out.write_integer(number++);
        out.write(style.begin);
        for (std::size_t k = 0; k < width; ++k) {
            if (k > 0) out.write(style.between);
            write(i + k);
        }
        out.write(style.end);
    }
}

}  // namespace

void write_points(const std::vector<double>& points, const RowStyle& style, OutputFile& out) {
    write_rows(points.size(), 3, style, out, [&](std::size_t i) { out.write_number(points[i]); });
}

void write_rows_of_4(const std::vector<MeshIndex>& values, std::int64_t base, const RowStyle& style,
                     OutputFile& out) {
    write_rows(values.size(), 4, style, out,
               [&](std::size_t i) { out.write_integer(values[i] < 0 ? -1 : values[i] + base); });
}

void write_marked_rows(const std::vector<MeshIndex>& values, std::size_t width, std::int64_t base,
                       const std::vector<std::int32_t>& markers, const RowStyle& style,
                       OutputFile& out) {
    write_rows(values.size(), width, style, out, [&](std::size_t i) {
        out.write_integer(values[i] + base);
        if (i % width != width - 1) return;
        out.write(style.between);
        out.write_integer(markers.empty() ? 0 : markers[i / width]);
    });
}

}  // namespace mgdt::cli
