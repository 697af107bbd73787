// SPDX-License-Identifier: MIT
// Measures of the Voronoi cells of the points in a periodic box.
#pragma once

#include "dual/measures.hpp"
#include "periodic/periodic.hpp"

namespace mgdt {

// Threads for a pass over the triangulation of the points and their halo, and the context in which
// it is read.
inline Team team_of_halo(const Periodic& periodic) {
    constexpr std::size_t vertices_per_thread = 4096;
    const Triangulation& t = periodic.halo().triangulation();
    return Team(t.threads_for(t.vertex_count(), vertices_per_thread));
}
inline MeshView view_of_halo(const Periodic& periodic, Team& team) {
    return {team, periodic.halo().triangulation().mesh(), nullptr, periodic.allocator(), 0, false};
}

// Writes one double for each point of the caller, or three for a centroid, which is relative to the
// point; 0 for a point that has the images of an earlier one. The points have to span space.
void export_periodic_measures(const Periodic& periodic, Measure measure, StageProgress& progress,
                              double* out);

}  // namespace mgdt
