// SPDX-License-Identifier: MIT
#include "domain/mesh_check.hpp"

#include <algorithm>
#include <cmath>

#include "core/affine_basis.hpp"
#include "domain/embedding_check.hpp"
#include "platform/error.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

// The corners of a face in ascending order, and which face it is.
struct Triple {
    std::uint32_t v[3];
    std::uint32_t face;

    Triple(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t of)
        : v{a, b, c}, face(of) {
        std::sort(v, v + 3);
    }
    friend bool operator<(const Triple& a, const Triple& b) {
        return std::lexicographical_compare(a.v, a.v + 3, b.v, b.v + 3);
    }
};
static_assert(std::is_trivially_copyable_v<Triple>);

// An edge of the boundary of a facet, with the direction in which the boundary runs: 1 from a to b.
struct DirectedEdge {
    std::uint32_t facet, a, b;
    int direction;

    DirectedEdge(std::uint32_t of, std::uint32_t from, std::uint32_t to, int sign)
        : facet(of),
          a(std::min(from, to)),
          b(std::max(from, to)),
          direction(from < to ? sign : -sign) {}
    friend bool operator<(const DirectedEdge& e, const DirectedEdge& f) {
        return e.facet != f.facet ? e.facet < f.facet : e.a != f.a ? e.a < f.a : e.b < f.b;
    }
};

class MeshCheck {
  public:
    MeshCheck(const DomainInput& input, const DomainMesh& mesh, std::int32_t base,
              Allocator& allocator)
        : mesh_(mesh),
          allocator_(allocator),
          base_(base),
          input_(input),
          complex_(make_complex(input, allocator)),
          grid_(input.points, mesh.grid_bits),
          facets_(allocator),
          faces_(allocator) {}

    void run() {
        round();
        check_sizes();
        check_points();
        check_tetrahedra();
        check_faces();
        check_neighbors();
        if (is_flat()) return;
        check_facets();
        check_segments();
        check_places();
        check_embedding(complex_, mesh_, static_cast<std::int32_t>(base_), allocator_);
    }

  private:
    static constexpr std::uint32_t none = DomainMesh::none;

    long long number(std::size_t i) const { return static_cast<long long>(i) + base_; }
    const double* exact(std::uint32_t v) const {
        return mesh_.exact_points.begin() + 3 * std::size_t{v};
    }
    const double* point(std::uint32_t v) const { return mesh_.points.begin() + 3 * std::size_t{v}; }
    // The point that is returned for a distinct point of the complex.
    std::uint32_t index(std::uint32_t v) const { return complex_.point_of_number[v]; }

    void round() {
        for (double& x : complex_.boundary.points) x = grid_.round(x);
        facets_ = find_planar_facets(complex_.boundary, complex_.markers, allocator_);
    }

    void check_sizes() const {
        const std::size_t tetrahedra = mesh_.tetrahedron_count(), faces = mesh_.faces.size() / 3,
                          segments = mesh_.segments.size() / 2;
        if (mesh_.grid_bits < RoundingGrid::least_bits ||
            mesh_.grid_bits > RoundingGrid::most_bits || mesh_.tetrahedra.size() % 4 != 0 ||
            mesh_.neighbors.size() != 4 * tetrahedra || mesh_.regions.size() != tetrahedra ||
            mesh_.faces.size() % 3 != 0 || mesh_.face_tetrahedra.size() != 2 * faces ||
            mesh_.face_facets.size() != faces || mesh_.face_markers.size() != faces ||
            mesh_.segments.size() % 2 != 0 || mesh_.segment_sources.size() != segments ||
            mesh_.segment_markers.size() != segments ||
            mesh_.points.size() != mesh_.exact_points.size() ||
            mesh_.points.size() != input_.points.size() + 3 * mesh_.steiner_parameters.size() ||
            mesh_.steiner_edges.size() != 2 * mesh_.steiner_parameters.size())
            fail(MGDT_ERR_CHECK_FAILED, "the arrays of the mesh do not fit together");
    }

    // The caller's points are on the grid, and each Steiner point divides its segment.
    void check_points() const {
        const std::size_t given = input_.point_count();
        for (std::size_t i = 0; i < 3 * given; ++i) {
            if (mesh_.exact_points[i] != grid_.round(input_.points[i]))
                fail(MGDT_ERR_CHECK_FAILED, "point %lld is not where it was", number(i / 3));
            const double expected =
                mesh_.is_rounded ? grid_.unround(mesh_.exact_points[i]) : input_.points[i];
            if (mesh_.points[i] != expected)
                fail(MGDT_ERR_CHECK_FAILED, "point %lld has other coordinates", number(i / 3));
        }
        for (std::size_t i = 0; i < mesh_.steiner_parameters.size(); ++i) {
            const std::uint32_t* const ends = mesh_.steiner_edges.begin() + 2 * i;
            const double t = mesh_.steiner_parameters[i];
            const auto p = static_cast<std::uint32_t>(given + i);
            bool is_right = ends[0] < given && ends[1] < given && t > 0 && t < 1;
            if (is_right) {
                const DividedSegment divided(exact(ends[0]), exact(ends[1]));
                const double k = t * divided.parts();
                double x[3];
                divided.point(static_cast<std::uint32_t>(k), x);
                is_right = k == std::floor(k) && std::equal(x, x + 3, exact(p));
            }
            if (is_right) is_right = is_placed(p, ends, t);
            if (!is_right)
                fail(MGDT_ERR_CHECK_FAILED, "point %lld is not on its segment", number(p));
        }
    }

    // Whether a Steiner point is returned where it is on the grid, or between the caller's points.
    bool is_placed(std::uint32_t p, const std::uint32_t* ends, double t) const {
        double x[3];
        if (mesh_.is_rounded)
            for (int k = 0; k < 3; ++k) x[k] = grid_.unround(exact(p)[k]);
        else
            DomainMesh::place_on_segment(point(ends[0]), point(ends[1]), t, exact(p), grid_, x);
        return std::equal(x, x + 3, point(p));
    }

    void check_tetrahedra() const {
        const std::size_t points = mesh_.points.size() / 3;
        for (std::size_t t = 0; t < mesh_.tetrahedron_count(); ++t) {
            const std::uint32_t* const v = mesh_.tetrahedra.begin() + 4 * t;
            if (std::any_of(v, v + 4, [&](std::uint32_t p) { return p >= points; }))
                fail(MGDT_ERR_CHECK_FAILED, "tetrahedron %lld has a corner that is no point",
                     number(t));
            if (orientation(exact(v[0]), exact(v[1]), exact(v[2]), exact(v[3])) <= 0 ||
                orientation(point(v[0]), point(v[1]), point(v[2]), point(v[3])) <= 0)
                fail(MGDT_ERR_CHECK_FAILED, "tetrahedron %lld is not positive", number(t));
            if (mesh_.regions[t] >= mesh_.region_markers.size())
                fail(MGDT_ERR_CHECK_FAILED, "tetrahedron %lld is in no region", number(t));
        }
    }

    // Whether all points are in one plane. There are no tetrahedra then, and no faces.
    bool is_flat() const {
        AffineBasis basis;
        for (std::size_t i = 0; i < complex_.boundary.points.size(); i += 3)
            basis.add(complex_.boundary.points.begin() + i);
        return basis.dimension() < 3 && mesh_.tetrahedra.empty() && mesh_.faces.empty() &&
               mesh_.segments.empty();
    }

    // Each face is a face of the tetrahedra on its sides, and they are on the right sides.
    void check_faces() {
        const std::size_t points = mesh_.points.size() / 3;
        for (std::uint32_t f = 0; f < mesh_.face_facets.size(); ++f) {
            const std::uint32_t* const v = mesh_.faces.begin() + 3 * std::size_t{f};
            if (std::any_of(v, v + 3, [&](std::uint32_t p) { return p >= points; }) ||
                mesh_.face_facets[f] >= input_.facet_count() ||
                mesh_.face_markers[f] != input_.facet_markers[mesh_.face_facets[f]])
                fail(MGDT_ERR_CHECK_FAILED, "face %lld has a wrong corner, facet or marker",
                     number(f));
            faces_.push_back(Triple(v[0], v[1], v[2], f));
            for (int side = 0; side < 2; ++side) {
                const std::uint32_t t =
                    mesh_.face_tetrahedra[2 * std::size_t{f} + static_cast<std::size_t>(side)];
                if (t == none) continue;
                if (t >= mesh_.tetrahedron_count() || !is_on_side(v, t, side))
                    fail(MGDT_ERR_CHECK_FAILED, "face %lld is not a face of tetrahedron %lld",
                         number(f), number(t));
            }
        }
        std::sort(faces_.begin(), faces_.end());
        for (std::size_t i = 1; i < faces_.size(); ++i)
            if (!(faces_[i - 1] < faces_[i]))
                fail(MGDT_ERR_CHECK_FAILED, "face %lld is listed twice", number(faces_[i].face));
    }

    bool is_on_side(const std::uint32_t* face, std::uint32_t t, int side) const {
        const std::uint32_t* const v = mesh_.tetrahedra.begin() + 4 * std::size_t{t};
        std::uint32_t apex = none;
        for (int i = 0; i < 4; ++i) {
            if (std::find(face, face + 3, v[i]) != face + 3) continue;
            if (apex != none) return false;
            apex = v[i];
        }
        if (apex == none) return false;
        const int sign = orientation(exact(face[0]), exact(face[1]), exact(face[2]), exact(apex));
        return side == 0 ? sign > 0 : sign < 0;
    }

    // The listed face with these corners, or `none`.
    std::uint32_t listed(const Triple& face) const {
        const Triple* const found = std::lower_bound(faces_.begin(), faces_.end(), face);
        return found == faces_.end() || face < *found ? none : found->face;
    }

    void check_neighbors() const {
        std::size_t sides = 0, ends = 0;
        for (std::uint32_t t = 0; t < mesh_.tetrahedron_count(); ++t)
            for (unsigned i = 0; i < 4; ++i) {
                const std::uint32_t* const v = mesh_.tetrahedra.begin() + 4 * std::size_t{t};
                const unsigned char* const f = outer_face[i];
                const std::uint32_t face = listed(Triple(v[f[0]], v[f[1]], v[f[2]], 0));
                const std::uint32_t next = mesh_.neighbors[4 * std::size_t{t} + i];
                if (face != none) {
                    const std::uint32_t* const of =
                        mesh_.face_tetrahedra.begin() + 2 * std::size_t{face};
                    if (!(of[0] == t && of[1] == next) && !(of[1] == t && of[0] == next))
                        fail(MGDT_ERR_CHECK_FAILED, "face %lld has wrong tetrahedra", number(face));
                    ++sides;
                }
                if (next == none) {
                    if (face == none)
                        fail(MGDT_ERR_CHECK_FAILED,
                             "tetrahedron %lld has no neighbour at a face that is on no facet",
                             number(t));
                    continue;
                }
                check_neighbor(t, i, next, face != none);
            }
        for (const std::uint32_t t : mesh_.face_tetrahedra) ends += t != none ? 1 : 0;
        if (sides != ends)
            fail(MGDT_ERR_CHECK_FAILED, "%zu faces are at tetrahedra, %zu are listed", sides, ends);
    }

    void check_neighbor(std::uint32_t t, unsigned i, std::uint32_t next, bool is_facet) const {
        const std::uint32_t* const v = mesh_.tetrahedra.begin() + 4 * std::size_t{t};
        bool is_right = next < mesh_.tetrahedron_count();
        std::uint32_t apex = none;
        for (unsigned k = 0; k < 4 && is_right; ++k) {
            const std::uint32_t w = mesh_.tetrahedra[4 * std::size_t{next} + k];
            const std::uint32_t* const same = std::find(v, v + 4, w);
            if (same == v + 4 || same == v + i) {
                is_right = apex == none && same == v + 4 &&
                           mesh_.neighbors[4 * std::size_t{next} + k] == t;
                apex = w;
            }
        }
        if (!is_right || apex == none)
            fail(MGDT_ERR_CHECK_FAILED, "tetrahedra %lld and %lld are no neighbours", number(t),
                 number(next));
        if (is_facet) return;
        if (mesh_.regions[t] != mesh_.regions[next])
            fail(MGDT_ERR_CHECK_FAILED, "tetrahedra %lld and %lld are in different regions",
                 number(t), number(next));
        if (side_of_sphere_perturbed(exact(v[0]), exact(v[1]), exact(v[2]), exact(v[3]),
                                     exact(apex)) > 0)
            fail(MGDT_ERR_CHECK_FAILED, "point %lld is in the sphere of tetrahedron %lld",
                 number(apex), number(t));
    }

    // The triangles of each facet and its faces are in one plane and have the same boundary. A sum
    // of triangles in a plane is determined by its boundary, and no face counts negatively. So the
    // faces cover the facet, once.
    void check_facets() {
        Buffer<DirectedEdge> edges(allocator_);
        const Buffer<std::uint32_t>& triangles = complex_.boundary.triangles;
        Buffer<std::uint32_t> planar(allocator_);  // the planar facet of the caller's facets
        planar.resize(input_.facet_count(), none);
        for (const PlanarFacets::Facet& facet : facets_.facets) {
            std::uint32_t& of = planar[complex_.facet_of_triangle[facet.triangle]];
            if (of == none) of = facets_.of_triangle[facet.triangle];
        }
        for (std::uint32_t t = 0; t < facets_.of_triangle.size(); ++t) {
            const std::uint32_t* const v = triangles.begin() + 3 * std::size_t{t};
            const std::uint32_t corner[3] = {index(v[0]), index(v[1]), index(v[2])};
            const std::uint32_t f = representative(facets_.of_triangle[t], planar);
            const int sign = direction(f, corner);
            if (sign == 0) fail(MGDT_ERR_INTERNAL, "the triangles of a facet are not in one plane");
            for (int k = 0; k < 3; ++k) add_divided(f, corner[k], corner[(k + 1) % 3], sign, edges);
        }
        for (std::uint32_t i = 0; i < mesh_.face_facets.size(); ++i) {
            const std::uint32_t* const v = mesh_.faces.begin() + 3 * std::size_t{i};
            const std::uint32_t f = facet_of_face(i, planar);
            if (f == none) fail(MGDT_ERR_CHECK_FAILED, "face %lld is on no facet", number(i));
            for (int k = 0; k < 3; ++k) edges.push_back(DirectedEdge(f, v[k], v[(k + 1) % 3], -1));
        }
        std::sort(edges.begin(), edges.end());
        for (std::size_t i = 0; i < edges.size();) {
            const DirectedEdge& first = edges[i];
            int sum = 0;
            for (; i < edges.size() && !(first < edges[i]); ++i) sum += edges[i].direction;
            if (sum != 0)
                fail(MGDT_ERR_CHECK_FAILED, "facet %lld is not covered at points %lld and %lld",
                     number(complex_.facet_of_triangle[facets_.facets[first.facet].triangle]),
                     number(first.a), number(first.b));
        }
    }

    // The sign of a triangle in the plane of a planar facet relative to the facet's first triangle,
    // or 0 if it is in another plane.
    int direction(std::uint32_t facet, const std::uint32_t (&v)[3]) const {
        const std::uint32_t* const corner =
            complex_.boundary.triangles.begin() + 3 * std::size_t{facets_.facets[facet].triangle};
        const double *const a = exact(index(corner[0])), *const b = exact(index(corner[1])),
                            *const c = exact(index(corner[2]));
        for (const std::uint32_t p : v)
            if (orientation(a, b, c, exact(p)) != 0) return 0;
        // A point beside the plane: the corners and the facet's three have the same sign with it.
        double beside[3];
        for (int axis = 0; axis < 3; ++axis) {
            std::copy_n(a, 3, beside);
            beside[axis] += 1;
            const int side = orientation(a, b, c, beside);
            if (side != 0) return orientation(exact(v[0]), exact(v[1]), exact(v[2]), beside) * side;
        }
        return 0;
    }

    // The first planar facet in the plane of a planar facet that is of the same facet of the
    // caller's. The caller's segments may divide a facet, and its parts are checked together.
    std::uint32_t representative(std::uint32_t facet, const Buffer<std::uint32_t>& planar) const {
        const std::uint32_t triangle = facets_.facets[facet].triangle;
        const std::uint32_t* const v =
            complex_.boundary.triangles.begin() + 3 * std::size_t{triangle};
        const std::uint32_t corner[3] = {index(v[0]), index(v[1]), index(v[2])};
        for (std::uint32_t f = planar[complex_.facet_of_triangle[triangle]]; f < facet; ++f)
            if (direction(f, corner) > 0) return f;
        return facet;
    }

    // The planar facet with the caller's facet of a face, in the plane of the face; `none` if there
    // is none.
    std::uint32_t facet_of_face(std::uint32_t face, const Buffer<std::uint32_t>& planar) const {
        const std::uint32_t* const v = mesh_.faces.begin() + 3 * std::size_t{face};
        const std::uint32_t corner[3] = {v[0], v[1], v[2]};
        const std::uint32_t source = mesh_.face_facets[face];
        for (std::uint32_t f = planar[source]; f < facets_.facets.size(); ++f) {
            if (complex_.facet_of_triangle[facets_.facets[f].triangle] != source) break;
            if (direction(f, corner) > 0) return f;
        }
        return none;
    }

    // Adds the parts of an edge of a triangle.
    void add_divided(std::uint32_t facet, std::uint32_t a, std::uint32_t b, int sign,
                     Buffer<DirectedEdge>& edges) {
        const Chain chain = this->chain(a, b);
        std::uint32_t from = a;
        for (std::size_t i = 0; i < chain.size; ++i) {
            const std::uint32_t to =
                chain.is_reversed ? chain.first[chain.size - 1 - i].point : chain.first[i].point;
            edges.push_back(DirectedEdge(facet, from, to, sign));
            from = to;
        }
        edges.push_back(DirectedEdge(facet, from, b, sign));
    }

    // The Steiner points of a segment, sorted by their parameters.
    struct Place {
        std::uint32_t a, b;
        double t;
        std::uint32_t point;
        friend bool operator<(const Place& p, const Place& q) {
            return p.a != q.a ? p.a < q.a : p.b != q.b ? p.b < q.b : p.t < q.t;
        }
    };
    struct Chain {
        const Place* first;
        std::size_t size;
        bool is_reversed;
    };
    Chain chain(std::uint32_t a, std::uint32_t b) {
        if (places_.size() < mesh_.steiner_parameters.size()) {
            for (std::size_t i = 0; i < mesh_.steiner_parameters.size(); ++i)
                places_.push_back({mesh_.steiner_edges[2 * i], mesh_.steiner_edges[2 * i + 1],
                                   mesh_.steiner_parameters[i],
                                   static_cast<std::uint32_t>(input_.point_count() + i)});
            std::sort(places_.begin(), places_.end());
        }
        for (const bool is_reversed : {false, true}) {
            const std::uint32_t from = is_reversed ? b : a, to = is_reversed ? a : b;
            const Place* const first =
                std::lower_bound(places_.begin(), places_.end(), Place{from, to, 0, 0});
            const Place* const last =
                std::lower_bound(places_.begin(), places_.end(), Place{from, to, 2, 0});
            if (first != last) return {first, static_cast<std::size_t>(last - first), is_reversed};
        }
        return {nullptr, 0, false};
    }

    // A part of a segment, and the caller's segment that it is a part of, or `none`.
    struct Part {
        std::uint32_t a, b, source;
        friend bool operator<(const Part& p, const Part& q) {
            return p.a != q.a ? p.a < q.a : p.b != q.b ? p.b < q.b : p.source < q.source;
        }
    };
    static Part part(std::uint32_t a, std::uint32_t b, std::uint32_t source) {
        return {std::min(a, b), std::max(a, b), source};
    }

    // The parts of the segments are listed, and nothing else; every Steiner point is on a segment.
    void check_segments() {
        Buffer<Part> given(allocator_), expected(allocator_), found(allocator_);
        const Buffer<std::uint32_t>& ends = complex_.boundary.segments;
        for (std::uint32_t i = 0; i < ends.size() / 2; ++i)
            given.push_back(
                part(index(ends[2 * std::size_t{i}]), index(ends[2 * std::size_t{i} + 1]), i));
        std::sort(given.begin(), given.end());
        std::size_t steiner = 0;
        for (std::size_t s = 0; s < facets_.segments.size(); s += 2) {
            const std::uint32_t a = index(facets_.segments[s]), b = index(facets_.segments[s + 1]);
            const Part whole = part(a, b, 0);
            const Part* const of = std::lower_bound(given.begin(), given.end(), whole);
            const bool is_given = of != given.end() && of->a == whole.a && of->b == whole.b;
            const std::uint32_t source = is_given ? of->source : none;
            const Chain chain = this->chain(a, b);
            std::uint32_t from = chain.is_reversed ? b : a;
            for (std::size_t i = 0; i < chain.size; ++i) {
                expected.push_back(part(from, chain.first[i].point, source));
                from = chain.first[i].point;
            }
            expected.push_back(part(from, chain.is_reversed ? a : b, source));
            steiner += chain.size;
        }
        if (steiner != mesh_.steiner_parameters.size())
            fail(MGDT_ERR_CHECK_FAILED, "a Steiner point is on no segment");
        for (std::size_t s = 0; s < mesh_.segment_sources.size(); ++s) {
            const std::uint32_t source = mesh_.segment_sources[s];
            if (source != none && source >= input_.segment_count())
                fail(MGDT_ERR_CHECK_FAILED, "part %zu of segments is of no segment", s);
            if (mesh_.segment_markers[s] != (source == none ? 0 : input_.segment_markers[source]))
                fail(MGDT_ERR_CHECK_FAILED, "part %zu of segments has another marker", s);
            found.push_back(part(mesh_.segments[2 * s], mesh_.segments[2 * s + 1], source));
        }
        std::sort(expected.begin(), expected.end());
        std::sort(found.begin(), found.end());
        if (expected.size() != found.size())
            fail(MGDT_ERR_CHECK_FAILED, "there are %zu parts of segments, not %zu", found.size(),
                 expected.size());
        for (std::size_t i = 0; i < found.size(); ++i)
            if (expected[i] < found[i] || found[i] < expected[i])
                fail(MGDT_ERR_CHECK_FAILED, "points %lld and %lld are no part of a segment",
                     number(found[i].a), number(found[i].b));
    }

    // No hole is in a tetrahedron, and regions have the markers of the places in them.
    void check_places() const {
        Buffer<std::int32_t> markers(allocator_);
        markers.resize(mesh_.region_markers.size(), 0);
        for (const DomainInput::Place& hole : input_.holes)
            for_each_at(hole, [&](std::uint32_t t) {
                fail(MGDT_ERR_CHECK_FAILED, "tetrahedron %lld is in a hole", number(t));
            });
        for (const DomainInput::Place& region : input_.regions)
            for_each_at(region,
                        [&](std::uint32_t t) { markers[mesh_.regions[t]] = region.marker; });
        for (std::size_t r = 0; r < markers.size(); ++r)
            if (markers[r] != mesh_.region_markers[r])
                fail(MGDT_ERR_CHECK_FAILED, "region %lld has the marker %d, not %d", number(r),
                     static_cast<int>(mesh_.region_markers[r]), static_cast<int>(markers[r]));
    }

    // Calls f for each tetrahedron whose closure contains a place.
    template <class F>
    void for_each_at(const DomainInput::Place& place, F f) const {
        double x[3];
        if (!grid_.scale_place(place.x, x)) return;
        for (std::uint32_t t = 0; t < mesh_.tetrahedron_count(); ++t)
            if (mesh_.side(t, x) >= 0) f(t);
    }

    const DomainMesh& mesh_;
    Allocator& allocator_;
    std::int64_t base_;
    const DomainInput& input_;
    Complex complex_;
    RoundingGrid grid_;
    PlanarFacets facets_;
    Buffer<Triple> faces_;  // the listed faces, sorted
    Buffer<Place> places_{allocator_};
};

}  // namespace

void check_mesh(const DomainInput& input, const DomainMesh& mesh, std::int32_t index_base,
                Allocator& allocator) {
    MeshCheck(input, mesh, index_base, allocator).run();
}

}  // namespace mgdt
