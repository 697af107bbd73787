// SPDX-License-Identifier: MIT
// The Voronoi diagram of a triangulation's vertices.
#pragma once

#include "dual/region.hpp"
#include "platform/stage_progress.hpp"
#include "query/mesh_view.hpp"
#include "voronoi/diagram.hpp"

namespace mgdt {

// What a caller needs to translate cells: where the vertices and rays came from.
struct VoronoiSources {
    explicit VoronoiSources(Allocator& allocator) : of_vertex(allocator), of_ray(allocator) {}
    Buffer<TetId> of_vertex;  // a tetrahedron whose circumcentre the vertex is
    Buffer<TetId> of_ray;     // a ghost whose facet the ray leaves
};

// Builds the diagram, except for `planes`. The cells are clipped to the region if it is bounded.
// `points` is the number of points that were given; there is at least one tetrahedron. The last
// `far` vertices, whose indices are at least `points`, are outside of the region and get no cells.
// `sources` may be null. Otherwise the region is unbounded, the function sets them, and centroids
// are relative: that of a cell to its point, and that of a face to its first side. Throws
// MGDT_ERR_CANCELLED if there is a request to stop.
void build_voronoi(const MeshView& view, const Region& region, std::size_t points, std::size_t far,
                   StageProgress& progress, VoronoiDiagram& diagram,
                   VoronoiSources* sources = nullptr);

}  // namespace mgdt
