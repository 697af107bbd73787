// SPDX-License-Identifier: MIT
// Places in a mesh: the tetrahedra that contain them, and values at them.
#include "solid/mesh_places.hpp"

#include <algorithm>

#include "capi/mesh_handle.hpp"
#include "capi/places.hpp"
#include "parallel/thread_count.hpp"

using namespace mgdt;

namespace {

// Checks the places of a query, and calls body(finder, team, places) to answer it.
template <class Body>
void answer(const mgdt_mesh* m, std::int32_t outside, std::int64_t n, const double* xyz,
            const void* out, StageProgress& progress, const Body& body) {
    if (outside != MGDT_OUTSIDE_NONE && outside != MGDT_OUTSIDE_BOUNDARY)
        fail(MGDT_ERR_UNKNOWN_KEY, "there is no value %d for what is outside of a mesh",
             static_cast<int>(outside));
    const std::size_t count = require_places(n);
    if (count == 0) return;
    require_pointer(xyz, "xyz");
    require_pointer(out, "the output array");
    const MeshState& mesh = m->object.value;
    Team team(thread_count(m->object.settings()));
    const PointSet places = finite_places(team, count, xyz, m->object.settings().index_base);
    const SolidMesh& solid = mesh;
    const MeshLocator& inside = mesh.locator.get(solid, progress.stop_request());
    const BoundaryPlaces* const boundary =
        outside == MGDT_OUTSIDE_BOUNDARY ? &mesh.boundary_places.get(solid, progress.stop_request())
                                         : nullptr;
    body(PlaceFinder{solid, inside, boundary}, team, places);
}

template <class Int>
void locate(const mgdt_mesh* m, std::int32_t outside, std::int64_t n, const double* xyz,
            Int* tetrahedra, double* weights, StageProgress& progress) {
    answer(m, outside, n, xyz, tetrahedra, progress,
           [&](const PlaceFinder& finder, Team& team, const PointSet& places) {
               locate_places(finder, team, places, m->object.allocator(), progress,
                             static_cast<Int>(m->object.settings().index_base), tetrahedra,
                             weights);
           });
}

void interpolate(const mgdt_mesh* m, std::int32_t outside, std::int64_t n_fields,
                 const double* values, std::int64_t n, const double* xyz, double* out,
                 StageProgress& progress) {
    const std::size_t points = m->object.value.points.size() / 3;
    const std::size_t fields = require_fields(n_fields, std::max(require_places(n), points));
    if (fields == 0) return;
    if (points > 0) require_pointer(values, "values");
    answer(m, outside, n, xyz, out, progress,
           [&](const PlaceFinder& finder, Team& team, const PointSet& places) {
               interpolate_places(finder, team, places, m->object.allocator(), progress, fields,
                                  values, out);
           });
}

}  // namespace

extern "C" mgdt_status mgdt_mesh_locate_points(const mgdt_mesh* m, int32_t outside, int64_t n,
                                               const double* xyz, int64_t* tetrahedra,
                                               double* weights) {
    return guard_long(m, [&](StageProgress& progress) {
        locate(m, outside, n, xyz, tetrahedra, weights, progress);
    });
}

extern "C" mgdt_status mgdt_mesh_locate_points_i32(const mgdt_mesh* m, int32_t outside, int64_t n,
                                                   const double* xyz, int32_t* tetrahedra,
                                                   double* weights) {
    return guard_long(m, [&](StageProgress& progress) {
        locate(m, outside, n, xyz, tetrahedra, weights, progress);
    });
}

extern "C" mgdt_status mgdt_mesh_interpolate(const mgdt_mesh* m, int32_t outside, int64_t n_fields,
                                             const double* values, int64_t n, const double* xyz,
                                             double* out) {
    return guard_long(m, [&](StageProgress& progress) {
        interpolate(m, outside, n_fields, values, n, xyz, out, progress);
    });
}
