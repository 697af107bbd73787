// SPDX-License-Identifier: MIT
#include "boundary/boundary_edges.hpp"

#include <algorithm>

namespace mgdt {

Buffer<BoundaryEdge> sorted_edges(const Boundary& boundary, Allocator& allocator) {
    const std::size_t corners = boundary.triangles.size(), ends = boundary.segments.size();
    Buffer<BoundaryEdge> edges(allocator, corners + ends / 2);
    const auto edge = [](std::uint32_t a, std::uint32_t b, std::uint32_t side) {
        return BoundaryEdge{std::min(a, b), std::max(a, b), side};
    };
    for (std::size_t i = 0; i < corners; ++i) {
        const std::uint32_t* const v = boundary.triangles.begin() + i / 3 * 3;
        edges[i] = edge(v[(i + 1) % 3], v[(i + 2) % 3], static_cast<std::uint32_t>(i));
    }
    for (std::size_t i = 0; i < ends; i += 2)
        edges[corners + i / 2] = edge(boundary.segments[i], boundary.segments[i + 1], no_index);
    std::sort(edges.begin(), edges.end());
    return edges;
}

Buffer<OpenEdge> open_edges(const Complex& complex, Allocator& allocator) {
    const Buffer<BoundaryEdge> edges = sorted_edges(complex.boundary, allocator);
    Buffer<OpenEdge> found(allocator);
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const bool is_first = i == 0 || !edges[i].has_ends_of(edges[i - 1]);
        const bool is_last = i + 1 == edges.size() || edges[i + 1].is_segment() ||
                             !edges[i].has_ends_of(edges[i + 1]);
        if (!is_first || !is_last || edges[i].is_segment()) continue;
        found.push_back({{complex.point_of_number[edges[i].a], complex.point_of_number[edges[i].b]},
                         complex.facet_of_triangle[edges[i].side / 3]});
    }
    return found;
}

}  // namespace mgdt
