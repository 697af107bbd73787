// SPDX-License-Identifier: MIT
// Tables as text: the fields of a line, and values in further columns beside the points.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cli/formats/format.hpp"
#include "cli/formats/lines.hpp"

namespace mgdt::cli {

// The columns of x, y and z, from 1.
using Columns = std::array<int, 3>;

// The separator of a file: a comma, a semicolon, or ' ' for blanks.
char separator_of(std::string_view line);

// Splits a line into fields. Blanks and quotation marks around a field are removed; a separator
// within quotation marks belongs to the field. Two commas in sequence enclose an empty field.
// Fields after the first `most` are ignored.
std::size_t split(std::string_view line, char separator, std::string_view* fields,
                  std::size_t most);
// The same, for as many fields as --columns can choose from.
std::vector<std::string_view> split(std::string_view line, char separator);

// Reads the columns other than x, y and z. If no field is named, the columns with a number in the
// first row are read.
class TableFields {
  public:
    TableFields(const Source& source, const ReadOptions& options)
        : source_(source), options_(options) {}

    // Sets the names of columns. Columns without a name are called column4 and so on.
    void set_names(const std::vector<std::string_view>& names);
    // Reads the values in a line with a point.
    void read(const LineReader& line, std::string_view text, char separator, const Columns& points);
    std::vector<Field> take() { return std::move(fields_); }

  private:
    void choose(const std::vector<std::string_view>& first_row, const LineReader& line,
                const Columns& points);

    const Source& source_;
    const ReadOptions& options_;
    std::vector<std::string> names_;
    bool has_chosen_ = false;
    std::vector<std::size_t> columns_;  // the columns of the fields, from 0
    std::vector<Field> fields_;
};

// Writes a line of names, then the points with their fields.
void write_table(const Mesh& mesh, char separator, OutputFile& out);

}  // namespace mgdt::cli
