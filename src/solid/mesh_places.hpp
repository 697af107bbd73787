// SPDX-License-Identifier: MIT
// Many places in a mesh: the tetrahedra that contain them, and values at them.
#pragma once

#include "order/schedule.hpp"
#include "parallel/team.hpp"
#include "platform/stage_progress.hpp"
#include "solid/boundary_places.hpp"
#include "solid/mesh_locator.hpp"

namespace mgdt {

// What finds places in a mesh. Without `outside`, places outside of the mesh are nowhere; with it,
// the nearest place of the boundary stands for each of them.
struct PlaceFinder {
    const SolidMesh& mesh;
    const MeshLocator& inside;
    const BoundaryPlaces* outside;

    // The tetrahedron of a place, or no_index, and the barycentric coordinates in the order of its
    // corners. `near` is the last result of the thread.
    std::uint32_t find(const double* place, std::uint32_t near, double (&weights)[4]) const;
};

// Writes the number of the tetrahedron of each place plus `base`, or base - 1 if it is nowhere, and
// the weights, unless these are null: zeros for a place that is nowhere. Int is std::int64_t or
// std::int32_t.
template <class Int>
void locate_places(const PlaceFinder& finder, Team& team, const PointSet& places,
                   Allocator& allocator, const StageProgress& progress, Int base, Int* tetrahedra,
                   double* weights);

// Writes `fields` values for each place, linear in each tetrahedron between the values of the
// mesh's points; NaN for a place that is nowhere.
void interpolate_places(const PlaceFinder& finder, Team& team, const PointSet& places,
                        Allocator& allocator, const StageProgress& progress, std::size_t fields,
                        const double* values, double* out);

}  // namespace mgdt
