// SPDX-License-Identifier: MIT
// Writes arrays of indices for the caller. Int is std::int64_t or std::int32_t. The caller has
// checked that the arrays are large enough and that the indices fit into Int.
#pragma once

#include "parallel/team.hpp"
#include "platform/stage_progress.hpp"
#include "query/numbering.hpp"

namespace mgdt {

struct ExportView {
    Team& team;
    const Mesh& mesh;
    const Numbering* numbering;  // nullptr if the export needs no numbers of tetrahedra
    Allocator& allocator;
    std::int32_t base;
    bool canonical;
};

template <class Int>
void export_tetrahedra(const ExportView& view, Int* out);
template <class Int>
void export_neighbors(const ExportView& view, Int* out);
template <class Int>
void export_hull_facets(const ExportView& view, Int* out);
template <class Int>
void export_edges(const ExportView& view, Int* out);
template <class Int>
void export_vertex_neighbors(const ExportView& view, std::size_t points, Int* offsets, Int* list);
template <class Int>
void export_point_map(const ExportView& view, const Buffer<VertexId>& point_map, Int* out);
template <class Int>
void export_vertex_tetrahedra(const ExportView& view, std::size_t points, Int* offsets, Int* list);

// The centre of the circumsphere of each tetrahedron, and the square of its radius unless `radius2`
// is null.
void export_circumcenters(const ExportView& view, StageProgress& progress, double* xyz,
                          double* radius2);

// The positions of a tetrahedron's vertices in its exported record: as stored, or canonical.
void export_positions(const ExportView& view, const Tetrahedron& t, unsigned positions[4]);

}  // namespace mgdt
