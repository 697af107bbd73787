// SPDX-License-Identifier: MIT
// Alpha shapes (Edelsbrunner and Muecke, Three-dimensional alpha shapes, ACM Transactions on
// Graphics 13, 1994). If no vertex is inside the smallest sphere through the vertices of a simplex,
// the alpha of the simplex is the square of that sphere's radius. Otherwise it is the least alpha
// of the larger simplices that have the simplex as a face.
#pragma once

#include "platform/stage_progress.hpp"
#include "query/mesh_view.hpp"

namespace mgdt {

// These functions write the alpha of each simplex of one dimension. Tetrahedra and edges are in
// their exported order. Each tetrahedron has four facets, and facet i is opposite vertex i. Points
// are in the caller's order: the alpha is 0 for a vertex and infinite for a point that is no
// vertex.
void export_tetrahedron_alphas(const MeshView& view, StageProgress& progress, double* out);
void export_facet_alphas(const MeshView& view, StageProgress& progress, double* out);
void export_edge_alphas(const MeshView& view, const Buffer<VertexId>& point_map,
                        StageProgress& progress, double* out);
void export_vertex_alphas(const MeshView& view, std::size_t points, double* out);

// Returns the facets that separate the tetrahedra with alpha at most alpha2 from everything else.
// Each facet is three indices, with the least index first, in counter-clockwise order seen from
// outside. The facets are sorted.
Buffer<std::uint32_t> alpha_surface(const MeshView& view, double alpha2, StageProgress& progress);

// Returns the least alpha at which the tetrahedra up to this alpha contain all vertices and are one
// solid that is connected through facets.
double solid_alpha(const MeshView& view, StageProgress& progress);

}  // namespace mgdt
