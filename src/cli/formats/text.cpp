// SPDX-License-Identifier: MIT
// Points as plain text, one a line: x y z, separated by blanks and tabs, by commas, or by
// semicolons, by the same throughout a file. Comments begin with #. One header line may come first:
// column names, of which x, y and z are read, or the number of points.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "cli/errors.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/lines.hpp"
#include "cli/formats/number.hpp"
#include "cli/formats/table.hpp"

namespace mgdt::cli {
namespace {

bool is_name(std::string_view field, std::string_view name) {
    return std::equal(field.begin(), field.end(), name.begin(), name.end(), [](char a, char b) {
        return (a >= 'A' && a <= 'Z' ? static_cast<char>(a - 'A' + 'a') : a) == b;
    });
}

// The columns that a line of names calls x, y and z, or as ParaView does; where there are three in
// all, these.
std::optional<Columns> named_columns(std::string_view line) {
    const std::vector<std::string_view> names = split(line, separator_of(line));
    constexpr std::array<std::string_view, 3> known[] = {{"x", "y", "z"},
                                                         {"points:0", "points:1", "points:2"}};
    for (const auto& wanted : known) {
        Columns columns = {};
        int found = 0;
        for (std::size_t i = 0; i < names.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                if (!is_name(names[i], wanted[k])) continue;
                columns[k] = static_cast<int>(i + 1);
                ++found;
            }
        }
        const bool has_all = std::find(columns.begin(), columns.end(), 0) == columns.end();
        if (found == 3 && has_all) return columns;
    }
    return names.size() == 3 ? std::optional<Columns>({1, 2, 3}) : std::nullopt;
}

// The coordinates that are in a line, and how they are read.
struct Row {
    std::size_t count = 0;  // of fields
    std::array<std::string_view, 3> fields;
    double xyz[3] = {};
    std::array<NumberStatus, 3> status;
    // Whether a line may be one of names: none is a number, or begins as one.
    bool is_of_words = true;
};

class RowReader {
  public:
    explicit RowReader(const Columns& columns) : columns_(columns) {
        const int last = *std::max_element(columns.begin(), columns.end());
        fields_.resize(static_cast<std::size_t>(std::max(last, 2)));
    }

    Row read(std::string_view line, char separator) {
        Row row;
        row.count = split(line, separator, fields_.data(), fields_.size());
        for (std::size_t k = 0; k < 3; ++k) {
            const auto column = static_cast<std::size_t>(columns_[k]);
            row.status[k] = NumberStatus::not_a_number;
            row.is_of_words = row.is_of_words && column <= row.count;
            if (column > row.count) continue;
            row.fields[k] = fields_[column - 1];
            row.status[k] = parse_number(row.fields[k], row.xyz[k]);
            const std::size_t sign = row.fields[k].find_first_not_of("+-.");
            const char begin = sign == std::string_view::npos ? ' ' : row.fields[k][sign];
            row.is_of_words = row.is_of_words && row.status[k] == NumberStatus::not_a_number &&
                              !(begin >= '0' && begin <= '9');
        }
        return row;
    }

    void require_numbers(const Row& row, char separator, const LineReader& lines) const {
        for (std::size_t k = 0; k < 3; ++k) {
            if (static_cast<std::size_t>(columns_[k]) > row.count) {
                lines.fail(
                    fmt::format("{} column{}, but {} needs column {}; complete the line, or "
                                "choose columns with --columns",
                                row.count, row.count == 1 ? "" : "s", "xyz"[k], columns_[k]));
            }
            if (row.status[k] == NumberStatus::ok) continue;
            std::string advice;
            if (row.status[k] == NumberStatus::not_a_number) {
                advice =
                    "; correct the line, mark it as a comment with #, or choose columns with "
                    "--columns";
                if (row.fields[k].find_first_of(",;") != std::string_view::npos) {
                    advice = fmt::format(
                        "; fields are separated by {} in this file, and decimals "
                        "by points",
                        separator == ' '   ? "blanks"
                        : separator == ',' ? "commas"
                                           : "semicolons");
                }
            }
            lines.fail(fmt::format("column {}: {} {}{}", columns_[k], quote(row.fields[k]),
                                   describe(row.status[k]), advice));
        }
    }

  private:
    Columns columns_;
    std::vector<std::string_view> fields_;
};

Mesh read_text(const Source& source, const ReadOptions& options) {
    if (source.bytes.substr(0, 2) == "\xff\xfe" || source.bytes.substr(0, 2) == "\xfe\xff") {
        source.fail("this is UTF-16 text; convert it with iconv -f UTF-16 -t UTF-8");
    }
    const std::size_t bom = source.bytes.substr(0, 3) == "\xef\xbb\xbf" ? 3 : 0;

    Mesh mesh;
    mesh.detail = "text";
    std::int64_t announced = -1;
    std::size_t announced_at = 0;
    Columns columns = options.columns.value_or(Columns{1, 2, 3});
    RowReader rows(columns);
    std::optional<TableFields> fields;
    if (options.has_fields) fields.emplace(source, options);
    char separator =
        0;  // not known before the first line of coordinates, or of names that are used
    bool is_first = true;
    LineReader lines(source, bom);
    while (lines.next_with_text()) {
        const char here = separator != 0 ? separator : separator_of(lines.text());
        Row row = rows.read(lines.text(), here);
        if (is_first) {
            is_first = false;
            std::string_view count;
            if (row.count == 1 && split(lines.text(), here, &count, 1) == 1 &&
                parse_integer(count, announced) && announced >= 0) {
                announced_at = lines.number();
                continue;
            }
            announced = -1;
            if (row.is_of_words) {
                if (fields) fields->set_names(split(lines.text(), here));
                if (options.columns.has_value()) continue;
                const std::optional<Columns> named = named_columns(lines.text());
                if (!named.has_value()) {
                    lines.fail(
                        "no number, and no columns with the names x, y and z; give them "
                        "these names, or choose columns with --columns");
                }
                columns = *named;
                rows = RowReader(columns);
                separator = here;
                continue;
            }
        }
        separator = here;
        rows.require_numbers(row, separator, lines);
        mesh.points.insert(mesh.points.end(), row.xyz, row.xyz + 3);
        if (fields) fields->read(lines, separator, columns);
    }
    if (fields) mesh.fields = fields->take();
    if (announced >= 0 && static_cast<std::uint64_t>(announced) != mesh.point_count()) {
        source.fail_at_line(announced_at,
                            fmt::format("announces {} points, but {} follow; correct or remove the "
                                        "line",
                                        announced, mesh.point_count()));
    }
    return mesh;
}

void write_rows(const std::vector<double>& points, const char* separator, OutputFile& out) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        out.write_number(points[i]);
        out.write(i % 3 < 2 ? separator : "\n");
    }
}

void write_text(const std::vector<double>& points, OutputFile& out, const WriteOptions&) {
    write_rows(points, " ", out);
}

void write_csv(const std::vector<double>& points, OutputFile& out, const WriteOptions&) {
    out.write("x,y,z\n");
    write_rows(points, ",", out);
}

void write_text_fields(const Mesh& mesh, OutputFile& out, const WriteOptions&) {
    write_table(mesh, ' ', out);
}

void write_csv_fields(const Mesh& mesh, OutputFile& out, const WriteOptions&) {
    write_table(mesh, ',', out);
}

}  // namespace

const Format& text_format() {
    static const Format format = {"xyz",
                                  {".xyz", ".txt", ".dat", ".pts", ".asc"},
                                  "text, x y z a line",
                                  false,
                                  nullptr,
                                  read_text,
                                  write_text,
                                  nullptr,
                                  nullptr,
                                  write_text_fields};
    return format;
}

const Format& csv_format() {
    static const Format format = {
        "csv",   {".csv", ".tsv"}, "text, x,y,z a line", false, nullptr, read_text, write_csv,
        nullptr, nullptr,          write_csv_fields};
    return format;
}

}  // namespace mgdt::cli
