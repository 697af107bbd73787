// SPDX-License-Identifier: MIT
// VTK's legacy files, .vtk, text: the points and the tetrahedra of an unstructured grid, and the
// points of other datasets that list them. The VTK User's Guide, "VTK File Formats".
#include <fmt/format.h>

#include <algorithm>

#include "cli/errors.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/grid.hpp"
#include "cli/formats/number.hpp"
#include "cli/formats/words.hpp"

namespace mgdt::cli {
namespace {

constexpr std::string_view magic = "# vtk DataFile Version ";

// Of the linear types; 0: any number, or not known.
std::size_t corners_of(std::int64_t type) {
    constexpr std::size_t corners[] = {0, 1, 0, 2, 0, 3, 0, 0, 4, 4, 4, 8, 8, 6, 5};
    return type < 15 ? corners[type] : type == vtk_quadratic_tetra ? 10 : 0;
}

// VTK reads keywords in any case.
bool same(std::string_view word, std::string_view capitals) {
    const auto is_same = [](char c, char capital) {
        return c == capital || (c >= 'a' && c <= 'z' && c - 'a' + 'A' == capital);
    };
    return std::equal(word.begin(), word.end(), capitals.begin(), capitals.end(), is_same);
}

bool sniff(std::string_view bytes) {
    return bytes.substr(0, magic.size()) == magic;
}

// Where the dataset begins: after the first line, a title and the encoding.
LineReader after_head(const Source& source, Mesh& mesh) {
    LineReader lines(source);
    if (!lines.next() || !sniff(lines.text()))
        source.fail_at_line(1, "not a VTK file: it does not begin with # vtk DataFile Version");
    const std::string_view version = lines.text().substr(magic.size());
    double number = 0;
    if (parse_number(version, number) != NumberStatus::ok || !(number >= 1 && number < 5))
        lines.fail(
            fmt::format("version {}; up to 4.2 can be read; write it as .vtu, or as an "
                        "older version",
                        quote(version)));
    if (!lines.next() || !lines.next()) lines.fail("the file is cut short");
    const std::string_view encoding = Fields(lines).word("the encoding");
    if (!same(encoding, "ASCII"))
        lines.fail(fmt::format("encoding {}; ASCII can be read; write it as text, or as .vtu",
                               quote(encoding)));
    mesh.detail = fmt::format("version {}, text", version);
    return lines;
}

void take_tetrahedra(const std::vector<std::int64_t>& cells, const std::vector<std::size_t>& begin,
                     Words& words, Mesh& mesh) {
    const std::size_t n = words.count("the number of cell types", 1);
    if (n != begin.size()) words.fail(fmt::format("{} types of {} cells", n, begin.size()));
    mesh.has_tetrahedra = true;
    for (std::size_t i = 0; i < n; ++i) {
        const std::int64_t type = words.integer("the cell's type", 0, 1000);
        const std::size_t end = i + 1 < n ? begin[i + 1] : cells.size();
        const std::size_t corners = end - begin[i];
        if (corners_of(type) != 0 && corners != corners_of(type))
            words.fail(fmt::format("a cell of type {} with {} points", type, corners));
        if (type != vtk_tetra && type != vtk_quadratic_tetra) {
            ++mesh.other_cells;
            continue;
        }
        for (std::size_t k = 0; k < 4; ++k) mesh.tetrahedra.push_back(cells[begin[i] + k]);
    }
}

Mesh read_vtk(const Source& source, const ReadOptions&) {
    Mesh mesh;
    Words words(after_head(source, mesh), no_comment);
    std::vector<std::int64_t> cells;
    std::vector<std::size_t> begin;  // of each cell among them
    bool has_points = false, has_types = false, is_grid = false;
    std::string_view word;
    while (words.next(word) && !same(word, "POINT_DATA") && !same(word, "CELL_DATA")) {
        if (same(word, "DATASET")) {
            is_grid = words.next(word) && same(word, "UNSTRUCTURED_GRID");
        } else if (same(word, "POINTS")) {
            if (has_points) words.fail("POINTS come twice");
            has_points = true;
            const std::size_t n = words.count("the number of points", 3);
            words.next(word);  // the type
            mesh.points.resize(3 * n);
            for (double& x : mesh.points) x = words.number("coordinate");
        } else if (same(word, "CELLS")) {
            if (!begin.empty() || has_types) words.fail("CELLS come twice, or after their types");
            const std::size_t n = words.count("the number of cells", 2);
            words.count("the size of the list of cells", 1);
            const auto last = static_cast<std::int64_t>(mesh.point_count()) - 1;
            for (std::size_t i = 0; i < n; ++i) {
                begin.push_back(cells.size());
                const std::size_t corners = words.count("the number of a cell's points", 1);
                for (std::size_t k = 0; k < corners; ++k)
                    cells.push_back(words.integer("point", 0, last));
            }
        } else if (same(word, "CELL_TYPES")) {
            if (has_types) words.fail("CELL_TYPES come twice");
            has_types = true;
            take_tetrahedra(cells, begin, words, mesh);
        }
    }
    if (!has_points) source.fail("has no POINTS");
    if ((is_grid || !begin.empty()) && !has_types)
        source.fail("has no CELL_TYPES; the file is cut short");
    return mesh;
}

void write_mesh(const Mesh& mesh, const std::string& path, OutputSet& outputs,
                const WriteOptions&) {
    OutputFile& out = outputs.open(path);
    out.write(fmt::format("{}3.0\nmgdt\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {} double\n",
                          magic, mesh.point_count()));
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        out.write_number(mesh.points[i]);
        out.write(i % 3 < 2 ? " " : "\n");
    }
    const std::size_t n = mesh.tetrahedron_count();
    out.write(fmt::format("CELLS {} {}\n", n, 5 * n));
    for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) {
        if (i % 4 == 0) out.write("4");
        out.write(" ");
        out.write_integer(mesh.tetrahedra[i]);
        if (i % 4 == 3) out.write("\n");
    }
    out.write(fmt::format("CELL_TYPES {}\n", n));
    for (std::size_t i = 0; i < n; ++i) out.write("10\n");
}

}  // namespace

const Format& vtk_format() {
    static const Format format = {
        "vtk", {".vtk"}, "VTK's legacy files, text", false, sniff, read_vtk, nullptr, write_mesh};
    return format;
}

}  // namespace mgdt::cli
