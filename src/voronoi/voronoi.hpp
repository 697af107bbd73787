// SPDX-License-Identifier: MIT
// The Voronoi diagram of a triangulation's vertices.
#pragma once

#include "dual/region.hpp"
#include "platform/stop_request.hpp"
#include "query/export.hpp"
#include "voronoi/diagram.hpp"

namespace mgdt {

// Sets the arrays of the diagram but for `planes`. The cells are clipped to the region if it is
// bounded. `points` is the number of points given; there is at least one tetrahedron. Throws
// MGDT_ERR_CANCELLED if there is a request to stop.
void build_voronoi(const ExportView& view, const Region& region, std::size_t points,
                   const StopRequest& stop, VoronoiDiagram& diagram);

}  // namespace mgdt
