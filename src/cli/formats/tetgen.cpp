// SPDX-License-Identifier: MIT
// TetGen's text files: NAME.node (points), NAME.ele (tetrahedra, with the markers of their regions
// as an attribute), NAME.neigh (neighbours) and NAME.face (triangles with markers; only written).
// Numbers begin with 0 or 1, as the first point's does. '#' begins a comment.
#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <limits>

#include "cli/errors.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/lines.hpp"
#include "cli/formats/number.hpp"
#include "cli/formats/tetgen_nodes.hpp"
#include "cli/formats/text_rows.hpp"
#include "cli/system.hpp"

namespace mgdt::cli {
namespace {

constexpr std::int64_t any = std::numeric_limits<std::int64_t>::max();

std::string with_ending(const std::string& path, const char* ending) {
    for (const Format* const format : {&tetgen_format(), &poly_format()})
        if (std::string stem = without_extension(path, *format); stem != path) return stem + ending;
    return path + ending;
}

// The path of the file that belongs to an .ele file; the compressed one if the plain one does not
// exist.
std::string beside(const Source& source, const char* ending) {
    std::string path = with_ending(source.path, ending);
    if (!system::status(path) && system::status(path + ".gz")) path += ".gz";
    return path;
}

// Goes to the first line with text. Throws if there is none.
void first_line(LineReader& lines) {
    if (!lines.next_with_text()) {
        lines.source().fail_at_line(1, "the file is empty; a line of counts is needed");
    }
}

// The next number of a line, or `otherwise` if there is none.
std::int64_t integer_or(std::int64_t otherwise, Fields& fields, const char* what) {
    std::string_view word;
    return Fields(fields).next(word) ? fields.integer(what) : otherwise;
}

// Throws if the rest of the file is too short for `count` lines of at least `columns` numbers.
void check_count(const LineReader& lines, std::int64_t count, std::size_t columns) {
    const std::size_t most = (lines.bytes_left() + 1) / (2 * columns);
    if (static_cast<std::uint64_t>(count) <= most) return;
    lines.fail(
        fmt::format("announces {} lines, but only {} bytes follow; the file is cut short or "
                    "the count is wrong",
                    count, lines.bytes_left()));
}

void next_line(LineReader& lines, std::int64_t i, std::int64_t count) {
    if (lines.next_with_text()) return;
    lines.fail(fmt::format("the file ends after {} of {} lines", i, count));
}

void expect_end(LineReader& lines, std::int64_t count) {
    if (lines.next_with_text()) {
        lines.fail(fmt::format("text after the {} lines announced; correct the count", count));
    }
}

void read_elements(const Source& source, std::int64_t base, bool has_markers, Mesh& mesh) {
    LineReader lines(source);
    first_line(lines);
    Fields head(lines);
    const std::int64_t count = head.integer("the number of tetrahedra", 0, any);
    const std::int64_t nodes = integer_or(4, head, "the number of nodes a tetrahedron");
    if (nodes != 4 && nodes != 10) {
        lines.fail(fmt::format("{} nodes a tetrahedron; 4 or 10 are possible", nodes));
    }
    const bool reads_markers = has_markers && integer_or(0, head, "the number of attributes") > 0;
    check_count(lines, count, 5);
    mesh.tetrahedra.reserve(4 * static_cast<std::size_t>(count));
    const auto last = static_cast<std::int64_t>(mesh.point_count()) + base - 1;
    for (std::int64_t i = 0; i < count; ++i) {
        next_line(lines, i, count);
        Fields fields(lines);
        fields.integer("the tetrahedron's number");
        for (std::int64_t k = 0; k < nodes; ++k)
            mesh.add_node(static_cast<std::size_t>(k), fields.integer("vertex", base, last) - base);
        if (!reads_markers) continue;
        // Attributes are numbers; the marker of a region is a whole one.
        const double marker = fields.number("the tetrahedron's attribute");
        if (!is_marker(marker))
            lines.fail(fmt::format("the attribute {} is no 32-bit integer", marker));
        mesh.regions.push_back(static_cast<std::int32_t>(marker));
    }
    expect_end(lines, count);
    mesh.has_tetrahedra = true;
}

void read_neighbors(const Source& source, std::int64_t base, Mesh& mesh) {
    LineReader lines(source);
    first_line(lines);
    const auto expected = static_cast<std::int64_t>(mesh.tetrahedron_count());
    const std::int64_t count = Fields(lines).integer("the number of tetrahedra", 0, any);
    if (count != expected) {
        lines.fail(fmt::format("{} tetrahedra, but the .ele file has {}", count, expected));
    }
    check_count(lines, count, 5);
    mesh.neighbors.reserve(4 * static_cast<std::size_t>(count));
    for (std::int64_t i = 0; i < count; ++i) {
        next_line(lines, i, count);
        Fields fields(lines);
        fields.integer("the tetrahedron's number");
        for (int k = 0; k < 4; ++k) {
            const std::int64_t n = fields.integer("neighbour", -1, count + base - 1);
            mesh.neighbors.push_back(n < base ? -1 : static_cast<MeshIndex>(n - base));
        }
    }
    expect_end(lines, count);
}

// A .node file has points only. With an .ele file, the .node file beside it is read, and the .neigh
// file if there is one.
Mesh read_tetgen(const Source& source, const ReadOptions& options) {
    Mesh mesh;
    if (has_ending(source.path, ".neigh")) source.fail("has no points; name the .ele file");
    if (!has_ending(source.path, ".ele")) {
        const std::int64_t base = read_nodes(source, mesh.points);
        mesh.detail = fmt::format("numbered from {}", base);
        mesh.first_number = static_cast<int>(base);
        return mesh;
    }
    const auto add_input = [&mesh](const InputFile& file) {
        if (file.identity()) mesh.inputs.push_back(*file.identity());
    };
    const InputFile nodes(beside(source, ".node"));
    add_input(nodes);
    const std::int64_t base = read_nodes(nodes.source(), mesh.points);
    read_elements(source, base, options.has_markers, mesh);
    mesh.first_number = static_cast<int>(base);
    mesh.detail = fmt::format("with {}, numbered from {}", nodes.source().name, base);
    const std::string neigh = beside(source, ".neigh");
    if (system::status(neigh)) {
        const InputFile file(neigh);
        add_input(file);
        read_neighbors(file.source(), base, mesh);
        mesh.detail += " and " + file.source().name;
    }
    return mesh;
}

void write_nodes(const std::vector<double>& points, OutputFile& out, const WriteOptions& options) {
    out.write(fmt::format("{} 3 0 0\n", points.size() / 3));
    write_points(points, {options.index_base, " "}, out);
}

void write_rows(const std::vector<MeshIndex>& values, const char* head, int base, OutputFile& out) {
    out.write(fmt::format("{} {}\n", values.size() / 4, head));
    write_rows_of_4(values, base, {base, " "}, out);
}

std::vector<std::string> mesh_files(const std::string& path) {
    if (path == "-") {
        throw Error(
            exit_usage,
            "TetGen's format is several files (.node, .ele, .neigh, .face); give -o a name");
    }
    return {with_ending(path, ".node"), with_ending(path, ".ele"), with_ending(path, ".neigh"),
            with_ending(path, ".face")};
}

void write_mesh(const Mesh& mesh, const std::string& path, OutputSet& outputs,
                const WriteOptions& options) {
    const std::vector<std::string> files = mesh_files(path);
    write_nodes(mesh.points, outputs.open(files[0]), options);
    const int base = options.index_base;
    OutputFile& elements = outputs.open(files[1]);
    if (!has_marker(mesh.regions)) {
        write_rows(mesh.tetrahedra, "4 0", base, elements);
    } else {
        elements.write(fmt::format("{} 4 1\n", mesh.tetrahedron_count()));
        write_marked_rows(mesh.tetrahedra, 4, base, mesh.regions, {base, " "}, elements);
    }
    if (mesh.faces.size() == 0) return;
    OutputFile& faces = outputs.open(files[3]);
    faces.write(fmt::format("{} 1\n", mesh.faces.size()));
    write_marked_rows(mesh.faces.corners, 3, base, mesh.faces.markers, {base, " "}, faces);
}

void write_neighbors(const std::vector<MeshIndex>& neighbors, const std::string& path,
                     OutputSet& outputs, const WriteOptions& options) {
    write_rows(neighbors, "4", options.index_base, outputs.open(mesh_files(path)[2]));
}

}  // namespace

std::int64_t read_node_rows(LineReader& lines, std::vector<double>& points) {
    Fields head(lines);
    const std::int64_t count = head.integer("the number of points", 0, any);
    const std::int64_t dimension = integer_or(3, head, "the dimension");
    if (dimension != 3) lines.fail(fmt::format("dimension {}; 3 is needed", dimension));
    check_count(lines, count, 4);
    points.reserve(3 * static_cast<std::size_t>(count));
    std::int64_t base = 0;
    for (std::int64_t i = 0; i < count; ++i) {
        next_line(lines, i, count);
        Fields fields(lines);
        const std::int64_t number = fields.integer("the point's number");
        if (i == 0) {
            if (number != 0 && number != 1) {
                lines.fail(fmt::format("the first point has number {}; it must be 0 or 1", number));
            }
            base = number;
        } else if (number != i + base) {
            lines.fail(fmt::format("point number {}; {} is next", number, i + base));
        }
        for (int k = 0; k < 3; ++k) points.push_back(fields.number("coordinate"));
    }
    return base;
}

std::int64_t read_nodes(const Source& source, std::vector<double>& points) {
    LineReader lines(source);
    first_line(lines);
    const std::int64_t base = read_node_rows(lines, points);
    expect_end(lines, static_cast<std::int64_t>(points.size() / 3));
    return base;
}

std::string beside_node_file(const Source& source) {
    return beside(source, ".node");
}

const Format& tetgen_format() {
    static const Format format = {"tetgen",
                                  {".node", ".ele", ".neigh"},
                                  "TetGen .node, .ele and .neigh",
                                  false,
                                  nullptr,
                                  read_tetgen,
                                  write_nodes,
                                  write_mesh,
                                  mesh_files,
                                  nullptr,
                                  nullptr,
                                  write_neighbors};
    return format;
}

}  // namespace mgdt::cli
