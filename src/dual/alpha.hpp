// SPDX-License-Identifier: MIT
// Alpha shapes (Edelsbrunner and Muecke, Three-dimensional alpha shapes, ACM Transactions on
// Graphics 13, 1994). The alpha of a simplex is the square of the radius of the least sphere
// through its vertices if no vertex is inside that, and otherwise the least alpha of those that it
// is a face of.
#pragma once

#include "query/export.hpp"

namespace mgdt {

// Of all simplices of a dimension: tetrahedra in their order; their facets, 4 each, the one
// opposite vertex i being number i; edges in their order; points, 0 of a vertex and infinite of
// others.
void export_tetrahedron_alphas(const ExportView& view, double* out);
void export_facet_alphas(const ExportView& view, double* out);
void export_edge_alphas(const ExportView& view, const Buffer<VertexId>& point_map, double* out);
void export_vertex_alphas(const ExportView& view, std::size_t points, double* out);

// The tetrahedra whose alpha is at most alpha2, and the facets between these and the others: each
// with its least index first, counter-clockwise seen from outside, 3 indices one after the other,
// ascending.
Buffer<std::uint32_t> alpha_surface(const ExportView& view, double alpha2);

// The least alpha whose tetrahedra have all vertices and are one solid, connected through facets.
double solid_alpha(const ExportView& view);

}  // namespace mgdt
