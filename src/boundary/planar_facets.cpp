// SPDX-License-Identifier: MIT
#include "boundary/planar_facets.hpp"

#include "boundary/boundary_edges.hpp"
#include "parallel/disjoint_sets.hpp"
#include "platform/no_index.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

// Whether two triangles with a common edge are in one plane and on different sides of the edge.
bool continue_each_other(const Boundary& boundary, const BoundaryEdge& one,
                         const BoundaryEdge& other) {
    const auto point = [&](std::uint32_t v) {
        return boundary.points.begin() + 3 * std::size_t{v};
    };
    const double *const a = point(one.a), *const b = point(one.b),
                        *const c = point(boundary.triangles[one.side]),
                        *const d = point(boundary.triangles[other.side]);
    return orientation(a, b, c, d) == 0 && side_of_edge(a, b, c, d) < 0;
}

}  // namespace

PlanarFacets find_planar_facets(const Boundary& boundary, const Buffer<std::int32_t>& markers,
                                Allocator& allocator) {
    PlanarFacets result(allocator);
    const std::size_t triangles = boundary.triangles.size() / 3;
    const Buffer<BoundaryEdge> edges = sorted_edges(boundary, allocator);
    DisjointSets sets(allocator, triangles);
    Buffer<std::uint32_t> on_border(allocator);  // sides that are segments
    for_each_edge(edges, [&](std::size_t i, std::size_t end) {
        const bool joins = end - i == 2 && !edges[i + 1].is_segment() &&
                           markers[edges[i].side / 3] == markers[edges[i + 1].side / 3] &&
                           continue_each_other(boundary, edges[i], edges[i + 1]);
        if (joins) {
            sets.join(edges[i].side / 3, edges[i + 1].side / 3);
        } else {
            result.segments.push_back(edges[i].a);
            result.segments.push_back(edges[i].b);
            for (std::size_t k = i; k < end; ++k)
                if (!edges[k].is_segment()) on_border.push_back(edges[k].side);
        }
    });
    result.of_triangle.resize(triangles);
    for (std::uint32_t t = 0; t < triangles; ++t) {
        const std::uint32_t least = sets.least(t);
        if (least == t) {
            result.of_triangle[t] = static_cast<std::uint32_t>(result.facets.size());
            result.facets.push_back({{no_index, no_index, no_index}, t});
        } else {
            result.of_triangle[t] = result.of_triangle[least];
        }
    }
    for (const std::uint32_t side : on_border) {
        PlanarFacets::Facet& facet = result.facets[result.of_triangle[side / 3]];
        const std::uint32_t* const v = boundary.triangles.begin() + side / 3 * 3;
        if (facet.corner[0] == no_index)
            for (std::uint32_t k = 0; k < 3; ++k) facet.corner[k] = v[(side + 1 + k) % 3];
    }
    return result;
}

void separate_facets(const Boundary& boundary, PlanarFacets& facets) {
    facets.facets.clear();
    for (std::uint32_t t = 0; t < boundary.triangles.size() / 3; ++t) {
        const std::uint32_t* const v = boundary.triangles.begin() + 3 * std::size_t{t};
        facets.of_triangle[t] = t;
        facets.facets.push_back({{v[0], v[1], v[2]}, t});
    }
}

}  // namespace mgdt
