// SPDX-License-Identifier: MIT
#include <cstdint>

#include "capi/counts.hpp"
#include "capi/handle.hpp"
#include "capi/places.hpp"
#include "query/check.hpp"
#include "query/locate_points.hpp"

using namespace mgdt;

namespace {

// Checks the arguments of a query with many places, and calls body(team, places) to answer it.
template <class Int, class Body>
void answer(const mgdt_triangulation* t, int64_t n, const double* xyz, const Int* out, Body body) {
    const std::size_t count = require_places(n);
    if (count == 0) return;
    require_pointer(xyz, "xyz");
    require_pointer(out, "the output array");
    Team team(t->core.threads_for(count, places_per_thread));
    const PointSet places = finite_places(team, count, xyz, t);
    body(team, places);
}

template <class Int>
void locate(const mgdt_triangulation* t, int64_t n, const double* xyz, Int* tetrahedra,
            double* weights) {
    answer(t, n, xyz, tetrahedra, [&](Team& team, const PointSet& places) {
        require_range<Int>(static_cast<std::uint64_t>(tetrahedron_count(t->core)), t);
        locate_points(view_of(team, t, true), locator(t), places, tetrahedra, weights);
    });
}

template <class Int>
void nearest(const mgdt_triangulation* t, int64_t n, const double* xyz, Int* vertices) {
    answer(t, n, xyz, vertices, [&](Team& team, const PointSet& places) {
        require_range<Int>(static_cast<std::uint64_t>(point_count(t->core)), t);
        nearest_vertices(view_of(team, t, false), locator(t), places, vertices);
    });
}

}  // namespace

extern "C" mgdt_status mgdt_locate(const mgdt_triangulation* t, const double* xyz,
                                   int64_t* tetrahedron) {
    return guard_short(t, [&] { locate(t, 1, xyz, tetrahedron, nullptr); });
}

extern "C" mgdt_status mgdt_locate_i32(const mgdt_triangulation* t, const double* xyz,
                                       int32_t* tetrahedron) {
    return guard_short(t, [&] { locate(t, 1, xyz, tetrahedron, nullptr); });
}

extern "C" mgdt_status mgdt_locate_points(const mgdt_triangulation* t, int64_t n, const double* xyz,
                                          int64_t* tetrahedra, double* weights) {
    return guard(t, [&] { locate(t, n, xyz, tetrahedra, weights); });
}

extern "C" mgdt_status mgdt_locate_points_i32(const mgdt_triangulation* t, int64_t n,
                                              const double* xyz, int32_t* tetrahedra,
                                              double* weights) {
    return guard(t, [&] { locate(t, n, xyz, tetrahedra, weights); });
}

extern "C" mgdt_status mgdt_nearest_vertex(const mgdt_triangulation* t, const double* xyz,
                                           int64_t* vertex) {
    return guard_short(t, [&] { nearest(t, 1, xyz, vertex); });
}

extern "C" mgdt_status mgdt_nearest_vertex_i32(const mgdt_triangulation* t, const double* xyz,
                                               int32_t* vertex) {
    return guard_short(t, [&] { nearest(t, 1, xyz, vertex); });
}

extern "C" mgdt_status mgdt_nearest_vertices(const mgdt_triangulation* t, int64_t n,
                                             const double* xyz, int64_t* vertices) {
    return guard(t, [&] { nearest(t, n, xyz, vertices); });
}

extern "C" mgdt_status mgdt_nearest_vertices_i32(const mgdt_triangulation* t, int64_t n,
                                                 const double* xyz, int32_t* vertices) {
    return guard(t, [&] { nearest(t, n, xyz, vertices); });
}

extern "C" mgdt_status mgdt_check(const mgdt_triangulation* t, int32_t level) {
    return guard(t, [&] {
        if (level < MGDT_CHECK_COMBINATORIAL || level > MGDT_CHECK_CANONICAL)
            fail(MGDT_ERR_INVALID_ARGUMENT, "there is no check level %d", static_cast<int>(level));
        Team team(t->core.threads_for(t->core.mesh().tetrahedra.size(), 65536));
        check_triangulation(team, t->core.check_input(), t->core.allocator(), level,
                            t->core.settings().index_base);
    });
}
