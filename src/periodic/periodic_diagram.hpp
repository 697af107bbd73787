// SPDX-License-Identifier: MIT
// The Voronoi diagram of the points in a periodic box, each cell where the caller has put its
// point.
#pragma once

#include "periodic/periodic.hpp"
#include "voronoi/diagram.hpp"

namespace mgdt {

// Sets the diagram of the cells. Two cells share a face, and its vertices, if they meet there as
// they are. A cell that meets an image of another one has the face for itself. The points have to
// span space. Throws MGDT_ERR_CANCELLED if there is a request to stop.
void build_periodic_diagram(const Periodic& periodic, StageProgress& progress,
                            VoronoiDiagram& diagram);

}  // namespace mgdt
