// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cstdint>
#include <limits>

#include "capi/counts.hpp"
#include "capi/handle.hpp"
#include "core/point_scan.hpp"
#include "order/curve_sort.hpp"
#include "query/check.hpp"
#include "query/export.hpp"
#include "query/locate.hpp"

using namespace mgdt;

namespace {

// Points that a thread pays for.
constexpr std::size_t min_items_per_thread = 4096;

Locator locator(const mgdt_triangulation* t) {
    return {t->core.mesh(), t->core.calls(), t->core.location_tree()};
}

PointScan scan_finite(Team& team, std::size_t n, const double* xyz, const mgdt_triangulation* t) {
    const double* const axis[3] = {xyz, xyz + 1, xyz + 2};
    return PointScan(team, n, axis, 3, t->core.settings().index_base);
}

template <class Int>
void locate_points(const mgdt_triangulation* t, int64_t n, const double* xyz, Int* tetrahedra,
                   double* weights) {
    if (n > PTRDIFF_MAX / static_cast<std::ptrdiff_t>(4 * sizeof(double)))
        fail(MGDT_ERR_INVALID_ARGUMENT, "%lld points are more than memory can hold",
             static_cast<long long>(n));
    const std::size_t count = require_count(n);
    if (count == 0) return;
    require_pointer(xyz, "xyz");
    require_pointer(tetrahedra, "the output array");
    Team team(t->core.threads_for(count, min_items_per_thread));
    const PointScan scan = scan_finite(team, count, xyz, t);
    const std::int64_t base = t->core.settings().index_base;
    if (tetrahedron_count(t->core) - 1 + base > std::numeric_limits<Int>::max())
        fail(MGDT_ERR_INDEX_RANGE, "tetrahedra do not fit a 32-bit integer");
    const Locator where = locator(t);
    const ExportView view = view_of(team, t, true);
    const auto report = [&](std::size_t i, TetId found) {
        tetrahedra[i] =
            static_cast<Int>((found == no_tetrahedron ? -1 : view.numbering->number(found)) + base);
        if (!weights) return;
        double* const out = weights + 4 * i;
        std::fill(out, out + 4, 0.0);
        if (found == no_tetrahedron) return;
        double stored[4];
        unsigned places[4];
        where.weights(found, xyz + 3 * i, stored);
        export_places(view, view.mesh.tetrahedra[found], places);
        for (int k = 0; k < 4; ++k) out[k] = stored[places[k]];
    };
    if (count == 1) {
        TetId hint = no_tetrahedron;
        report(0, where.locate(xyz, hint));
        return;
    }
    // Along a curve each is near the one before. Blocks bound the memory that sorting takes.
    constexpr std::size_t block = std::size_t{1} << 20;
    for (std::size_t begin = 0; begin < count; begin += block) {
        const std::size_t size = std::min(block, count - begin);
        const double* const points = xyz + 3 * begin;
        const double* const axis[3] = {points, points + 1, points + 2};
        const CurveOrder order =
            sort_along_curve(team, scan.point_set(size, axis, 3, 1), t->core.allocator());
        team.split(size, min_items_per_thread, [&](std::size_t first, std::size_t last, unsigned) {
            where.locate_sequence(
                last - first,
                [&](std::size_t k) { return points + std::size_t{3} * order.index(first + k); },
                [&](std::size_t k, TetId found) { report(begin + order.index(first + k), found); });
        });
    }
}

}  // namespace

extern "C" mgdt_status mgdt_locate(const mgdt_triangulation* t, const double* xyz,
                                   int64_t* tetrahedron) {
    return guard_short(t, [&] { locate_points(t, 1, xyz, tetrahedron, nullptr); });
}

extern "C" mgdt_status mgdt_locate_i32(const mgdt_triangulation* t, const double* xyz,
                                       int32_t* tetrahedron) {
    return guard_short(t, [&] { locate_points(t, 1, xyz, tetrahedron, nullptr); });
}

extern "C" mgdt_status mgdt_locate_points(const mgdt_triangulation* t, int64_t n, const double* xyz,
                                          int64_t* tetrahedra, double* weights) {
    return guard(t, [&] { locate_points(t, n, xyz, tetrahedra, weights); });
}

extern "C" mgdt_status mgdt_locate_points_i32(const mgdt_triangulation* t, int64_t n,
                                              const double* xyz, int32_t* tetrahedra,
                                              double* weights) {
    return guard(t, [&] { locate_points(t, n, xyz, tetrahedra, weights); });
}

extern "C" mgdt_status mgdt_nearest_vertex(const mgdt_triangulation* t, const double* xyz,
                                           int64_t* vertex) {
    return guard_short(t, [&] {
        require_pointer(xyz, "xyz");
        require_pointer(vertex, "vertex");
        Team alone;
        scan_finite(alone, 1, xyz, t);
        const std::int64_t base = t->core.settings().index_base;
        const VertexId found = locator(t).nearest_vertex(xyz, t->core.allocator());
        *vertex = found == infinite_vertex
                      ? base - 1
                      : static_cast<std::int64_t>(t->core.mesh().vertices[found].index) + base;
    });
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
