// SPDX-License-Identifier: MIT
// The vertices of surfaces: Wavefront's .obj (its lines v), Geomview's .off, and .stl in text or
// binary. An .stl file repeats the corners of each triangle; equal corners become one point, at the
// first of them.
#include <fmt/core.h>

#include <array>
#include <cstring>
#include <unordered_set>

#include "cli/errors.hpp"
#include "cli/formats/bytes.hpp"
#include "cli/formats/format.hpp"
#include "cli/formats/lines.hpp"

namespace mgdt::cli {
namespace {

Mesh read_obj(const Source& source, const ReadOptions&) {
    Mesh mesh;
    mesh.detail = "text";
    LineReader lines(source);
    while (lines.next_with_text()) {
        Fields fields(lines);
        const std::string_view keyword = fields.word("a keyword");
        if (keyword == "f") ++mesh.other_cells;
        if (keyword != "v") continue;
        for (int k = 0; k < 3; ++k) mesh.points.push_back(fields.number("coordinate"));
    }
    if (mesh.points.empty()) source.fail("has no vertices, which are lines that begin with v");
    return mesh;
}

bool sniff_off(std::string_view bytes) {
    return bytes.substr(0, 3) == "OFF" && bytes.find_first_of(" \t\r\n") == 3;
}

// Geomview's manual, "OFF files": the word OFF, preceded by letters for further data of the
// vertices; the numbers of vertices, faces and edges; then one line per vertex.
Mesh read_off(const Source& source, const ReadOptions&) {
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
    explicit Corners(Mesh& mesh) : mesh_(mesh) {}
    void add(Corner c) {
        for (double& x : c) x += 0.0;  // turns -0 into 0
        if (seen_.insert(c).second) mesh_.points.insert(mesh_.points.end(), c.begin(), c.end());
    }

  private:
    Mesh& mesh_;
    std::unordered_set<Corner, HashOfCorner> seen_;
};

constexpr std::size_t head_bytes = 84, triangle_bytes = 50;

Mesh read_stl(const Source& source, const ReadOptions&) {
    Mesh mesh;
    Corners corners(mesh);
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
    return mesh;
}

}  // namespace

const Format& obj_format() {
    static const Format format = {
        "obj", {".obj"}, "vertices of Wavefront's OBJ", false, nullptr, read_obj, nullptr, nullptr};
    return format;
}

const Format& off_format() {
    static const Format format = {"off",   {".off"},  "vertices of Geomview's OFF, text",
                                  false,   sniff_off, read_off,
                                  nullptr, nullptr};
    return format;
}

const Format& stl_format() {
    static const Format format = {"stl",   {".stl"}, "vertices of STL, text or binary",
                                  true,    nullptr,  read_stl,
                                  nullptr, nullptr};
    return format;
}

}  // namespace mgdt::cli
