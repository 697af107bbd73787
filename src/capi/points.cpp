// SPDX-License-Identifier: MIT
// Insertion of points.
#include "capi/counts.hpp"
#include "capi/triangulation_handle.hpp"

using namespace mgdt;

extern "C" mgdt_status mgdt_insert_points(mgdt_triangulation* t, int64_t n, const double* xyz) {
    return guard(t, [&] {
        const std::size_t count = require_count(n);
        if (count == 0) return;
        require_pointer(xyz, "xyz");
        const double* const axis[3] = {xyz, xyz + 1, xyz + 2};
        t->object.insert(count, axis, 3);
    });
}

extern "C" mgdt_status mgdt_insert_points_strided(mgdt_triangulation* t, int64_t n, const double* x,
                                                  const double* y, const double* z,
                                                  int64_t stride) {
    return guard(t, [&] {
        const std::size_t count = require_count(n);
        if (count == 0) return;
        require_pointer(x, "x");
        require_pointer(y, "y");
        require_pointer(z, "z");
        const double* const axis[3] = {x, y, z};
        const auto step = static_cast<std::ptrdiff_t>(stride);
        if (step != stride && count > 1)  // only where std::ptrdiff_t has 32 bits
            fail(MGDT_ERR_INVALID_ARGUMENT, "a stride of %lld takes the points beyond all memory",
                 static_cast<long long>(stride));
        t->object.insert(count, axis, step);
    });
}

// While a call changes a handle, the functions below return the counts of an empty handle.
namespace {

const Triangulation* unchanging(const mgdt_triangulation* t) {
    return t && !t->calls.is_held_alone() ? &t->object : nullptr;
}

}  // namespace

extern "C" int64_t mgdt_point_count(const mgdt_triangulation* t) {
    const Triangulation* const core = unchanging(t);
    return core ? point_count(*core) : 0;
}

extern "C" int64_t mgdt_vertex_count(const mgdt_triangulation* t) {
    const Triangulation* const core = unchanging(t);
    return core ? vertex_count(*core) : 0;
}

extern "C" int32_t mgdt_dimension(const mgdt_triangulation* t) {
    const Triangulation* const core = unchanging(t);
    return core ? core->dimension() : -1;
}

extern "C" int64_t mgdt_tetrahedron_count(const mgdt_triangulation* t) {
    const Triangulation* const core = unchanging(t);
    return core ? tetrahedron_count(*core) : 0;
}

extern "C" int64_t mgdt_hull_facet_count(const mgdt_triangulation* t) {
    const Triangulation* const core = unchanging(t);
    return core ? hull_facet_count(*core) : 0;
}

extern "C" int64_t mgdt_edge_count(const mgdt_triangulation* t) {
    const Triangulation* const core = unchanging(t);
    return core ? edge_count(*core) : 0;
}

extern "C" int64_t mgdt_vertex_tetrahedra_count(const mgdt_triangulation* t) {
    return 4 * mgdt_tetrahedron_count(t);
}

extern "C" int64_t mgdt_vertex_neighbors_count(const mgdt_triangulation* t) {
    return 2 * mgdt_edge_count(t);
}
