// SPDX-License-Identifier: MIT
// Surfaces, of which the vertices and, if they are asked for, the facets are read: Wavefront's .obj
// (its lines v and f), Geomview's .off, and
// .stl in text or binary. An .stl file repeats the corners of each triangle; equal corners become
// one point, at the first of them. Surfaces are written as text, and .stl in binary.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <unordered_map>
#include <unordered_set>

#include "cli/errors.hpp"
#include "cli/formats/bytes.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/lines.hpp"
#include "cli/formats/number.hpp"
#include "cli/formats/text_rows.hpp"

namespace mgdt::cli {
namespace {

// The fields of a line of an .obj file. A backslash at its end joins the next line to it.
class JoinedFields {
  public:
    explicit JoinedFields(LineReader& lines) : lines_(lines), fields_(lines) {}

    bool next(std::string_view& field) {
        for (;;) {
            if (!fields_.next(field)) {
                if (!ends_with_backslash_ || !lines_.next()) return false;
                ends_with_backslash_ = false;
                fields_ = Fields(lines_);
                continue;
            }
            ends_with_backslash_ = field.back() == '\\';
            if (ends_with_backslash_) field.remove_suffix(1);
            if (!field.empty()) return true;
        }
    }
    double coordinate() {
        std::string_view field;
        if (!next(field)) lines_.fail("coordinate is missing");
        double value = 0;
        const NumberStatus status = parse_number(field, value);
        if (status != NumberStatus::ok)
            lines_.fail(fmt::format("coordinate: {} {}", quote(field), describe(status)));
        return value;
    }

  private:
    LineReader& lines_;
    Fields fields_;
    bool ends_with_backslash_ = false;
};

// A corner of a face: a vertex, counted from 1, or backwards from the last one if it is negative;
// texture and normal may follow after slashes.
std::int64_t obj_corner(const LineReader& lines, std::string_view word, std::size_t vertices) {
    word = word.substr(0, word.find('/'));
    std::int64_t number = 0;
    if (!parse_integer(word, number) || number == 0)
        lines.fail(fmt::format("{} is no vertex of a face", quote(word)));
    return number > 0 ? number - 1 : static_cast<std::int64_t>(vertices) + number;
}

Mesh read_obj(const Source& source, const ReadOptions& options) {
    Mesh mesh;
    mesh.detail = "text";
    LineReader lines(source);
    while (lines.next_with_text()) {
        JoinedFields fields(lines);
        std::string_view keyword;
        if (!fields.next(keyword)) continue;
        if (keyword == "f") {
            ++mesh.other_cells;
            std::string_view word;
            while (options.has_facets && fields.next(word))
                mesh.facets.corners.push_back(obj_corner(lines, word, mesh.point_count()));
            if (options.has_facets) mesh.facets.end_facet();
        }
        if (keyword != "v") continue;
        for (int k = 0; k < 3; ++k) mesh.points.push_back(fields.coordinate());
    }
    if (mesh.points.empty()) source.fail("has no vertices, which are lines that begin with v");
    return mesh;
}

// One line per face: the number of its corners, the corners, and perhaps a colour.
void read_off_faces(LineReader& lines, Mesh& mesh) {
    if (mesh.other_cells > (lines.bytes_left() + 1) / 4)
        lines.fail(fmt::format("{} faces announced, but only {} bytes follow", mesh.other_cells,
                               lines.bytes_left()));
    const auto last = static_cast<std::int64_t>(mesh.point_count()) - 1;
    for (std::size_t i = 0; i < mesh.other_cells; ++i) {
        if (!lines.next_with_text())
            lines.fail(fmt::format("the file ends after {} of {} faces", i, mesh.other_cells));
        Fields fields(lines);
        const std::int64_t n = fields.integer("the number of corners", 3, 0x7FFFFFFF);
        for (std::int64_t k = 0; k < n; ++k)
            mesh.facets.corners.push_back(fields.integer("corner", 0, last));
        mesh.facets.end_facet();
    }
}

bool sniff_off(std::string_view bytes) {
    return bytes.substr(0, 3) == "OFF" && bytes.find_first_of(" \t\r\n") == 3;
}

// Geomview's manual, "OFF files": the word OFF, preceded by letters for further data of the
// vertices; the numbers of vertices, faces and edges; then one line per vertex.
Mesh read_off(const Source& source, const ReadOptions& options) {
    Mesh mesh;
    mesh.detail = "text";
    LineReader lines(source);
    if (!lines.next_with_text()) source.fail_at_line(1, "the file is empty");
    Fields head(lines);
    const std::string_view keyword = head.word("OFF");
    const std::size_t off = keyword.find("OFF");
    if (off == std::string_view::npos || off + 3 != keyword.size())
        lines.fail("not an OFF file: it does not begin with OFF");
    if (keyword.find_first_of("4n") < off)
        lines.fail(fmt::format("{}; vertices of three coordinates are needed", quote(keyword)));
    std::string_view word;
    if (Fields(head).next(word) && word == "BINARY")
        lines.fail("binary OFF; write it as text, or as PLY");
    if (!Fields(head).next(word)) {
        if (!lines.next_with_text()) lines.fail("the file is cut short");
        head = Fields(lines);
    }
    constexpr std::int64_t most = std::int64_t{1} << 62;
    const std::int64_t n = head.integer("the number of vertices", 0, most);
    mesh.other_cells = static_cast<std::size_t>(head.integer("the number of faces", 0, most));
    if (static_cast<std::uint64_t>(n) > (lines.bytes_left() + 1) / 6)
        lines.fail(
            fmt::format("{} vertices announced, but only {} bytes follow; the file is cut "
                        "short or the count is wrong",
                        n, lines.bytes_left()));
    for (std::int64_t i = 0; i < n; ++i) {
        if (!lines.next_with_text())
            lines.fail(fmt::format("the file ends after {} of {} vertices", i, n));
        Fields fields(lines);
        for (int k = 0; k < 3; ++k) mesh.points.push_back(fields.number("coordinate"));
    }
    if (options.has_facets) read_off_faces(lines, mesh);
    return mesh;
}

using Corner = std::array<double, 3>;

struct HashOfCorner {
    std::size_t operator()(const Corner& c) const noexcept {
        std::uint64_t hash = 0;
        for (const double x : c) {
            std::uint64_t bits;
            std::memcpy(&bits, &x, sizeof bits);
            hash = (hash ^ bits) * 0x9E3779B97F4A7C15u;
            hash ^= hash >> 32;
        }
        return static_cast<std::size_t>(hash);
    }
};

// Collects distinct corners.
class Corners {
  public:
    Corners(Mesh& mesh, bool has_facets) : mesh_(mesh), has_facets_(has_facets) {}
    // Adds the corner of a triangle.
    void add(Corner c) {
        for (double& x : c) x += 0.0;  // turns -0 into 0
        const auto [at, is_new] = seen_.emplace(c, static_cast<std::int64_t>(mesh_.point_count()));
        if (is_new) mesh_.points.insert(mesh_.points.end(), c.begin(), c.end());
        if (!has_facets_) return;
        mesh_.facets.corners.push_back(at->second);
        if (mesh_.facets.corners.size() % 3 == 0) mesh_.facets.end_facet();
    }

  private:
    Mesh& mesh_;
    const bool has_facets_;
    std::unordered_map<Corner, std::int64_t, HashOfCorner> seen_;  // the point of each corner
};

constexpr std::size_t head_bytes = 84, triangle_bytes = 50;

Mesh read_stl(const Source& source, const ReadOptions& options) {
    Mesh mesh;
    Corners corners(mesh, options.has_facets);
    // Text begins with "solid", and so do some binary headers; the size of the file decides.
    if (source.bytes.size() >= head_bytes) {
        ByteReader bytes(source, head_bytes - 4, false);
        const std::uint64_t n = bytes.value<std::uint32_t>("the number of triangles");
        const bool is_whole = source.bytes.size() == head_bytes + n * triangle_bytes;
        if (is_whole || !is_same_but_for_case(source.bytes.substr(0, 5), "solid")) {
            mesh.detail = "binary";
            mesh.other_cells = static_cast<std::size_t>(n);
            bytes.need(n, triangle_bytes, "triangles");
            for (std::uint64_t i = 0; i < n; ++i) {
                bytes.skip(1, 12, "bytes of normal");
                for (int k = 0; k < 3; ++k) {
                    Corner c;
                    for (double& x : c) x = bytes.coordinate<float>();
                    corners.add(c);
                }
                bytes.skip(1, 2, "bytes of attributes");
            }
            return mesh;
        }
    }
    mesh.detail = "text";
    LineReader lines(source);
    if (!lines.next_with_text(no_comment) ||
        !is_same_but_for_case(Fields(lines).word("solid"), "solid"))
        source.fail_at_line(1, "not an STL file: neither solid nor a whole binary one");
    bool has_ended = false;
    while (lines.next_with_text(no_comment)) {
        Fields fields(lines);
        const std::string_view keyword = fields.word("a keyword");
        has_ended = is_same_but_for_case(keyword, "endsolid");
        if (is_same_but_for_case(keyword, "facet")) ++mesh.other_cells;
        if (!is_same_but_for_case(keyword, "vertex")) continue;
        Corner c;
        for (double& x : c) x = fields.number("coordinate");
        corners.add(c);
    }
    if (!has_ended) source.fail("has no endsolid; the file is cut short");
    if (mesh.facets.corners.size() % 3 != 0) source.fail("a facet does not have three vertices");
    return mesh;
}

// Writes a row for each triangle: `begin`, then its corners, counted from `base`.
void write_triangles(const Surface& surface, const char* begin, std::int64_t base,
                     OutputFile& out) {
    for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
        out.write(i % 3 == 0 ? begin : " ");
        out.write_integer(surface.triangles[i] + base);
        if (i % 3 == 2) out.write("\n");
    }
}

void write_obj(const Surface& surface, OutputFile& out, const WriteOptions&) {
    for (std::size_t i = 0; i < surface.points.size(); ++i) {
        out.write(i % 3 == 0 ? "v " : " ");
        out.write_number(surface.points[i]);
        if (i % 3 == 2) out.write("\n");
    }
    write_triangles(surface, "f ", 1, out);
}

void write_off(const Surface& surface, OutputFile& out, const WriteOptions&) {
    out.write(fmt::format("OFF\n{} {} 0\n", surface.point_count(), surface.triangle_count()));
    write_points(surface.points, {}, out);
    write_triangles(surface, "3 ", 0, out);
}

// STL has floats. Points that round to the same floats would join, and their triangles vanish.
std::vector<float> floats_of(const std::vector<double>& points) {
    std::vector<float> floats;
    floats.reserve(points.size());
    std::unordered_set<Corner, HashOfCorner> seen;
    for (std::size_t i = 0; i < points.size(); i += 3) {
        Corner c;
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = points[i + k];
            if (!(std::abs(x) <= std::numeric_limits<float>::max()))
                throw Error(exit_usage,
                            fmt::format("STL has floats, and {} is beyond them; write .ply", x));
            floats.push_back(static_cast<float>(x));
            c[k] = static_cast<double>(floats.back()) + 0.0;
        }
        if (!seen.insert(c).second)
            throw Error(exit_usage,
                        fmt::format("STL has floats, to which several points round, one of them "
                                    "({}, {}, {}); write .ply",
                                    points[i], points[i + 1], points[i + 2]));
    }
    return floats;
}

// The unit normal of a triangle, or zeros, from which readers compute it.
std::array<float, 3> normal_of(const double* a, const double* b, const double* c) {
    double u[3], v[3];
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        u[k] = b[k] - a[k];
        v[k] = c[k] - a[k];
        largest = std::max({largest, std::abs(u[k]), std::abs(v[k])});
    }
    if (!(largest > 0) || !std::isfinite(largest)) return {};
    for (std::size_t k = 0; k < 3; ++k) {
        u[k] /= largest;
        v[k] /= largest;
    }
    const double n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                         u[0] * v[1] - u[1] * v[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    if (!(length > 0)) return {};
    return {static_cast<float>(n[0] / length), static_cast<float>(n[1] / length),
            static_cast<float>(n[2] / length)};
}

void write_stl(const Surface& surface, OutputFile& out, const WriteOptions&) {
    const std::size_t n = surface.triangle_count();
    if (n > std::numeric_limits<std::uint32_t>::max())
        throw Error(exit_usage, fmt::format("STL cannot have {} triangles; write .ply", n));
    const std::vector<float> floats = floats_of(surface.points);
    std::string head = "triangles written by mgdt";  // does not begin with "solid"
    head.resize(head_bytes - 4, ' ');
    out.write(head);
    out.write_value(static_cast<std::uint32_t>(n));
    for (std::size_t i = 0; i < n; ++i) {
        const MeshIndex* corner = surface.triangles.data() + 3 * i;
        const auto at = [&](int k) {
            return surface.points.data() + 3 * static_cast<std::size_t>(corner[k]);
        };
        const std::array<float, 3> normal = normal_of(at(0), at(1), at(2));
        out.write_values(normal.data(), 3);
        for (int k = 0; k < 3; ++k)
            out.write_values(floats.data() + 3 * static_cast<std::size_t>(corner[k]), 3);
        out.write_value(std::uint16_t{0});
    }
}

}  // namespace

const Format& obj_format() {
    static const Format format = [] {
        Format f = {"obj",   {".obj"}, "Wavefront's OBJ; vertices and facets are read",
                    false,   nullptr,  read_obj,
                    nullptr, nullptr};
        f.write_surface = write_obj;
        f.has_facets = true;
        return f;
    }();
    return format;
}

const Format& off_format() {
    static const Format format = [] {
        Format f = {"off",   {".off"},  "Geomview's OFF, text; vertices and facets are read",
                    false,   sniff_off, read_off,
                    nullptr, nullptr};
        f.write_surface = write_off;
        f.has_facets = true;
        return f;
    }();
    return format;
}

const Format& stl_format() {
    static const Format format = [] {
        Format f = {"stl",   {".stl"}, "STL, text or binary; vertices and facets are read",
                    true,    nullptr,  read_stl,
                    nullptr, nullptr};
        f.write_surface = write_stl;
        f.has_facets = true;
        return f;
    }();
    return format;
}

}  // namespace mgdt::cli
