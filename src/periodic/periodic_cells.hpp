// SPDX-License-Identifier: MIT
// The Voronoi cells of the points in a periodic box: their measures, and their diagram.
#pragma once

#include "dual/measures.hpp"
#include "periodic/periodic.hpp"
#include "voronoi/diagram.hpp"

namespace mgdt {

// Writes one double for each point of the caller, or three for a centroid, which is relative to the
// point; 0 for a point that has the images of an earlier one. The points have to span space.
void export_periodic_measures(const Periodic& periodic, Measure measure, double* out);

// Sets the diagram of the cells of the points where the caller has put them. Two cells share a
// face, and its vertices, if they meet there as they are. A cell that meets an image of another one
// has the face for itself. The points have to span space. Throws MGDT_ERR_CANCELLED if there is a
// request to stop.
void build_periodic_diagram(const Periodic& periodic, const StopRequest& stop,
                            VoronoiDiagram& diagram);

}  // namespace mgdt
