// SPDX-License-Identifier: MIT
// Location, nearest vertices, segments through a triangulation, and its check.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "capi/counts.hpp"
#include "capi/places.hpp"
#include "capi/triangulation_handle.hpp"
#include "query/check.hpp"
#include "query/locate_points.hpp"
#include "query/segment_walk.hpp"

using namespace mgdt;

namespace {

// Checks the arguments of a query with many places, and calls body(team, places) to answer it.
template <class Int, class Body>
void answer(const mgdt_triangulation* t, int64_t n, const double* xyz, const Int* out,
            const Body& body) {
    const std::size_t count = require_places(n);
    if (count == 0) return;
    require_pointer(xyz, "xyz");
    require_pointer(out, "the output array");
    Team team(t->object.threads_for(count, places_per_thread));
    const PointSet places = finite_places(team, count, xyz, t->object.settings().index_base);
    body(team, places);
}

// For a query of one place, which is short.
StageProgress unwatched(const mgdt_triangulation* t) {
    return StageProgress(CallSettings(), t->object.stop());
}

template <class Int>
void locate(const mgdt_triangulation* t, int64_t n, const double* xyz,
            const StageProgress& progress, Int* tetrahedra, double* weights) {
    answer(t, n, xyz, tetrahedra, [&](Team& team, const PointSet& places) {
        require_range<Int>(static_cast<std::uint64_t>(tetrahedron_count(t->object)), t);
        locate_points(view_of(team, t, true), locator(t), places, progress, tetrahedra, weights);
    });
}

template <class Int>
void nearest(const mgdt_triangulation* t, int64_t n, const double* xyz,
             const StageProgress& progress, Int* vertices) {
    answer(t, n, xyz, vertices, [&](Team& team, const PointSet& places) {
        require_range<Int>(static_cast<std::uint64_t>(point_count(t->object)), t);
        nearest_vertices(view_of(team, t, false), locator(t), places, progress, vertices);
    });
}

// Copies an end of a segment. Throws if a coordinate is not finite.
void copy_end(const double* from, const char* name, double (&to)[3]) {
    require_pointer(from, name);
    std::copy_n(from, 3, to);
    for (int k = 0; k < 3; ++k)
        if (!std::isfinite(to[k]))
            fail(MGDT_ERR_NOT_FINITE, "coordinate %c of %s is not finite", "xyz"[k], name);
}

template <class Int>
void traverse(const mgdt_triangulation* t, const double* a, const double* b, int64_t capacity,
              Int* tetrahedra, double* parameters, Int* count) {
    double ends[2][3];
    copy_end(a, "a", ends[0]);
    copy_end(b, "b", ends[1]);
    require_pointer(count, "count");
    require_capacity(capacity, 0, "tetrahedra");
    require_range<Int>(static_cast<std::uint64_t>(tetrahedron_count(t->object)), t);
    const Traversal way = traverse_segment(locator(t), ends[0], ends[1], t->object.allocator());
    const std::size_t found = way.tetrahedra.size();
    *count = static_cast<Int>(found);
    require_capacity(capacity, found, "tetrahedra");
    if (found == 0) return;
    require_pointer(tetrahedra, "tetrahedra");
    Team team(1);
    const MeshView view = view_of(team, t, true);
    for (std::size_t i = 0; i < found; ++i)
        tetrahedra[i] = static_cast<Int>(view.numbering->number(way.tetrahedra[i])) +
                        static_cast<Int>(view.base);
    if (parameters) std::copy_n(way.parameters.data(), found + 1, parameters);
}

}  // namespace

extern "C" mgdt_status mgdt_locate(const mgdt_triangulation* t, const double* xyz,
                                   int64_t* tetrahedron) {
    return guard_short(t, [&] { locate(t, 1, xyz, unwatched(t), tetrahedron, nullptr); });
}

extern "C" mgdt_status mgdt_locate_i32(const mgdt_triangulation* t, const double* xyz,
                                       int32_t* tetrahedron) {
    return guard_short(t, [&] { locate(t, 1, xyz, unwatched(t), tetrahedron, nullptr); });
}

extern "C" mgdt_status mgdt_locate_points(const mgdt_triangulation* t, int64_t n, const double* xyz,
                                          int64_t* tetrahedra, double* weights) {
    return guard_long(t, [&](const StageProgress& progress) {
        locate(t, n, xyz, progress, tetrahedra, weights);
    });
}

extern "C" mgdt_status mgdt_locate_points_i32(const mgdt_triangulation* t, int64_t n,
                                              const double* xyz, int32_t* tetrahedra,
                                              double* weights) {
    return guard_long(t, [&](const StageProgress& progress) {
        locate(t, n, xyz, progress, tetrahedra, weights);
    });
}

extern "C" mgdt_status mgdt_nearest_vertex(const mgdt_triangulation* t, const double* xyz,
                                           int64_t* vertex) {
    return guard_short(t, [&] { nearest(t, 1, xyz, unwatched(t), vertex); });
}

extern "C" mgdt_status mgdt_nearest_vertex_i32(const mgdt_triangulation* t, const double* xyz,
                                               int32_t* vertex) {
    return guard_short(t, [&] { nearest(t, 1, xyz, unwatched(t), vertex); });
}

extern "C" mgdt_status mgdt_nearest_vertices(const mgdt_triangulation* t, int64_t n,
                                             const double* xyz, int64_t* vertices) {
    return guard_long(
        t, [&](const StageProgress& progress) { nearest(t, n, xyz, progress, vertices); });
}

extern "C" mgdt_status mgdt_nearest_vertices_i32(const mgdt_triangulation* t, int64_t n,
                                                 const double* xyz, int32_t* vertices) {
    return guard_long(
        t, [&](const StageProgress& progress) { nearest(t, n, xyz, progress, vertices); });
}

extern "C" mgdt_status mgdt_traverse_segment(const mgdt_triangulation* t, const double* a,
                                             const double* b, int64_t capacity, int64_t* tetrahedra,
                                             double* parameters, int64_t* count) {
    return guard(t, [&] { traverse(t, a, b, capacity, tetrahedra, parameters, count); });
}

extern "C" mgdt_status mgdt_traverse_segment_i32(const mgdt_triangulation* t, const double* a,
                                                 const double* b, int64_t capacity,
                                                 int32_t* tetrahedra, double* parameters,
                                                 int32_t* count) {
    return guard(t, [&] { traverse(t, a, b, capacity, tetrahedra, parameters, count); });
}

extern "C" mgdt_status mgdt_check(const mgdt_triangulation* t, int32_t level) {
    return guard_long(t, [&](StageProgress& progress) {
        if (level < MGDT_CHECK_COMBINATORIAL || level > MGDT_CHECK_CANONICAL)
            fail(MGDT_ERR_INVALID_ARGUMENT, "there is no check level %d", static_cast<int>(level));
        Team team(t->object.threads_for(t->object.mesh().tetrahedra.size(), 65536));
        check_triangulation(team, t->object.check_input(), t->object.allocator(), level,
                            t->object.settings().index_base, progress);
    });
}
