// SPDX-License-Identifier: MIT
#include "cli/formats/grid.hpp"

#include <fmt/format.h>

#include <limits>
#include <string>

#include "cli/formats/xml.hpp"

namespace mgdt::cli {
namespace {

bool fits_32_bits(std::uint64_t most) {
    return most <= static_cast<std::uint64_t>(std::numeric_limits<std::int32_t>::max());
}

// Arrays are named in the head of a file, and follow in the same order.
class Arrays {
  public:
    // The element that names an array of so many bytes.
    std::string name(const char* type, const std::string& attributes, std::uint64_t bytes) {
        const std::uint64_t begin = offset_;
        offset_ += 8 + bytes;
        return fmt::format(
            "        <DataArray type=\"{}\" {} format=\"appended\" offset=\"{}\"/>\n", type,
            attributes, begin);
    }

  private:
    std::uint64_t offset_ = 0;
};

void write_doubles(const std::vector<double>& values, OutputFile& out) {
    out.write_value(std::uint64_t{8} * values.size());
    out.write_values(values.data(), values.size());
}

// The i-th is number(i).
template <class Number>
void write_integers(std::uint64_t n, bool is_short, const Number& number, OutputFile& out) {
    out.write_value((is_short ? 4 : 8) * n);
    for (std::uint64_t i = 0; i < n; ++i) {
        const std::int64_t value = number(i);
        if (is_short)
            out.write_value(static_cast<std::int32_t>(value));
        else
            out.write_value(value);
    }
}

}  // namespace

void write_grid(const Grid& grid, OutputFile& out) {
    const std::uint64_t points = grid.points.size() / 3, corners = grid.vertices.size(),
                        cells = corners / grid.size;
    const bool short_numbers = fits_32_bits(points), short_offsets = fits_32_bits(corners);
    const auto integer = [](bool is_short) { return is_short ? "Int32" : "Int64"; };
    const auto bytes_of = [](bool is_short, std::uint64_t n) { return (is_short ? 4 : 8) * n; };
    Arrays arrays;
    std::string head = fmt::format(
        "<?xml version=\"1.0\"?>\n"
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
        "header_type=\"UInt64\">\n"
        "  <UnstructuredGrid>\n"
        "    <Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n"
        "      <Points>\n",
        points, cells);
    head +=
        arrays.name("Float64", "Name=\"Points\" NumberOfComponents=\"3\"", 8 * grid.points.size());
    head += "      </Points>\n      <Cells>\n";
    head += arrays.name(integer(short_numbers), "Name=\"connectivity\"",
                        bytes_of(short_numbers, corners));
    head += arrays.name(integer(short_offsets), "Name=\"offsets\"", bytes_of(short_offsets, cells));
    head += arrays.name("UInt8", "Name=\"types\"", cells);
    head += "      </Cells>\n";
    const bool has_data = !grid.fields.empty() || grid.ids != nullptr;
    if (has_data) head += "      <PointData>\n";
    for (const Field& f : grid.fields)
        head += arrays.name(
            "Float64",
            fmt::format("Name=\"{}\" NumberOfComponents=\"{}\"", to_xml(f.name), f.components),
            8 * f.values.size());
    if (grid.ids != nullptr) head += arrays.name("Int64", "Name=\"point\"", 8 * grid.ids->size());
    if (has_data) head += "      </PointData>\n";
    head +=
        "    </Piece>\n  </UnstructuredGrid>\n"
        "  <AppendedData encoding=\"raw\">\n_";
    out.write(head);
    write_doubles(grid.points, out);
    write_integers(
        corners, short_numbers, [&](std::uint64_t i) { return grid.vertices[i]; }, out);
    write_integers(
        cells, short_offsets,
        [&](std::uint64_t i) { return static_cast<std::int64_t>(grid.size * (i + 1)); }, out);
    out.write_value(cells);
    for (std::uint64_t i = 0; i < cells; ++i) out.write_value(grid.type);
    for (const Field& f : grid.fields) write_doubles(f.values, out);
    if (grid.ids != nullptr)
        write_integers(
            grid.ids->size(), false, [&](std::uint64_t i) { return (*grid.ids)[i]; }, out);
    out.write("\n  </AppendedData>\n</VTKFile>\n");
}

}  // namespace mgdt::cli
