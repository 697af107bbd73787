// SPDX-License-Identifier: MIT
// Points as plain text, one per line: x y z, separated by blanks, commas or semicolons, the same
// throughout a file. Comments begin with #, ! or //. The first line may have the names of columns,
// of which x, y and z are read, or the number of points. The format of chemists for atoms is read
// too.
#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "cli/errors.hpp"
#include "cli/formats/extended_xyz.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/lines.hpp"
#include "cli/formats/number.hpp"
#include "cli/formats/table.hpp"
#include "cli/formats/text_rows.hpp"

namespace mgdt::cli {
namespace {

// The columns that a header line names x, y and z, or as ParaView and surveyors name them. Nothing
// if there are not exactly these three.
std::optional<Columns> named_columns(std::string_view line) {
    const std::vector<std::string_view> names = split(line, separator_of(line));
    constexpr std::array<std::string_view, 3> known[] = {{"x", "y", "z"},
                                                         {"points:0", "points:1", "points:2"},
                                                         {"points_0", "points_1", "points_2"},
                                                         {"easting", "northing", "height"},
                                                         {"easting", "northing", "elevation"},
                                                         {"easting", "northing", "altitude"},
                                                         {"easting", "northing", "z"}};
    for (const auto& wanted : known) {
        Columns columns = {};
        int found = 0;
        for (std::size_t i = 0; i < names.size(); ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                if (!is_same_but_for_case(names[i], wanted[k])) continue;
                columns[k] = static_cast<int>(i + 1);
                ++found;
            }
        }
        const bool has_all = std::find(columns.begin(), columns.end(), 0) == columns.end();
        if (found == 3 && has_all) return columns;
    }
    return names.size() == 3 ? std::optional<Columns>({1, 2, 3}) : std::nullopt;
}

// The line without its comment, which begins with #, or with ! or // at the beginning of the line
// or after a blank.
std::string_view without_comment(std::string_view line) {
    line = line.substr(0, line.find('#'));
    for (const std::string_view mark : {"!", "//"}) {
        for (std::size_t at = line.find(mark); at != std::string_view::npos;
             at = line.find(mark, at + 1)) {
            if (at == 0 || is_blank(line[at - 1])) {
                line = line.substr(0, at);
                break;
            }
        }
    }
    return line;
}

// The coordinates of a line, and how they are read.
struct Row {
    std::size_t count = 0;  // the number of fields
    std::array<std::string_view, 3> fields;
    double xyz[3] = {};
    std::array<NumberStatus, 3> status;
    // Whether the line may be a header: no field is a number or begins like one.
    bool is_of_words = true;
};

class RowReader {
  public:
    explicit RowReader(const Columns& columns) : columns_(columns) {
        const int last = *std::max_element(columns.begin(), columns.end());
        fields_.resize(static_cast<std::size_t>(std::max(last, 2)));
    }

    // From this call on, read() counts at least this number of fields of a row.
    void look_at(std::size_t fields) { fields_.resize(std::max(fields_.size(), fields)); }

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

    void require_numbers(const Row& row, char separator, const LineReader& lines,
                         const ReadOptions& options) const {
        for (std::size_t k = 0; k < 3; ++k) {
            if (static_cast<std::size_t>(columns_[k]) > row.count) {
                lines.fail(
                    fmt::format("{} column{}, but {} needs column {}; complete the line, or "
                                "choose columns with {}",
                                row.count, row.count == 1 ? "" : "s", "xyz"[k], columns_[k],
                                options.columns_option));
            }
            if (row.status[k] == NumberStatus::ok) continue;
            std::string advice;
            if (row.status[k] == NumberStatus::not_a_number) {
                advice = fmt::format(
                    "; correct the line, mark it as a comment with #, or choose columns with {}",
                    options.columns_option);
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

// Goes to the next line with text that is no comment. Returns false at the end of the file.
bool next_row(LineReader& lines, std::string_view& row) {
    while (lines.next()) {
        row = without_comment(lines.text());
        if (row.find_first_not_of(" \t\f\v") != std::string_view::npos) return true;
    }
    return false;
}

// Whether the line ends with a separator, after which there is one more, empty, column.
bool ends_empty(std::string_view line, char separator) {
    if (separator == ' ') return false;
    const std::size_t last = line.find_last_not_of(" \t\f\v");
    return last != std::string_view::npos && line[last] == separator;
}

std::size_t count_columns(std::string_view line, char separator) {
    return split(line, separator).size() + ends_empty(line, separator);
}

// Whether the first column counts the rows, from 0 or 1.
bool first_column_counts(LineReader lines, std::string_view row, char separator) {
    std::int64_t before = -1;
    int rows = 0;
    do {
        std::string_view field;
        std::int64_t number = 0;
        if (split(row, separator, &field, 1) == 0 || !parse_integer(field, number)) return false;
        if (rows == 0 ? number != 0 && number != 1 : number != before + 1) return false;
        before = number;
        ++rows;
    } while (rows < 100 && next_row(lines, row));
    return rows > 1;
}

// Whether the file has the .xyz format of chemists: the number of atoms, a line of any text, then a
// line per atom with its element (symbol or number), x, y, z, and further values.
bool is_of_chemists(LineReader lines) {
    std::string_view field;
    std::int64_t count = 0;
    if (!lines.next()) return false;
    Fields first(lines);
    if (!first.next(field) || !parse_integer(field, count) || count < 1 || first.next(field))
        return false;
    if (!lines.next()) return false;
    const std::string_view title = lines.text();
    for (const std::string_view name : {"Lattice=", "Properties="})
        if (title.find(name) != std::string_view::npos) return true;
    if (!lines.next()) return false;
    Fields atom(lines);
    if (!atom.next(field)) return false;
    const auto is_letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); };
    const bool is_symbol = is_letter(field[0]) && field.size() <= 6;
    std::int64_t element = 0;
    if (!is_symbol && !(parse_integer(field, element) && element >= 0 && element <= 118))
        return false;
    double x = 0;
    for (int k = 0; k < 3; ++k) {
        if (!atom.next(field) || parse_number(field, x) == NumberStatus::not_a_number) return false;
    }
    if (is_symbol) return true;
    // If elements are numbers, the second line must not be a row of numbers.
    std::string_view word;
    if (split(title, ' ', &word, 1) == 0) return true;
    return parse_number(word, x) == NumberStatus::not_a_number;
}

class TextReader {
  public:
    TextReader(const Source& source, const ReadOptions& options)
        : source_(source),
          options_(options),
          lines_(source, source.bytes.substr(0, 3) == "\xef\xbb\xbf" ? 3 : 0),
          columns_(options.columns.value_or(Columns{1, 2, 3})),
          rows_(columns_) {
        if (options.has_fields) fields_.emplace(source, options);
    }

    Mesh read() {
        Mesh mesh;
        mesh.detail = "text";
        if (is_of_chemists(lines_)) {
            mesh.detail = "text, atoms";
            begin_atoms(mesh);
        } else {
            begin_table();
        }
        while (has_row_) {
            const char separator = separator_ != 0 ? separator_ : separator_of(text_);
            const Row row = rows_.read(text_, separator);
            rows_.require_numbers(row, separator, lines_, options_);
            require_same_columns(row, separator);
            separator_ = separator;
            mesh.points.insert(mesh.points.end(), row.xyz, row.xyz + 3);
            if (fields_) fields_->read(lines_, text_, separator, columns_);
            next();
            if (are_atoms_ && has_row_ && is_complete(mesh))
                lines_.fail(
                    fmt::format("text after the {} atoms that line 1 announces; where it is the "
                                "next frame, split the file",
                                announced_));
        }
        if (fields_) mesh.fields = fields_->take();
        if (announced_ >= 0 && !is_complete(mesh)) {
            source_.fail_at_line(
                announced_at_,
                fmt::format("announces {} points, but {} follow; correct or remove the line",
                            announced_, mesh.point_count()));
        }
        return mesh;
    }

  private:
    bool is_complete(const Mesh& mesh) const {
        return mesh.point_count() == static_cast<std::uint64_t>(announced_);
    }
    void next() { has_row_ = next_row(lines_, text_); }
    void begin_atoms(Mesh& mesh) {
        are_atoms_ = true;
        lines_.next();
        announced_ = Fields(lines_).integer("the number of atoms");
        announced_at_ = lines_.number();
        lines_.next();
        const XyzTitle title = read_xyz_title(lines_);
        mesh.box = title.box;
        if (mesh.box) mesh.detail = "text, atoms in a box";
        const int x = title.first_column.value_or(2);
        if (!options_.columns) choose({x, x + 1, x + 2});
        separator_ = ' ';
        next();
    }
    // Reads a header line or the number of points, if the file begins with it.
    void begin_table() {
        next();
        if (!has_row_) return;
        const char separator = separator_of(text_);
        std::string_view fields[2];
        if (split(text_, separator, fields, 2) == 1 && parse_integer(fields[0], announced_) &&
            announced_ >= 0) {
            announced_at_ = lines_.number();
            next();
        } else {
            announced_ = -1;
            if (rows_.read(text_, separator).is_of_words) {
                take_names(separator);
                next();
                return;
            }
        }
        if (has_row_ && !options_.columns) require_three_columns(separator_of(text_));
    }
    void take_names(char separator) {
        if (fields_) fields_->set_names(split(text_, separator));
        if (options_.columns) return;
        const std::optional<Columns> named = named_columns(text_);
        if (!named) {
            lines_.fail(
                fmt::format("no number, and no columns with the names x, y and z; give them these "
                            "names, or choose columns with {}",
                            options_.columns_option));
        }
        choose(*named);
        separator_ = separator;
        expect(count_columns(text_, separator));
    }
    void choose(const Columns& columns) {
        columns_ = columns;
        rows_ = RowReader(columns);
    }
    // With more than three columns, which ones are x, y and z would be a guess.
    void require_three_columns(char separator) const {
        std::size_t n = split(text_, separator).size();
        if (n <= 3) return;
        const bool counts = first_column_counts(lines_, text_, separator);
        lines_.fail(fmt::format("{} columns without names; say which are x, y and z, with {} {}{}",
                                n, options_.columns_option, counts ? "2,3,4" : "1,2,3 or others",
                                counts ? ": the first column counts the points" : ""));
    }
    // In a row with a missing or an additional field, the coordinates are in other columns. If
    // columns are chosen and separated by blanks, any number of words may follow.
    void require_same_columns(const Row& row, char separator) {
        if (options_.columns && separator == ' ') return;
        if (expected_ == 0) {
            expect(count_columns(text_, separator));
            return;
        }
        const std::size_t n = row.count + ends_empty(text_, separator);
        if (n == expected_) return;
        lines_.fail(fmt::format("{}{} column{}, but line {} has {}; all rows must have the same",
                                n > expected_ ? "more than " : "", std::min(n, expected_),
                                std::min(n, expected_) == 1 ? "" : "s", expected_at_, expected_));
    }
    void expect(std::size_t columns) {
        expected_ = columns;
        expected_at_ = lines_.number();
        rows_.look_at(columns + 1);
    }

    const Source& source_;
    const ReadOptions& options_;
    LineReader lines_;
    Columns columns_;
    RowReader rows_;
    std::optional<TableFields> fields_;
    std::string_view text_;  // the text of the row
    bool has_row_ = false, are_atoms_ = false;
    // The separator; 0 before the first row or header line.
    char separator_ = 0;
    std::size_t expected_ = 0, expected_at_ = 0;  // the number of columns, and its line
    std::int64_t announced_ = -1;                 // the number of points that the file announces
    std::size_t announced_at_ = 0;
};

Mesh read_text(const Source& source, const ReadOptions& options) {
    if (source.bytes.substr(0, 2) == "\xff\xfe" || source.bytes.substr(0, 2) == "\xfe\xff") {
        source.fail("this is UTF-16 text; convert it with iconv -f UTF-16 -t UTF-8");
    }
    return TextReader(source, options).read();
}

void write_text(const std::vector<double>& points, OutputFile& out, const WriteOptions&) {
    write_points(points, {}, out);
}

void write_csv(const std::vector<double>& points, OutputFile& out, const WriteOptions&) {
    out.write("x,y,z\n");
    write_points(points, {{}, "", ","}, out);
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
