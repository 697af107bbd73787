// SPDX-License-Identifier: MIT
// The Voronoi diagram of the points in a periodic box, each cell where the caller has put its
// point.
#pragma once

#include "periodic/periodic.hpp"
#include "voronoi/diagram.hpp"

namespace mgdt {

// Builds the diagram. Two cells share a face and its vertices if they meet where the caller has put
// their points. A cell that meets an image of another cell has a face of its own. The points have
// to span space. Throws MGDT_ERR_CANCELLED if there is a request to stop.
void build_periodic_diagram(const Periodic& periodic, StageProgress& progress,
                            VoronoiDiagram& diagram);

}  // namespace mgdt
