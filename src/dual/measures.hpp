// SPDX-License-Identifier: MIT
// Measures of all cells.
#pragma once

#include "dual/cell_measures.hpp"
#include "query/export.hpp"

namespace mgdt {

// One double a point, or three of a centroid; 0 where a point is no vertex.
void export_measures(const ExportView& view, const Region& region, Measure measure,
                     std::size_t points, double* x);

}  // namespace mgdt
