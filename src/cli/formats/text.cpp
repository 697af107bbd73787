// SPDX-License-Identifier: MIT
// Points as plain text, one a line: x y z, separated by blanks, tabs, commas or semicolons.
// Comments begin with #. One header line may come first: column names, or the number of points.
#include <fmt/format.h>

#include <algorithm>

#include "cli/errors.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/lines.hpp"
#include "cli/formats/number.hpp"

namespace mgdt::cli {
namespace {

bool mark(char c) {
    return c == ',' || c == ';';
}

// Splits a line; a separator is a run of blanks with at most one comma or semicolon in it, so an
// empty field between two commas stays a field. Fields after the first `most` are not looked at.
std::size_t split(std::string_view line, std::string_view* fields, std::size_t most) {
    std::size_t count = 0;
    std::size_t at = 0;
    const auto skip_blanks = [&] {
        while (at < line.size() && is_blank(line[at])) ++at;
    };
    skip_blanks();
    while (at < line.size() && count < most) {
        const std::size_t begin = at;
        while (at < line.size() && !is_blank(line[at]) && !mark(line[at])) ++at;
        fields[count++] = line.substr(begin, at - begin);
        skip_blanks();
        if (at < line.size() && mark(line[at])) {
            ++at;
            skip_blanks();
        }
    }
    return count;
}

Mesh read_text(const Source& source, const ReadOptions& options) {
    if (source.bytes.substr(0, 2) == "\xff\xfe" || source.bytes.substr(0, 2) == "\xfe\xff") {
        source.fail("this is UTF-16 text; convert it with iconv -f UTF-16 -t UTF-8");
    }
    const std::size_t bom = source.bytes.substr(0, 3) == "\xef\xbb\xbf" ? 3 : 0;
    const auto needed =
        static_cast<std::size_t>(*std::max_element(options.columns.begin(), options.columns.end()));
    std::vector<std::string_view> fields(std::max<std::size_t>(needed, 2));

    Mesh mesh;
    mesh.detail = "text";
    std::int64_t announced = -1;
    std::size_t announced_at = 0;
    bool first = true;
    LineReader lines(source, bom);
    while (lines.next_with_text()) {
        const std::size_t count = split(lines.text(), fields.data(), fields.size());
        double xyz[3];
        NumberStatus status[3];
        int numbers = 0;
        int present = 0;
        for (int k = 0; k < 3; ++k) {
            const auto column =
                static_cast<std::size_t>(options.columns[static_cast<std::size_t>(k)]);
            status[k] = NumberStatus::not_a_number;
            if (column > count) continue;
            ++present;
            status[k] = parse_number(fields[column - 1], xyz[k]);
            if (status[k] != NumberStatus::not_a_number) ++numbers;
        }
        if (first) {
            first = false;
            if (count == 1 && parse_integer(fields[0], announced) && announced >= 0) {
                announced_at = lines.number();
                continue;
            }
            announced = -1;
            if (numbers == 0 && present == 3) continue;  // column names
        }
        for (std::size_t k = 0; k < 3; ++k) {
            const auto column = static_cast<std::size_t>(options.columns[k]);
            if (column > count) {
                lines.fail(
                    fmt::format("{} column{}, but {} needs column {}; complete the line, or "
                                "choose columns with --columns",
                                count, count == 1 ? "" : "s", "xyz"[k], column));
            }
            if (status[k] != NumberStatus::ok) {
                lines.fail(fmt::format(
                    "column {}: {} {}{}", column, quote(fields[column - 1]), describe(status[k]),
                    status[k] == NumberStatus::not_a_number
                        ? "; correct the line, mark it as a comment with #, or choose columns with "
                          "--columns"
                        : ""));
            }
        }
        mesh.points.insert(mesh.points.end(), xyz, xyz + 3);
    }
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

}  // namespace

const Format& text_format() {
    static const Format format = {"xyz",
                                  {".xyz", ".txt", ".dat", ".pts", ".asc"},
                                  "text, x y z a line",
                                  false,
                                  nullptr,
                                  read_text,
                                  write_text,
                                  nullptr};
    return format;
}

const Format& csv_format() {
    static const Format format = {"csv",     {".csv", ".tsv"}, "text, x,y,z a line",
                                  false,     nullptr,          read_text,
                                  write_csv, nullptr};
    return format;
}

}  // namespace mgdt::cli
