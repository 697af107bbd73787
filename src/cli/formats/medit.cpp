// SPDX-License-Identifier: MIT
// INRIA's .mesh, the format of Medit, Mmg and FreeFem: keywords and numbers as text, with any line
// breaks. Vertices and tetrahedra are read, without their references. P.J. Frey, MEDIT, RT-0253,
// INRIA, 2001, section 7.
#include <fmt/core.h>

#include <limits>

#include "cli/formats/format.hpp"
#include "cli/formats/text_rows.hpp"
#include "cli/formats/words.hpp"

namespace mgdt::cli {
namespace {

constexpr std::string_view first_keyword = "MeshVersionFormatted";

bool is_keyword(std::string_view word) {
    return (word[0] >= 'A' && word[0] <= 'Z') || (word[0] >= 'a' && word[0] <= 'z');
}

bool is_cell(std::string_view keyword) {
    for (const std::string_view cell :
         {"Edges", "Triangles", "Quadrilaterals", "Hexahedra", "Prisms", "Pyramids"})
        if (keyword == cell) return true;
    return false;
}

bool sniff(std::string_view bytes) {
    return bytes.substr(0, first_keyword.size()) == first_keyword;
}

// Reads a reference as a marker.
std::int32_t marker_of(Words& words) {
    return static_cast<std::int32_t>(words.integer("reference",
                                                   std::numeric_limits<std::int32_t>::min(),
                                                   std::numeric_limits<std::int32_t>::max()));
}

// Reads triangles with their references as facets, or edges as segments.
void read_facets(Words& words, std::size_t corners, Mesh& mesh) {
    const std::size_t n = words.count("the number of cells", corners + 1);
    const auto last = static_cast<std::int64_t>(mesh.point_count());
    mesh.other_cells += n;
    for (std::size_t i = 0; i < n; ++i) {
        std::int64_t corner[3];
        for (std::size_t k = 0; k < corners; ++k) corner[k] = words.integer("vertex", 1, last) - 1;
        const std::int32_t marker = marker_of(words);
        if (corners == 3)
            mesh.facets.add_facet(corner, corners, marker);
        else
            mesh.facets.add_segment(corner);
    }
}

Mesh read_medit(const Source& source, const ReadOptions& options) {
    Words words{LineReader(source)};
    Mesh mesh;
    std::string_view word;
    if (!words.next(word) || word != first_keyword)
        source.fail_at_line(1,
                            "not a mesh of Medit's: it does not begin with MeshVersionFormatted");
    mesh.detail = fmt::format("version {}, text", words.integer("the version", 1, 4));
    bool has_vertices = false;
    for (;;) {
        if (!words.next(word)) words.fail("no End; the file is cut short");
        if (word == "End") break;
        if (word == "Dimension") {
            if (words.integer("the dimension", 2, 3) != 3) words.fail("dimension 2; 3 is needed");
        } else if (word == "Vertices") {
            if (has_vertices) words.fail("Vertices come twice");
            has_vertices = true;
            const std::size_t n = words.count("the number of vertices", 4);
            mesh.points.reserve(3 * n);
            for (std::size_t i = 0; i < n; ++i) {
                for (int k = 0; k < 3; ++k) mesh.points.push_back(words.number("coordinate"));
                words.number("the vertex's reference");
            }
        } else if (word == "Tetrahedra" || word == "TetrahedraP2") {
            if (!has_vertices) words.fail(fmt::format("{} before the Vertices", word));
            mesh.has_tetrahedra = true;
            const std::size_t nodes = word == "Tetrahedra" ? 4 : 10;
            const std::size_t n = words.count("the number of tetrahedra", nodes + 1);
            const auto last = static_cast<std::int64_t>(mesh.point_count());
            for (std::size_t i = 0; i < n; ++i) {
                for (std::size_t k = 0; k < nodes; ++k)
                    mesh.add_node(k, words.integer("vertex", 1, last) - 1);
                if (options.has_markers)
                    mesh.regions.push_back(marker_of(words));
                else
                    words.number("the tetrahedron's reference");
            }
        } else if (options.has_markers && has_vertices &&
                   (word == "Triangles" || word == "Edges")) {
            read_facets(words, word == "Triangles" ? 3 : 2, mesh);
        } else if (is_cell(word)) {
            mesh.other_cells += words.count("the number of cells", 1);
        } else if (is_keyword(word) || word[0] == '-' || word[0] == '+' || word[0] == '.' ||
                   (word[0] >= '0' && word[0] <= '9')) {
            continue;  // an unknown keyword, or one of its numbers
        } else {
            words.fail("neither a keyword nor a number");
        }
    }
    if (!has_vertices) source.fail("has no Vertices");
    return mesh;
}

// Each row ends with a reference.
constexpr RowStyle with_reference = {{}, "", " ", " 0\n"};

void write_vertices(const std::vector<double>& points, OutputFile& out) {
    out.write(
        fmt::format("MeshVersionFormatted 2\n\nDimension 3\n\nVertices\n{}\n", points.size() / 3));
    write_points(points, with_reference, out);
}

void write_points_alone(const std::vector<double>& points, OutputFile& out, const WriteOptions&) {
    write_vertices(points, out);
    out.write("\nEnd\n");
}

void write_mesh(const Mesh& mesh, const std::string& path, OutputSet& outputs,
                const WriteOptions&) {
    OutputFile& out = outputs.open(path);
    write_vertices(mesh.points, out);
    if (mesh.faces.size() > 0) {
        out.write(fmt::format("\nTriangles\n{}\n", mesh.faces.size()));
        write_marked_rows(mesh.faces.corners, 3, 1, mesh.faces.markers, {}, out);
    }
    out.write(fmt::format("\nTetrahedra\n{}\n", mesh.tetrahedron_count()));
    write_marked_rows(mesh.tetrahedra, 4, 1, mesh.regions, {}, out);
    out.write("\nEnd\n");
}

}  // namespace

const Format& medit_format() {
    static const Format format = {"medit",
                                  {".mesh"},
                                  "INRIA's mesh, text, for Medit and Mmg",
                                  false,
                                  sniff,
                                  read_medit,
                                  write_points_alone,
                                  write_mesh};
    return format;
}

}  // namespace mgdt::cli
