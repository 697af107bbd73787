// SPDX-License-Identifier: MIT
// The vertices of surfaces of triangles: Wavefront's .obj (its lines v), and .stl of either kind,
// where each triangle has its corners, so that equal ones become one point, the first of them.
#include <fmt/format.h>

#include <array>
#include <cstring>
#include <unordered_set>

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

// Collects corners, each once.
class Corners {
  public:
    explicit Corners(Mesh& mesh) : mesh_(mesh) {}
    void add(Corner c) {
        for (double& x : c) x += 0.0;  // no -0
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
    // Text begins with "solid", and so do the heads of some binary files: their size decides.
    if (source.bytes.size() >= head_bytes) {
        ByteReader bytes(source, head_bytes - 4, false);
        const std::uint64_t n = bytes.value<std::uint32_t>("the number of triangles");
        const bool is_whole = source.bytes.size() == head_bytes + n * triangle_bytes;
        if (is_whole || source.bytes.substr(0, 5) != "solid") {
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
    if (!lines.next_with_text(no_comment) || Fields(lines).word("solid") != "solid")
        source.fail_at_line(1, "not an STL file: neither solid nor a whole binary one");
    bool has_ended = false;
    while (lines.next_with_text(no_comment)) {
        Fields fields(lines);
        const std::string_view keyword = fields.word("a keyword");
        has_ended = keyword == "endsolid";
        if (keyword == "facet") ++mesh.other_cells;
        if (keyword != "vertex") continue;
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

const Format& stl_format() {
    static const Format format = {"stl",   {".stl"}, "vertices of STL, text or binary",
                                  true,    nullptr,  read_stl,
                                  nullptr, nullptr};
    return format;
}

}  // namespace mgdt::cli
