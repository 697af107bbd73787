// SPDX-License-Identifier: MIT
// Measures of the Voronoi cells of the points in a periodic box.
#pragma once

#include "dual/measures.hpp"
#include "periodic/periodic.hpp"

namespace mgdt {

// Makes a team for a pass over the triangulation of the points and their halo, and what such a pass
// is given.
inline Team team_of_halo(const Periodic& periodic) {
    constexpr std::size_t vertices_per_thread = 4096;
    const Triangulation& t = periodic.halo().triangulation();
    return Team(t.threads_for(t.vertex_count(), vertices_per_thread));
}
inline MeshView view_of_halo(const Periodic& periodic, Team& team) {
    return {team, periodic.halo().triangulation().mesh(), nullptr, periodic.allocator(), 0, false};
}

// Writes the measure of the cell of each point of the caller. Centroids, three numbers each, are
// relative to the points. A point that has the same images as an earlier one gets 0. The points
// have to span space.
void export_periodic_measures(const Periodic& periodic, Measure measure, StageProgress& progress,
                              double* out);

}  // namespace mgdt
