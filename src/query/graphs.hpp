// SPDX-License-Identifier: MIT
// Proximity graphs, which are subsets of the edges of the tetrahedra. A graph depends on the points
// alone: edges are sorted by the caller's indices, and each has its lesser index first.
#pragma once

#include "platform/stage_progress.hpp"
#include "query/edge_lists.hpp"

namespace mgdt {

// The edges whose diametral sphere has no vertex inside.
EdgeLists gabriel_edges(const MeshView& view, std::size_t points, StageProgress& progress);

// The corner of a triangle with an obtuse angle, or 3 if there is none. Such a corner is inside the
// diametral sphere of the opposite edge.
unsigned obtuse_corner(const double* const (&p)[3]);

// The Euclidean minimum spanning tree of all vertices, as two ends per edge. Edges of equal length
// are ordered by the indices of their ends, which makes the tree unique. point_map has the vertex
// of each point.
Buffer<std::uint32_t> spanning_tree(const MeshView& view, const Buffer<VertexId>& point_map,
                                    StageProgress& progress);

}  // namespace mgdt
