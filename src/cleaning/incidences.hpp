// SPDX-License-Identifier: MIT
// Points in edges and in triangles of which they are no corners.
#pragma once

#include "cleaning/nearness.hpp"
#include "cleaning/surface_pieces.hpp"
#include "solid/pair_table.hpp"

namespace mgdt {

struct Incidences {
    explicit Incidences(Allocator& allocator)
        : edges(allocator), on_edges(allocator), in_triangles(allocator) {}

    struct Incidence {
        std::uint32_t of;  // an edge or a triangle
        std::uint32_t point;

        friend bool operator<(const Incidence& a, const Incidence& b) {
            return a.of != b.of ? a.of < b.of : a.point < b.point;
        }
        friend bool operator==(const Incidence& a, const Incidence& b) {
            return a.of == b.of && a.point == b.point;
        }
    };
    bool empty() const noexcept { return on_edges.empty() && in_triangles.empty(); }

    PairTable edges;                 // the ends of the edges that have points
    Buffer<Incidence> on_edges;      // sorted by edges, and along each edge from its lesser end
    Buffer<Incidence> in_triangles;  // sorted by triangles
};

// Finds all incidences, exact or near ones. A point near an edge of a triangle is in that edge
// only.
Incidences find_incidences(const SurfacePieces& pieces, const Nearness& near, Team& team,
                           Allocator& allocator, StageProgress& progress);

}  // namespace mgdt
