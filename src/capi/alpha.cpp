// SPDX-License-Identifier: MIT
// The functions that give alpha values, and the surfaces of alpha shapes.
#include "dual/alpha.hpp"

#include "capi/counts.hpp"
#include "capi/triangulation_handle.hpp"

using namespace mgdt;

namespace {

constexpr std::size_t slots_per_thread = 4096;

template <class Int>
void surface(const mgdt_triangulation* t, double alpha2, int64_t capacity, Int* v, Int* count,
             StageProgress& progress) {
    require_pointer(count, "count");
    require_capacity(capacity, 0, "the output array");
    if (!(alpha2 >= 0))
        fail(MGDT_ERR_INVALID_ARGUMENT, "alpha2 is %g; it must be at least 0", alpha2);
    Team team(t->object.threads_for(t->object.mesh().tetrahedra.size(), slots_per_thread));
    const Buffer<std::uint32_t> facets = alpha_surface(view_of(team, t, false), alpha2, progress);
    give_rows(t, 3, facets.size() / 3, capacity, v, count, [&](Int base) {
        for (std::size_t i = 0; i < facets.size(); ++i) v[i] = static_cast<Int>(facets[i]) + base;
    });
}

}  // namespace

extern "C" mgdt_status mgdt_get_alphas(const mgdt_triangulation* t, int32_t dimension,
                                       int64_t capacity, double* alpha2) {
    return guard_long(t, [&](StageProgress& progress) {
        if (dimension < 0 || dimension > 3)
            fail(MGDT_ERR_INVALID_ARGUMENT, "dimension %d is not 0 to 3",
                 static_cast<int>(dimension));
        const std::int64_t counts[] = {point_count(t->object), edge_count(t->object),
                                       4 * tetrahedron_count(t->object),
                                       tetrahedron_count(t->object)};
        const auto count = static_cast<std::size_t>(counts[dimension]);
        if (count > 0) require_pointer(alpha2, "the output array");
        require_capacity(capacity, count, "the output array");
        if (count == 0) return;
        Team team(t->object.threads_for(t->object.mesh().tetrahedra.size(), slots_per_thread));
        const MeshView view = view_of(team, t, dimension >= 2);
        switch (dimension) {
            case 3:
                return export_tetrahedron_alphas(view, progress, alpha2);
            case 2:
                return export_facet_alphas(view, progress, alpha2);
            case 1:
                return export_edge_alphas(view, t->object.point_map(), progress, alpha2);
            default:
                return export_vertex_alphas(view, count, alpha2);
        }
    });
}

extern "C" mgdt_status mgdt_get_alpha_surface(const mgdt_triangulation* t, double alpha2,
                                              int64_t capacity, int64_t* v, int64_t* count) {
    return guard_long(
        t, [&](StageProgress& progress) { surface(t, alpha2, capacity, v, count, progress); });
}

extern "C" mgdt_status mgdt_get_alpha_surface_i32(const mgdt_triangulation* t, double alpha2,
                                                  int64_t capacity, int32_t* v, int32_t* count) {
    return guard_long(
        t, [&](StageProgress& progress) { surface(t, alpha2, capacity, v, count, progress); });
}

extern "C" mgdt_status mgdt_get_solid_alpha(const mgdt_triangulation* t, double* alpha2) {
    return guard_long(t, [&](StageProgress& progress) {
        require_space(t, "solids");
        require_pointer(alpha2, "alpha2");
        Team team(t->object.threads_for(t->object.mesh().tetrahedra.size(), slots_per_thread));
        *alpha2 = solid_alpha(view_of(team, t, false), progress);
    });
}
