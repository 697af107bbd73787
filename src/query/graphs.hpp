// SPDX-License-Identifier: MIT
// Graphs of neighbours that the edges of the tetrahedra contain. Each is a set of edges, in the
// order of the caller's indices, the lesser first; the same for the same points.
#pragma once

#include "query/edge_lists.hpp"

namespace mgdt {

// The edges whose diametral sphere has no vertex inside.
EdgeLists gabriel_edges(const ExportView& view, std::size_t points);

// The corner of a triangle with an obtuse angle, which is inside the diametral sphere of the edge
// opposite; 3 if there is none.
unsigned obtuse_corner(const double* const (&p)[3]);

// A tree of least length that joins all vertices: of trees that are equally long the one whose
// edges come first. point_map has the vertex of each point. The ends of each edge, one after the
// other.
Buffer<std::uint32_t> spanning_tree(const ExportView& view, const Buffer<VertexId>& point_map);

}  // namespace mgdt
