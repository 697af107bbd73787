// SPDX-License-Identifier: MIT
// The geometric part of the check, by exact arithmetic.
#include <algorithm>
#include <cmath>
#include <mutex>

#include "kernel/circumsphere.hpp"
#include "platform/atomic.hpp"
#include "predicates/interior_point.hpp"
#include "query/checker.hpp"
#include "query/sphere_bound.hpp"

namespace mgdt {
namespace {

struct Corners {
    Corners(const Mesh& mesh, const Tetrahedron& t)
        : p{mesh.point(t.v[0]), mesh.point(t.v[1]), mesh.point(t.v[2]), mesh.point(t.v[3])} {}
    InteriorPoint interior_point() const { return {p[0], p[1], p[2], p[3]}; }

    const double* p[4];
};

}  // namespace

// Checks that coordinates are finite, and that without the scale they have the exponents that were
// recorded for the given points.
void Checker::coordinates() const {
    const int scale = mesh_.scale;
    if (scale < -2200 || scale > 2200)
        fail(MGDT_ERR_CHECK_FAILED, "coordinates cannot be scaled by 2^%d", scale);
    Atomic<bool> has_extremes{false};
    std::mutex mutex;
    ExponentRange all;
    team_.split(mesh_.vertices.size(), 16384, [&](std::size_t begin, std::size_t end, unsigned) {
        ExponentRange mine;
        bool extreme = false;
        for (std::size_t v = std::max<std::size_t>(begin, 1); v < end; ++v) {
            const double* const x = mesh_.vertices[v].x;
            for (int k = 0; k < 3; ++k) {
                const double given = scaled(x[k], -scale);
                if (!std::isfinite(x[k]) || !std::isfinite(given))
                    fail(MGDT_ERR_CHECK_FAILED, "point %lld has a coordinate that is not finite",
                         index(static_cast<VertexId>(v)));
                if (scale != 0 && scaled(given, scale) != x[k])
                    fail(MGDT_ERR_CHECK_FAILED, "point %lld has a coordinate that was not scaled",
                         index(static_cast<VertexId>(v)));
                mine.add(given);
            }
            extreme = extreme || !in_normal_range(x);
        }
        if (extreme) has_extremes = true;
        const std::lock_guard<std::mutex> lock(mutex);
        all.add(mine);
    });
    if (has_extremes && !mesh_.has_extremes)
        fail(MGDT_ERR_CHECK_FAILED, "coordinates are outside the filters' range, unnoticed");
    // `given` includes the exponents of points that are not in the triangulation.
    const ExponentRange& given = input_.exponents;
    const bool all_in = !input_.exponents_are_wide &&
                        input_.points_inserted + input_.duplicates == input_.point_map.size();
    const bool equal = all.highest == given.highest && all.lowest_bit == given.lowest_bit;
    const bool within = all.highest <= given.highest && all.lowest_bit >= given.lowest_bit;
    if (all_in ? !equal : !within)
        fail(
            MGDT_ERR_CHECK_FAILED,
            "coordinates, scaled by 2^%d, are of 2^%d, last bit 2^%d, but 2^%d and 2^%d were given",
            scale, all.highest, all.lowest_bit, given.highest, given.lowest_bit);
}

// Checks that points that do not span space are distinct and have the recorded dimension.
void Checker::degenerate() const {
    Buffer<VertexId> order(allocator_, mesh_.vertices.size() - 1);
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<VertexId>(i + 1);
    std::sort(order.begin(), order.end(), [&](VertexId a, VertexId b) {
        return compare_lexicographic(mesh_.point(a), mesh_.point(b)) < 0;
    });
    const double* basis[4];
    int size = 0;
    for (std::size_t i = 0; i < order.size() && size < 4; ++i) {
        const double* const p = mesh_.point(order[i]);
        if (i > 0 && compare_lexicographic(mesh_.point(order[i - 1]), p) == 0)
            fail(MGDT_ERR_CHECK_FAILED, "points %lld and %lld are at one place",
                 index(order[i - 1]), index(order[i]));
        if (size < 2 || (size == 2 && !collinear(basis[0], basis[1], p)) ||
            (size == 3 && orientation(basis[0], basis[1], basis[2], p) != 0))
            basis[size++] = p;
    }
    if (size != input_.dimension + 1)
        fail(MGDT_ERR_CHECK_FAILED, "the points have dimension %d, not %d", size - 1,
             input_.dimension);
}

// Checks that tetrahedra are positively oriented and that, at each facet between two tetrahedra,
// the opposite vertex is not inside the circumsphere. If the vertex is on the sphere, the
// perturbation must not put it inside. The test gives the same answer from both sides of a facet,
// so one side is tested.
void Checker::delaunay(bool canonical) const {
    for_each_live([&](TetId id) {
        const Tetrahedron& t = tet(id);
        if (t.is_ghost()) return;
        const Corners c(mesh_, t);
        if (orientation(c.p[0], c.p[1], c.p[2], c.p[3]) <= 0) reject(id, "not positively oriented");
        for (const FacetCode n : t.n) {
            const Tetrahedron& m = tet(tetrahedron_of(n));
            if (tetrahedron_of(n) < id || m.is_ghost()) continue;
            const double* const q = mesh_.point(m.v[face_of(n)]);
            const int side = side_of_sphere(c.p[0], c.p[1], c.p[2], c.p[3], q);
            if (side > 0) reject(id, "a neighbour's vertex is inside its circumsphere");
            if (side == 0 && canonical &&
                side_of_sphere_perturbed(c.p[0], c.p[1], c.p[2], c.p[3], q) > 0)
                reject(id, "a tie is not broken canonically");
        }
    });
}

// Checks that the error of each stored sphere is within its bound.
void Checker::spheres() const {
    if (!mesh_.tetrahedra.has_spheres()) return;
    for_each_live([&](TetId id) {
        if (!sphere_is_within_bound(mesh_.tetrahedra.sphere(id).in_doubles(), tet(id),
                                    mesh_.vertices.data()))
            reject(id, tet(id).is_ghost() ? "its normal is off by more than its bound"
                                          : "its circumsphere is off by more than its bound");
    });
}

// Checks that the hull is convex at every edge, and that a point inside one tetrahedron is on the
// inner side of all hull facets and in no other tetrahedron.
void Checker::hull() const {
    const TetId home = tetrahedron_of(tet(mesh_.a_ghost).n[tet(mesh_.a_ghost).infinite_slot()]);
    const InteriorPoint inside = Corners(mesh_, tet(home)).interior_point();
    for_each_live([&](TetId id) {
        const Tetrahedron& t = tet(id);
        const Corners c(mesh_, t);
        if (!t.is_ghost()) {
            if (id != home && inside.is_in(c.p)) reject(id, "it overlaps another one");
            return;
        }
        const int slot = t.infinite_slot();
        const unsigned char* const face = outer_face[slot];
        // (q, a, b, c) is positively oriented for q inside the hull, so (a, b, c, q) is negatively
        // oriented.
        if (inside.orientation_from(c.p[face[0]], c.p[face[1]], c.p[face[2]]) >= 0)
            reject(id, "the hull facet is seen from outside by a point inside");
        for (int i = 0; i < 4; ++i) {
            const VertexId opposite = tet(tetrahedron_of(t.n[i])).v[face_of(t.n[i])];
            if (i != slot && is_conflict_exact(mesh_, t, mesh_.point(opposite)))
                reject(id, "the hull is not convex there");
        }
    });
}

}  // namespace mgdt
