// SPDX-License-Identifier: MIT
// Puts the facets of a boundary into a mesh whose edges include all of its subsegments.
#pragma once

#include "boundary/planar_facets.hpp"
#include "domain/constrained_mesh.hpp"
#include "domain/segment_splitting.hpp"

namespace mgdt {

struct FacetCounts {
    std::size_t missing = 0;         // facets that crossed tetrahedra
    std::size_t cavities = 0;        // parts of the mesh that were filled anew
    std::size_t largest_cavity = 0;  // the largest number of tetrahedra that was replaced
};

// Replaces the tetrahedra that facets cross, and marks the faces of the mesh that are parts of
// facets. Afterwards the mesh is the constrained Delaunay triangulation of the points, segments and
// facets. `subsegments` is sorted, as split_segments() returns it.
FacetCounts insert_facets(ConstrainedMesh& mesh, const PlanarFacets& facets,
                          const Buffer<Subsegment>& subsegments, Allocator& allocator,
                          const StopRequest& stop);

}  // namespace mgdt
