// SPDX-License-Identifier: MIT
// Tables as text: the fields of a line, and values in columns beside those of the points.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cli/formats/format.hpp"
#include "cli/formats/lines.hpp"

namespace mgdt::cli {

// Of x, y and z, from 1.
using Columns = std::array<int, 3>;

// What stands between the fields of a file: a comma, a semicolon, or a run of blanks for ' '.
char separator_of(std::string_view line);

// Splits a line. Blanks around a field are not the field's, nor are quotes, within which a
// separator is text. An empty field between two commas stays a field. Fields after the first `most`
// are not looked at.
std::size_t split(std::string_view line, char separator, std::string_view* fields,
                  std::size_t most);
// The same, as many as --columns can choose from.
std::vector<std::string_view> split(std::string_view line, char separator);

// Reads the columns that are not the points'. Where no field is named, those that have a number in
// the first row are meant.
class TableFields {
  public:
    TableFields(const Source& source, const ReadOptions& options)
        : source_(source), options_(options) {}

    // Names of columns; others are called column4 and so on.
    void set_names(const std::vector<std::string_view>& names);
    // The values in a line that has a point.
    void read(const LineReader& line, std::string_view text, char separator, const Columns& points);
    std::vector<Field> take() { return std::move(fields_); }

  private:
    void choose(const std::vector<std::string_view>& first_row, const LineReader& line,
                const Columns& points);

    const Source& source_;
    const ReadOptions& options_;
    std::vector<std::string> names_;
    bool has_chosen_ = false;
    std::vector<std::size_t> columns_;  // of the fields, from 0
    std::vector<Field> fields_;
};

// Writes a line of names, then the points with their fields.
void write_table(const Mesh& mesh, char separator, OutputFile& out);

}  // namespace mgdt::cli
