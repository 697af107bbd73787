// SPDX-License-Identifier: MIT
#include "domain/mesh_comparison.hpp"

#include <algorithm>
#include <cmath>

#include "boundary/planar_facets.hpp"
#include "core/affine_basis.hpp"
#include "platform/error.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

// An edge of the boundary of a facet. `direction` is 1 if the boundary runs from a to b, and -1 if
// it runs from b to a.
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

class MeshComparison {
  public:
    MeshComparison(const DomainInput& input, const SolidMesh& mesh, std::int32_t base,
                   Allocator& allocator, StageProgress& progress)
        : mesh_(mesh),
          allocator_(allocator),
          base_(base),
          input_(input),
          complex_(make_complex(input, allocator)),
          grid_(input.points, mesh.grid.bits()),
          facets_(allocator),
          progress_(progress) {}

    void run() {
        for (double& x : complex_.boundary.points) x = grid_.round(x);
        progress_.enter(0, 0.2);
        facets_ = find_planar_facets(complex_.boundary, complex_.markers, allocator_);
        if (mesh_.keeps_facets) check_kept_facets();
        check_points();
        check_sources();
        if (is_flat()) return;
        progress_.enter(0.2, 0.7);
        check_facets();
        progress_.enter(0.7, 0.8);
        check_segments();
        progress_.enter(0.8, 1);
        check_places();
    }

  private:
    static constexpr std::int64_t no_marker = std::int64_t{1} << 40;

    long long number(std::size_t i) const { return static_cast<long long>(i) + base_; }
    const double* exact(std::uint32_t v) const {
        return mesh_.exact_points.begin() + 3 * std::size_t{v};
    }
    // The point of the mesh for a distinct point of the complex.
    std::uint32_t index(std::uint32_t v) const { return complex_.point_of_number[v]; }

    // Checks that the caller's points come first and are unchanged, and that equal points have the
    // first of them as their origin.
    void check_points() const {
        const std::size_t given = input_.point_count();
        if (mesh_.points.size() != input_.points.size() + 3 * mesh_.steiner_parameters.size())
            fail(MGDT_ERR_CHECK_FAILED, "the mesh has %zu points besides Steiner points, not %zu",
                 mesh_.points.size() / 3 - mesh_.steiner_parameters.size(), given);
        for (std::size_t i = 0; i < 3 * given; ++i) {
            if (mesh_.exact_points[i] != grid_.round(input_.points[i]))
                fail(MGDT_ERR_CHECK_FAILED, "point %lld is not where it was", number(i / 3));
            const double expected =
                mesh_.is_rounded ? grid_.unround(mesh_.exact_points[i]) : input_.points[i];
            if (mesh_.points[i] != expected)
                fail(MGDT_ERR_CHECK_FAILED, "point %lld has other coordinates", number(i / 3));
        }
        for (std::size_t i = 0; i < given; ++i)
            if (mesh_.point_origins[i] != index(complex_.number_of_point[i]))
                fail(MGDT_ERR_CHECK_FAILED, "point %lld has a wrong origin", number(i));
    }

    // The markers of facets or segments by the numbers by which the caller knows them. A number of
    // none has the marker `no_marker`.
    template <class OriginOf>
    Buffer<std::int64_t> markers_by_origin(const Buffer<std::int32_t>& markers,
                                           const OriginOf& origin_of) const {
        Buffer<std::int64_t> result(allocator_);
        for (std::uint32_t i = 0; i < markers.size(); ++i) {
            const std::size_t origin = origin_of(i);
            if (origin >= result.size()) result.resize(origin + 1, no_marker);
            result[origin] = markers[i];
        }
        return result;
    }

    // Checks that the facets and segments that faces and edges name exist, and that markers agree.
    void check_sources() const {
        const Buffer<std::int64_t> of_facets = markers_by_origin(
            input_.facet_markers, [&](std::uint32_t f) { return input_.facet_origin(f); });
        const Buffer<std::int64_t> of_segments = markers_by_origin(
            input_.segment_markers, [&](std::uint32_t s) { return input_.segment_origin(s); });
        for (std::size_t f = 0; f < mesh_.face_facets.size(); ++f)
            if (mesh_.face_facets[f] >= of_facets.size() ||
                mesh_.face_markers[f] != of_facets[mesh_.face_facets[f]])
                fail(MGDT_ERR_CHECK_FAILED, "face %lld has a wrong facet or marker", number(f));
        for (std::size_t e = 0; e < mesh_.edge_segments.size(); ++e) {
            const std::uint32_t segment = mesh_.edge_segments[e];
            if (segment != no_index &&
                (segment >= of_segments.size() || of_segments[segment] == no_marker))
                fail(MGDT_ERR_CHECK_FAILED, "edge %lld is of no segment", number(e));
            if (mesh_.edge_markers[e] != (segment == no_index ? 0 : of_segments[segment]))
                fail(MGDT_ERR_CHECK_FAILED, "edge %lld has another marker", number(e));
        }
    }

    // Whether all points are in one plane and the mesh is empty.
    bool is_flat() const {
        AffineBasis basis;
        for (std::size_t i = 0; i < complex_.boundary.points.size(); i += 3)
            basis.add(complex_.boundary.points.begin() + i);
        return basis.dimension() < 3 && mesh_.tetrahedra.empty() && mesh_.faces.empty() &&
               mesh_.edges.empty();
    }

    // Checks that the faces of each facet cover it exactly once. The triangles and the faces of a
    // facet are in one plane. A sum of oriented triangles in a plane is determined by its boundary.
    // So it suffices that triangles and faces have the same boundary, because no face counts
    // negatively.
    void check_facets() {
        Buffer<DirectedEdge> edges(allocator_);
        const Buffer<std::uint32_t>& triangles = complex_.boundary.triangles;
        Buffer<std::uint32_t> planar(allocator_);  // the planar facet of the caller's facets
        for (const PlanarFacets::Facet& facet : facets_.facets) {
            const std::size_t source = complex_.facet_of_triangle[facet.triangle];
            if (source >= planar.size()) planar.resize(source + 1, no_index);
            std::uint32_t& of = planar[complex_.facet_of_triangle[facet.triangle]];
            if (of == no_index) of = facets_.of_triangle[facet.triangle];
        }
        for (std::uint32_t t = 0; t < facets_.of_triangle.size(); ++t) {
            const std::uint32_t* const v = triangles.begin() + 3 * std::size_t{t};
            const std::uint32_t corner[3] = {index(v[0]), index(v[1]), index(v[2])};
            progress_.step(t, 0, facets_.of_triangle.size());
            const std::uint32_t f = representative(facets_.of_triangle[t], planar);
            const int sign = direction(f, corner);
            if (sign == 0) fail(MGDT_ERR_INTERNAL, "the triangles of a facet are not in one plane");
            for (int k = 0; k < 3; ++k) add_divided(f, corner[k], corner[(k + 1) % 3], sign, edges);
        }
        for (std::uint32_t i = 0; i < mesh_.face_facets.size(); ++i) {
            const std::uint32_t* const v = mesh_.faces.begin() + 3 * std::size_t{i};
            progress_.stop_request().poll_in_step(i);
            const std::uint32_t f = facet_of_face(i, planar);
            if (f == no_index) fail(MGDT_ERR_CHECK_FAILED, "face %lld is on no facet", number(i));
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

    // Checks that there are as many faces as triangles of facets. check_facets() shows that faces
    // cover each facet. A polygon cannot be covered by fewer triangles than those into which it is
    // divided, so each facet then has that number of faces, and a triangle is one face.
    void check_kept_facets() {
        const std::size_t faces = mesh_.face_facets.size(), triangles = facets_.of_triangle.size();
        if (faces != triangles)
            fail(MGDT_ERR_CHECK_FAILED, "facets have %zu triangles, and the mesh has %zu faces",
                 triangles, faces);
        separate_facets(complex_.boundary, facets_);
    }

    // The orientation of a triangle in the plane of a planar facet, relative to the first triangle
    // of the facet; 0 if the triangle is in another plane.
    int direction(std::uint32_t facet, const std::uint32_t (&v)[3]) const {
        const std::uint32_t* const corner =
            complex_.boundary.triangles.begin() + 3 * std::size_t{facets_.facets[facet].triangle};
        const double *const a = exact(index(corner[0])), *const b = exact(index(corner[1])),
                            *const c = exact(index(corner[2]));
        for (const std::uint32_t p : v)
            if (orientation(a, b, c, exact(p)) != 0) return 0;
        // Orientations are compared by a point beside the plane.
        double beside[3];
        for (int axis = 0; axis < 3; ++axis) {
            std::copy_n(a, 3, beside);
            beside[axis] = a[axis] == 0 ? 1 : std::nextafter(a[axis], 0);
            const int side = orientation(a, b, c, beside);
            if (side != 0) return orientation(exact(v[0]), exact(v[1]), exact(v[2]), beside) * side;
        }
        return 0;
    }

    // Several planar facets can come from one facet of the caller, since segments may divide it;
    // they are checked together. Returns the first of them that is in the plane of this one.
    std::uint32_t representative(std::uint32_t facet, const Buffer<std::uint32_t>& planar) const {
        const std::uint32_t triangle = facets_.facets[facet].triangle;
        const std::uint32_t* const v =
            complex_.boundary.triangles.begin() + 3 * std::size_t{triangle};
        const std::uint32_t corner[3] = {index(v[0]), index(v[1]), index(v[2])};
        for (std::uint32_t f = planar[complex_.facet_of_triangle[triangle]]; f < facet; ++f)
            if (direction(f, corner) > 0) return f;
        return facet;
    }

    // The first planar facet that comes from the caller's facet of a face and is in the plane of
    // the face; no_index if there is none.
    std::uint32_t facet_of_face(std::uint32_t face, const Buffer<std::uint32_t>& planar) const {
        const std::uint32_t* const v = mesh_.faces.begin() + 3 * std::size_t{face};
        const std::uint32_t corner[3] = {v[0], v[1], v[2]};
        const std::uint32_t source = mesh_.face_facets[face];
        if (source >= planar.size()) return no_index;
        for (std::uint32_t f = planar[source]; f < facets_.facets.size(); ++f) {
            if (complex_.facet_of_triangle[facets_.facets[f].triangle] != source) break;
            if (direction(f, corner) > 0) return f;
        }
        return no_index;
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

    // A part of a segment, and the number of the caller's segment, or no_index if the segment is an
    // edge of a facet.
    struct Part {
        std::uint32_t a, b, source;
        friend bool operator<(const Part& p, const Part& q) {
            return p.a != q.a ? p.a < q.a : p.b != q.b ? p.b < q.b : p.source < q.source;
        }
    };
    static Part part(std::uint32_t a, std::uint32_t b, std::uint32_t source) {
        return {std::min(a, b), std::max(a, b), source};
    }

    // Checks that exactly the parts of the segments are listed, and that every Steiner point is on
    // a segment or on nothing.
    void check_segments() {
        Buffer<Part> given(allocator_), expected(allocator_), found(allocator_);
        const Buffer<std::uint32_t>& ends = complex_.boundary.segments;
        for (std::uint32_t i = 0; i < ends.size() / 2; ++i)
            given.push_back(
                part(index(ends[2 * std::size_t{i}]), index(ends[2 * std::size_t{i} + 1]), i));
        std::sort(given.begin(), given.end());
        std::size_t steiner = 0;
        for (std::size_t s = 0; s < facets_.segments.size(); s += 2) {
            progress_.step(s, 0, facets_.segments.size());
            const std::uint32_t a = index(facets_.segments[s]), b = index(facets_.segments[s + 1]);
            const Part whole = part(a, b, 0);
            const Part* const of = std::lower_bound(given.begin(), given.end(), whole);
            const bool is_given = of != given.end() && of->a == whole.a && of->b == whole.b;
            const std::uint32_t source = is_given ? input_.segment_origin(of->source) : no_index;
            const Chain chain = this->chain(a, b);
            std::uint32_t from = chain.is_reversed ? b : a;
            for (std::size_t i = 0; i < chain.size; ++i) {
                expected.push_back(part(from, chain.first[i].point, source));
                from = chain.first[i].point;
            }
            expected.push_back(part(from, chain.is_reversed ? a : b, source));
            steiner += chain.size;
        }
        for (std::size_t i = 0; i < mesh_.steiner_parameters.size(); ++i)
            if (mesh_.steiner_edges[2 * i] == no_index) ++steiner;
        if (steiner != mesh_.steiner_parameters.size())
            fail(MGDT_ERR_CHECK_FAILED, "a Steiner point is on no segment");
        for (std::size_t s = 0; s < mesh_.edge_segments.size(); ++s)
            found.push_back(
                part(mesh_.edges[2 * s], mesh_.edges[2 * s + 1], mesh_.edge_segments[s]));
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

    // Checks that no hole is in a tetrahedron, and that each region has the marker of the last
    // place in it.
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
        progress_.stop_request().poll();
        for (std::uint32_t t = 0; t < mesh_.tetrahedron_count(); ++t)
            if (mesh_.side(mesh_.exact_points, t, x) >= 0) f(t);
    }

    const SolidMesh& mesh_;
    Allocator& allocator_;
    std::int64_t base_;
    const DomainInput& input_;
    Complex complex_;
    RoundingGrid grid_;
    PlanarFacets facets_;
    Buffer<Place> places_{allocator_};
    StageProgress& progress_;
};

}  // namespace

void compare_mesh(const DomainInput& input, const SolidMesh& mesh, std::int32_t index_base,
                  Allocator& allocator, StageProgress& progress) {
    MeshComparison(input, mesh, index_base, allocator, progress).run();
}

}  // namespace mgdt
