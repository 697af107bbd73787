// SPDX-License-Identifier: MIT
// The edges of the triangles of a boundary, and its segments, sorted by their ends, so that equal
// ones are adjacent.
#pragma once

#include "boundary/complex.hpp"
#include "platform/no_index.hpp"

namespace mgdt {

// An edge of a triangle, or a segment that the caller gave, whose `side` is `no_index`.
struct BoundaryEdge {
    std::uint32_t a, b;  // the ends, a < b
    std::uint32_t side;  // 3 times the triangle, plus the corner opposite the edge

    bool is_segment() const noexcept { return side == no_index; }
    bool has_ends_of(const BoundaryEdge& e) const noexcept { return a == e.a && b == e.b; }
    friend bool operator<(const BoundaryEdge& e, const BoundaryEdge& f) {
        return e.a != f.a ? e.a < f.a : e.b != f.b ? e.b < f.b : e.side < f.side;
    }
};

// All edges and segments, sorted by their ends. A segment comes after the edges of triangles with
// the same ends.
Buffer<BoundaryEdge> sorted_edges(const Boundary& boundary, Allocator& allocator);

// Calls f(first, end) for the elements first to end - 1 of sorted edges that have the same ends.
template <class F>
void for_each_edge(const Buffer<BoundaryEdge>& edges, F f) {
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i + 1;
        while (end < edges.size() && edges[end].has_ends_of(edges[i])) ++end;
        f(i, end);
        i = end;
    }
}

// An edge that belongs to one of the caller's facets only: the surface is open there.
struct OpenEdge {
    std::uint32_t ends[2];  // the caller's points
    std::uint32_t facet;
};

// The open edges, sorted by their ends. Segments do not count.
Buffer<OpenEdge> open_edges(const Complex& complex, Allocator& allocator);

}  // namespace mgdt
