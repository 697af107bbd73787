// SPDX-License-Identifier: MIT
#include "cli/formats/table.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "cli/errors.hpp"
#include "cli/formats/number.hpp"

namespace mgdt::cli {
namespace {

constexpr std::size_t most_columns = 10000;

// The name, changed so that it reads back as one field and not as a coordinate.
std::string name_in_line(const std::string& name, char separator) {
    std::string text = printable(name);
    for (char& c : text) {
        const bool ends = c == ',' || c == ';' || c == '#' || c == '"';
        if (ends || (separator == ' ' && is_blank(c))) c = '_';
    }
    if (text.empty()) text = "values";
    if (text.size() == 1 && std::string_view("xyzXYZ").find(text[0]) != std::string_view::npos) {
        text += '_';
    }
    return text;
}

}  // namespace

char separator_of(std::string_view line) {
    for (const char mark : {';', ','}) {
        if (line.find(mark) != std::string_view::npos) return mark;
    }
    return ' ';
}

std::size_t split(std::string_view line, char separator, std::string_view* fields,
                  std::size_t most) {
    const auto ends_field = [&](char c) { return separator == ' ' ? is_blank(c) : c == separator; };
    std::size_t count = 0;
    std::size_t at = 0;
    const auto skip_blanks = [&] {
        while (at < line.size() && is_blank(line[at])) ++at;
    };
    skip_blanks();
    while (at < line.size() && count < most) {
        const bool is_quoted = line[at] == '"' && line.find('"', at + 1) != std::string_view::npos;
        const std::size_t begin = at + is_quoted;
        if (is_quoted) at = line.find('"', begin);
        const std::size_t closing = at;
        while (at < line.size() && !ends_field(line[at])) ++at;
        std::size_t end = is_quoted ? closing : at;
        while (end > begin && is_blank(line[end - 1])) --end;
        fields[count++] = line.substr(begin, end - begin);
        if (at < line.size()) ++at;
        skip_blanks();
    }
    return count;
}

std::vector<std::string_view> split(std::string_view line, char separator) {
    std::vector<std::string_view> fields(std::min(line.size(), most_columns));
    fields.resize(split(line, separator, fields.data(), fields.size()));
    return fields;
}

void TableFields::set_names(const std::vector<std::string_view>& names) {
    names_.assign(names.begin(), names.end());
}

void TableFields::choose(const std::vector<std::string_view>& first_row, const LineReader& line,
                         const Columns& points) {
    has_chosen_ = true;
    if (names_.size() > first_row.size()) {
        line.fail(fmt::format("{} columns, but the first line names {}; complete the line",
                              first_row.size(), names_.size()));
    }
    std::vector<std::string> names;
    for (std::size_t c = 0; c < first_row.size(); ++c) {
        if (std::find(points.begin(), points.end(), static_cast<int>(c + 1)) != points.end()) {
            continue;
        }
        const bool has_name = c < names_.size() && !names_[c].empty();
        names.push_back(has_name ? names_[c] : fmt::format("column{}", c + 1));
        double value = 0;
        const bool is_number = is_value(parse_number(first_row[c], value));
        const bool is_wanted =
            options_.field_names.empty() ? is_number : wants_field(options_, names.back());
        if (!is_wanted) continue;
        columns_.push_back(c);
        fields_.push_back({names.back(), 1, {}});
    }
    require_fields(source_, options_, names);
}

void TableFields::read(const LineReader& line, std::string_view text, char separator,
                       const Columns& points) {
    const std::vector<std::string_view> row = split(text, separator);
    if (!has_chosen_) choose(row, line, points);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
        const std::size_t c = columns_[i];
        if (c >= row.size()) {
            line.fail(fmt::format("{} columns, but {} needs column {}; complete the line",
                                  row.size(), quote(fields_[i].name), c + 1));
        }
        double value = 0;
        const NumberStatus status = parse_number(row[c], value);
        if (!is_value(status)) {
            line.fail(fmt::format("column {}: {} {}; a value is needed, which may be nan", c + 1,
                                  quote(row[c]), describe(status)));
        }
        fields_[i].values.push_back(value);
    }
}

void write_table(const Mesh& mesh, char separator, OutputFile& out) {
    const std::string between(1, separator);
    out.write("x" + between + "y" + between + "z");
    for (const Field& f : mesh.fields) {
        for (std::size_t k = 0; k < f.components; ++k) {
            out.write(between + name_in_line(f.name, separator));
            if (f.components > 1) out.write(fmt::format(":{}", k));
        }
    }
    out.write("\n");
    for (std::size_t i = 0; i < mesh.point_count(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (k > 0) out.write(between);
            out.write_number(mesh.points[3 * i + k]);
        }
        for (const Field& f : mesh.fields) {
            for (std::size_t k = 0; k < f.components; ++k) {
                out.write(between);
                out.write_number(f.values[f.components * i + k]);
            }
        }
        out.write("\n");
    }
}

}  // namespace mgdt::cli
