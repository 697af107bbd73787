// SPDX-License-Identifier: MIT
#include "capi/handle.hpp"

using namespace mgdt;

extern "C" mgdt_status mgdt_insert_points(mgdt_triangulation* t, int64_t n, const double* xyz) {
    return guard(t, [&] {
        require_count(n);
        if (n == 0) return;
        require_pointer(xyz, "xyz");
        const double* const axis[3] = {xyz, xyz + 1, xyz + 2};
        t->core.insert(static_cast<std::size_t>(n), axis, 3);
    });
}

extern "C" mgdt_status mgdt_insert_points_strided(mgdt_triangulation* t, int64_t n, const double* x,
                                                  const double* y, const double* z,
                                                  int64_t stride) {
    return guard(t, [&] {
        require_count(n);
        if (n == 0) return;
        require_pointer(x, "x");
        require_pointer(y, "y");
        require_pointer(z, "z");
        const double* const axis[3] = {x, y, z};
        t->core.insert(static_cast<std::size_t>(n), axis, static_cast<std::ptrdiff_t>(stride));
    });
}

extern "C" int64_t mgdt_point_count(const mgdt_triangulation* t) {
    return t ? static_cast<int64_t>(t->core.point_map().size()) : 0;
}

extern "C" int64_t mgdt_vertex_count(const mgdt_triangulation* t) {
    return t ? static_cast<int64_t>(t->core.vertex_count()) : 0;
}

extern "C" int32_t mgdt_dimension(const mgdt_triangulation* t) {
    return t ? t->core.dimension() : -1;
}

extern "C" int64_t mgdt_tetrahedron_count(const mgdt_triangulation* t) {
    return t ? static_cast<int64_t>(t->core.mesh().finite_count()) : 0;
}

extern "C" int64_t mgdt_hull_facet_count(const mgdt_triangulation* t) {
    return t ? static_cast<int64_t>(t->core.mesh().ghost_count) : 0;
}

extern "C" int64_t mgdt_edge_count(const mgdt_triangulation* t) {
    // Euler: V - E + F - T = 1 for a ball, with 2 F = 4 T + H.
    if (mgdt_tetrahedron_count(t) == 0) return 0;
    return mgdt_vertex_count(t) + mgdt_tetrahedron_count(t) + mgdt_hull_facet_count(t) / 2 - 1;
}

extern "C" int64_t mgdt_vertex_tetrahedra_count(const mgdt_triangulation* t) {
    return 4 * mgdt_tetrahedron_count(t);
}
