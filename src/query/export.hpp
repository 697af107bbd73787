// SPDX-License-Identifier: MIT
// Writes arrays of indices for the caller. Int is std::int64_t or std::int32_t. The caller has
// checked that the arrays are large enough and that the indices fit into Int.
#pragma once

#include "query/mesh_view.hpp"

namespace mgdt {

template <class Int>
void export_tetrahedra(const MeshView& view, Int* out);
template <class Int>
void export_neighbors(const MeshView& view, Int* out);
template <class Int>
void export_hull_facets(const MeshView& view, Int* out);
template <class Int>
void export_edges(const MeshView& view, Int* out);
template <class Int>
void export_vertex_neighbors(const MeshView& view, std::size_t points, Int* offsets, Int* list);
template <class Int>
void export_point_map(const MeshView& view, const Buffer<VertexId>& point_map, Int* out);
template <class Int>
void export_vertex_tetrahedra(const MeshView& view, std::size_t points, Int* offsets, Int* list);

// The centre of the circumsphere of each tetrahedron, and the square of its radius unless `radius2`
// is null.
void export_circumcenters(const MeshView& view, StageProgress& progress, double* xyz,
                          double* radius2);

// The positions of a tetrahedron's vertices in its exported record: as stored, or canonical.
void export_positions(const MeshView& view, const Tetrahedron& t, unsigned positions[4]);

}  // namespace mgdt
