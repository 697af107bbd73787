// SPDX-License-Identifier: MIT
// The Voronoi diagram of a triangulation's vertices.
#pragma once

#include "dual/region.hpp"
#include "platform/stage_progress.hpp"
#include "query/mesh_view.hpp"
#include "voronoi/diagram.hpp"

namespace mgdt {

// What a caller needs that goes on to translate the cells.
struct VoronoiSources {
    explicit VoronoiSources(Allocator& allocator) : of_vertex(allocator), of_ray(allocator) {}
    Buffer<TetId> of_vertex;  // a tetrahedron whose circumcentre the vertex is
    Buffer<TetId> of_ray;     // a ghost whose facet the ray leaves
};

// Sets the arrays of the diagram but for `planes`. The cells are clipped to the region if it is
// bounded. `points` is the number of points given; there is at least one tetrahedron. The cells of
// `far` vertices with larger indices are left out; they are outside the region. With
// `sources`, which requires a region without bounds, sets these too, and the centroids are
// relative: that of a cell to its point, that of a face to its first side. Throws
// MGDT_ERR_CANCELLED if there is a request to stop.
void build_voronoi(const MeshView& view, const Region& region, std::size_t points, std::size_t far,
                   StageProgress& progress, VoronoiDiagram& diagram,
                   VoronoiSources* sources = nullptr);

}  // namespace mgdt
