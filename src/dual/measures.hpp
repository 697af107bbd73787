// SPDX-License-Identifier: MIT
// Measures of all Voronoi cells.
#pragma once

#include "dual/cell_measures.hpp"
#include "platform/stage_progress.hpp"
#include "query/mesh_view.hpp"

namespace mgdt {

// Writes one double per point, or three for a centroid; 0 for a point that is no vertex.
void export_measures(const MeshView& view, const Region& region, Measure measure,
                     std::size_t points, StageProgress& progress, double* x);

}  // namespace mgdt
