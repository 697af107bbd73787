// SPDX-License-Identifier: MIT
#include "solid/given_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/tetrahedron.hpp"
#include "parallel/disjoint_sets.hpp"
#include "platform/error.hpp"
#include "predicates/predicates.hpp"
#include "solid/pair_table.hpp"
#include "solid/sorted_corners.hpp"

namespace mgdt {
namespace {

class Linking {
  public:
    Linking(const GivenMesh& given, std::int32_t base, Team& team, Allocator& allocator,
            SolidMesh& out)
        : given_(given),
          base_(base),
          team_(team),
          allocator_(allocator),
          out_(out),
          sides_(allocator),
          faces_(allocator) {}

    void run(StageProgress& progress) {
        out_.points.copy(given_.points);
        out_.exact_points.copy(given_.points);
        out_.is_of_domain = false;
        out_.is_delaunay = false;
        const auto points = static_cast<std::uint32_t>(given_.points.size() / 3);
        for (std::uint32_t p = 0; p < points; ++p) out_.point_origins.push_back(p);
        progress.report(0);
        orient_tetrahedra();
        find_equal_tetrahedra();
        progress.report(0.3);
        number_regions();
        collect_sides();
        progress.report(0.6);
        link();
        add_given_faces();
        find_tetrahedra_of_faces();
        progress.report(0.8);
        write_faces();
        number_facets();
        progress.report(0.9);
        add_edges();
        list_unused_points();
    }

  private:
    // A tetrahedron at a face. `corners.from` is the code of the face, 4 t + i.
    using Side = SortedCorners<3>;
    // A face of the mesh: its corners in ascending order, the codes of its tetrahedra, and its
    // marker. The order of the corners is that of the caller, or faces out of the mesh.
    struct Face {
        SortedCorners<3> corners;  // `from` is the caller's face, or no_index
        std::uint32_t codes[2];    // first the one from which the corners are counter-clockwise
    };

    [[noreturn]] void refuse_tetrahedron(const char* what, std::uint32_t t) const {
        fail(MGDT_ERR_INVALID_ARGUMENT, "tetrahedron %lld %s", number(t), what);
    }
    long long number(std::size_t i) const { return static_cast<long long>(i) + base_; }
    const double* point(std::uint32_t v) const {
        return given_.points.begin() + 3 * std::size_t{v};
    }

    // Writes the tetrahedra, positively oriented.
    void orient_tetrahedra() {
        out_.tetrahedra.copy(given_.tetrahedra);
        for (std::uint32_t t = 0; t < count(); ++t) {
            std::uint32_t* const v = out_.tetrahedra.begin() + 4 * std::size_t{t};
            for (int i = 1; i < 4; ++i)
                if (std::find(v, v + i, v[i]) != v + i) refuse_tetrahedron("has a corner twice", t);
            const int sign = orientation(point(v[0]), point(v[1]), point(v[2]), point(v[3]));
            if (sign == 0) refuse_tetrahedron("is flat", t);
            if (sign < 0) std::swap(v[2], v[3]);
        }
    }
    std::uint32_t count() const { return static_cast<std::uint32_t>(out_.tetrahedron_count()); }

    void find_equal_tetrahedra() const {
        Buffer<SortedCorners<4>> sorted(allocator_);
        for (std::uint32_t t = 0; t < count(); ++t) {
            const std::uint32_t* const v = out_.tetrahedra.begin() + 4 * std::size_t{t};
            sorted.push_back({{v[0], v[1], v[2], v[3]}, t, false});
            sorted.back().sort();
        }
        sort_by_corners(team_, allocator_, sorted);
        for (std::size_t t = 1; t < sorted.size(); ++t)
            if (sorted[t].has_same_corners(sorted[t - 1]))
                fail(MGDT_ERR_INVALID_ARGUMENT, "tetrahedra %lld and %lld have the same corners",
                     number(std::min(sorted[t - 1].from, sorted[t].from)),
                     number(std::max(sorted[t - 1].from, sorted[t].from)));
    }

    // Regions are numbered in the order of their markers.
    void number_regions() {
        const bool has_markers = !given_.tetrahedron_markers.empty();
        for (const std::int32_t marker : given_.tetrahedron_markers)
            out_.region_markers.push_back(marker);
        if (!has_markers && count() > 0) out_.region_markers.push_back(0);
        std::int32_t* const begin = out_.region_markers.begin();
        std::sort(begin, out_.region_markers.end());
        out_.region_markers.resize(
            static_cast<std::size_t>(std::unique(begin, out_.region_markers.end()) - begin));
        for (std::uint32_t t = 0; t < count(); ++t) {
            const std::int32_t marker = has_markers ? given_.tetrahedron_markers[t] : 0;
            out_.regions.push_back(static_cast<std::uint32_t>(
                std::lower_bound(begin, out_.region_markers.end(), marker) - begin));
        }
    }

    void collect_sides() {
        for (std::uint32_t t = 0; t < count(); ++t)
            for (unsigned i = 0; i < 4; ++i) {
                const unsigned char* const f = outer_face[i];
                const std::uint32_t* const v = out_.tetrahedra.begin() + 4 * std::size_t{t};
                Side side = {{v[f[0]], v[f[1]], v[f[2]]}, 4 * t + i, false};
                side.sort();
                sides_.push_back(side);
            }
        sort_by_corners(team_, allocator_, sides_);
    }

    // Links tetrahedra at a common face, and collects the faces where the mesh or a region ends.
    void link() {
        out_.neighbors.resize(sides_.size(), no_index);
        for (std::size_t i = 0; i < sides_.size();) {
            std::size_t end = i + 1;
            while (end < sides_.size() && sides_[end].has_same_corners(sides_[i])) ++end;
            const Side &one = sides_[i], &other = sides_[end - 1];
            const std::uint32_t s = one.from / 4, t = other.from / 4;
            if (end - i > 2)
                fail(MGDT_ERR_INVALID_ARGUMENT, "tetrahedra %lld, %lld and %lld have a common face",
                     number(s), number(sides_[i + 1].from / 4), number(t));
            if (end - i == 2) {
                if (one.is_odd == other.is_odd)
                    fail(MGDT_ERR_INVALID_ARGUMENT,
                         "tetrahedra %lld and %lld are on the same side of their common face",
                         number(s), number(t));
                out_.neighbors[one.from] = t;
                out_.neighbors[other.from] = s;
            }
            if (end - i == 1 || out_.regions[s] != out_.regions[t])
                faces_.push_back({{{one.v[0], one.v[1], one.v[2]}, no_index, !one.is_odd},
                                  {no_index, no_index}});
            i = end;
        }
    }

    void add_given_faces() {
        for (std::uint32_t f = 0; f < given_.faces.size() / 3; ++f) {
            const std::uint32_t* const v = given_.faces.begin() + 3 * std::size_t{f};
            Face face = {{{v[0], v[1], v[2]}, f, false}, {no_index, no_index}};
            face.corners.sort();
            faces_.push_back(face);
        }
    }

    // Sorts the faces, of equal ones the caller's first, and finds their tetrahedra.
    void find_tetrahedra_of_faces() {
        std::sort(faces_.begin(), faces_.end(),
                  [](const Face& a, const Face& b) { return a.corners < b.corners; });
        std::size_t kept = 0;
        for (std::size_t f = 0; f < faces_.size(); ++f) {
            const Face& face = faces_[f];
            if (kept > 0 && face.corners.has_same_corners(faces_[kept - 1].corners)) {
                if (face.corners.from != no_index)
                    fail(MGDT_ERR_INVALID_ARGUMENT, "faces %lld and %lld have the same corners",
                         number(faces_[kept - 1].corners.from), number(face.corners.from));
                continue;
            }
            faces_[kept++] = face;
        }
        faces_.resize(kept);
        const Side* side = sides_.begin();
        for (Face& face : faces_) {
            while (side != sides_.end() && side->has_smaller_corners(face.corners)) ++side;
            if (side == sides_.end() || !side->has_same_corners(face.corners))
                fail(MGDT_ERR_INVALID_ARGUMENT, "face %lld is no face of a tetrahedron",
                     number(face.corners.from));
            for (const Side* s = side; s != sides_.end() && s->has_same_corners(face.corners); ++s)
                face.codes[s->is_odd == face.corners.is_odd ? 0 : 1] = s->from;
        }
    }

    // Writes the faces: the caller's as they were given, then the others.
    void write_faces() {
        std::sort(faces_.begin(), faces_.end(), [](const Face& a, const Face& b) {
            return a.corners.from != b.corners.from ? a.corners.from < b.corners.from
                                                    : a.corners < b.corners;
        });
        for (const Face& face : faces_) {
            const std::uint32_t from = face.corners.from;
            const std::uint32_t(&sorted)[3] = face.corners.v;
            const bool turns = face.corners.is_odd;
            for (unsigned k = 0; k < 3; ++k)
                out_.faces.push_back(from != no_index ? given_.faces[3 * std::size_t{from} + k]
                                                      : sorted[turns ? (3 - k) % 3 : k]);
            for (const std::uint32_t code : face.codes)
                out_.face_tetrahedra.push_back(code == no_index ? no_index : code / 4);
            out_.face_markers.push_back(
                from == no_index || given_.face_markers.empty() ? 0 : given_.face_markers[from]);
        }
    }

    // An edge of a face.
    struct FaceEdge {
        std::uint32_t a, b, face;

        bool has_ends_of(const FaceEdge& other) const { return a == other.a && b == other.b; }
        friend bool operator<(const FaceEdge& one, const FaceEdge& other) {
            if (one.a != other.a) return one.a < other.a;
            return one.b != other.b ? one.b < other.b : one.face < other.face;
        }
    };

    // Joins faces that continue each other to facets, and numbers the facets in the order of their
    // first faces. Writes the edges at which facets end.
    void number_facets() {
        PairTable kept(allocator_);
        for (std::size_t e = 0; e < given_.edges.size(); e += 2)
            kept.add(given_.edges[e], given_.edges[e + 1]);
        Buffer<FaceEdge> edges(allocator_);
        for (std::uint32_t f = 0; f < out_.face_markers.size(); ++f)
            for (unsigned k = 0; k < 3; ++k) {
                const std::uint32_t a = out_.faces[3 * std::size_t{f} + k],
                                    b = out_.faces[3 * std::size_t{f} + (k + 1) % 3];
                edges.push_back({std::min(a, b), std::max(a, b), f});
            }
        std::sort(edges.begin(), edges.end());
        DisjointSets facets(allocator_, out_.face_markers.size());
        for (std::size_t i = 0; i < edges.size();) {
            std::size_t end = i + 1;
            while (end < edges.size() && edges[end].has_ends_of(edges[i])) ++end;
            if (end - i == 2 && kept.find(edges[i].a, edges[i].b) == no_index &&
                continue_each_other(edges[i].face, edges[i + 1].face)) {
                facets.join(edges[i].face, edges[i + 1].face);
            } else {
                out_.edges.push_back(edges[i].a);
                out_.edges.push_back(edges[i].b);
            }
            i = end;
        }
        Buffer<std::uint32_t> numbers(allocator_);
        numbers.resize(out_.face_markers.size(), no_index);
        std::uint32_t count = 0;
        for (std::uint32_t f = 0; f < numbers.size(); ++f) {
            std::uint32_t& facet = numbers[facets.least(f)];
            if (facet == no_index) facet = count++;
            out_.face_facets.push_back(facet);
        }
        out_.planar_facets = count;
    }

    // Whether two faces with a common edge have one marker, the same regions on their sides, and
    // normals that differ by less than 2^-20, as in files with seven digits.
    bool continue_each_other(std::uint32_t f, std::uint32_t g) const {
        constexpr double angle = 0x1p-20;
        if (out_.face_markers[f] != out_.face_markers[g]) return false;
        double n[2][3];
        if (!find_normal(f, n[0]) || !find_normal(g, n[1])) return false;
        double same = 0, opposite = 0;
        for (int k = 0; k < 3; ++k) {
            same += (n[0][k] - n[1][k]) * (n[0][k] - n[1][k]);
            opposite += (n[0][k] + n[1][k]) * (n[0][k] + n[1][k]);
        }
        const auto region = [&](std::uint32_t face, std::size_t side) {
            const std::uint32_t t = out_.face_tetrahedra[2 * std::size_t{face} + side];
            return t == no_index ? no_index : out_.regions[t];
        };
        const bool turns = opposite < same;
        return std::min(same, opposite) < angle * angle &&
               region(f, 0) == region(g, turns ? 1 : 0) && region(f, 1) == region(g, turns ? 0 : 1);
    }

    // Finds the unit normal of a face. Returns false if it is lost in rounding.
    bool find_normal(std::uint32_t f, double (&n)[3]) const {
        const std::uint32_t* const v = out_.faces.begin() + 3 * std::size_t{f};
        const double *const a = point(v[0]), *const b = point(v[1]), *const c = point(v[2]);
        // Differences are divided by their largest magnitude, so that squares do not overflow.
        double u[3], w[3], size = 0;
        for (int k = 0; k < 3; ++k) {
            u[k] = b[k] / 2 - a[k] / 2;
            w[k] = c[k] / 2 - a[k] / 2;
            size = std::max({size, std::fabs(u[k]), std::fabs(w[k])});
        }
        double square = 0;
        for (int k = 0; k < 3; ++k) {
            const int l = (k + 1) % 3, m = (k + 2) % 3;
            n[k] = u[l] / size * (w[m] / size) - u[m] / size * (w[l] / size);
            square += n[k] * n[k];
        }
        for (double& c_ : n) c_ /= std::sqrt(square);
        return square > 0;
    }

    // Adds the caller's edges to those of facets: the caller's come first. Refuses an edge that is
    // not an edge of a tetrahedron.
    void add_edges() {
        PairTable edges(allocator_);
        for (std::size_t e = 0; e < out_.edges.size(); e += 2)
            edges.add(out_.edges[e], out_.edges[e + 1]);
        const std::size_t own = edges.size();
        Buffer<std::uint32_t> origin(allocator_);
        origin.resize(own, no_index);
        for (std::uint32_t e = 0; e < given_.edges.size() / 2; ++e) {
            const std::uint32_t* const ends = given_.edges.begin() + 2 * std::size_t{e};
            const std::uint32_t i = edges.add(ends[0], ends[1]);
            if (i == origin.size()) origin.push_back(no_index);
            if (origin[i] != no_index)
                fail(MGDT_ERR_INVALID_ARGUMENT, "edges %lld and %lld have the same ends",
                     number(origin[i]), number(e));
            origin[i] = e;
        }
        Buffer<std::uint8_t> is_found(allocator_);
        is_found.resize(edges.size(), 0);
        for (std::size_t t = 0; t < out_.tetrahedra.size() && edges.size() > own; t += 4)
            for (std::size_t i = 0; i < 4; ++i)
                for (std::size_t j = 0; j < i; ++j)
                    if (const std::uint32_t e =
                            edges.find(out_.tetrahedra[t + i], out_.tetrahedra[t + j]);
                        e != no_index)
                        is_found[e] = 1;
        Buffer<std::uint32_t> order(allocator_);
        for (std::uint32_t e = 0; e < edges.size(); ++e) {
            if (origin[e] != no_index && e >= own && is_found[e] == 0)
                fail(MGDT_ERR_INVALID_ARGUMENT, "edge %lld is no edge of a tetrahedron",
                     number(origin[e]));
            order.push_back(e);
        }
        std::sort(order.begin(), order.end(), [&](std::uint32_t one, std::uint32_t other) {
            return origin[one] != origin[other] ? origin[one] < origin[other]
                                                : edges.pair(one) < edges.pair(other);
        });
        out_.edges.clear();
        for (const std::uint32_t e : order) {
            const auto ends = edges.pair(e);
            out_.edges.push_back(origin[e] == no_index ? ends.first : given_.edges[2 * origin[e]]);
            out_.edges.push_back(origin[e] == no_index ? ends.second
                                                       : given_.edges[2 * origin[e] + 1]);
            out_.edge_segments.push_back(origin[e]);
            out_.edge_markers.push_back(origin[e] == no_index || given_.edge_markers.empty()
                                            ? 0
                                            : given_.edge_markers[origin[e]]);
        }
    }

    void list_unused_points() {
        Buffer<std::uint8_t> is_used(allocator_);
        is_used.resize(given_.points.size() / 3, 0);
        for (const std::uint32_t v : out_.tetrahedra) is_used[v] = 1;
        for (std::uint32_t p = 0; p < is_used.size(); ++p)
            if (is_used[p] == 0) out_.unused_points.push_back(p);
    }

    const GivenMesh& given_;
    const std::int64_t base_;
    Team& team_;
    Allocator& allocator_;
    SolidMesh& out_;
    Buffer<Side> sides_;  // all faces of tetrahedra, sorted
    Buffer<Face> faces_;  // those that the mesh lists
};

}  // namespace

void link_mesh(const GivenMesh& given, std::int32_t index_base, Team& team, Allocator& allocator,
               StageProgress& progress, SolidMesh& out) {
    Linking(given, index_base, team, allocator, out).run(progress);
}

}  // namespace mgdt
