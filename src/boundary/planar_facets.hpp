// SPDX-License-Identifier: MIT
// The planar facets of a boundary, which are unions of its triangles, and its segments.
#pragma once

#include "boundary/boundary.hpp"

namespace mgdt {

// A planar facet is a maximal union of triangles that are connected by edges which are no segments.
// An edge of triangles is a segment unless exactly two triangles have it, and these have the same
// marker, are in one plane, exactly, and on different sides of the edge. So a planar facet is a
// polygon, which may have holes. All segments of the boundary that meet it are on its border,
// except for segments of the caller, which may be inside of it.
struct PlanarFacets {
    explicit PlanarFacets(Allocator& allocator)
        : of_triangle(allocator), facets(allocator), segments(allocator) {}

    struct Facet {
        std::uint32_t corner[3];  // those of a triangle; the edge from 0 to 1 is a segment
        std::uint32_t triangle;   // the least triangle of the facet
    };

    Buffer<std::uint32_t> of_triangle;  // the facet of each triangle
    Buffer<Facet> facets;               // in the order of their least triangles
    Buffer<std::uint32_t> segments;     // 2 points for each, the lesser first; sorted
};

// Finds the planar facets. `markers` has the marker of each triangle. The segments of the boundary
// are kept, without repeats.
PlanarFacets find_planar_facets(const Boundary& boundary, const Buffer<std::int32_t>& markers,
                                Allocator& allocator);

// Makes every triangle a facet of its own. The segments stay.
void separate_facets(const Boundary& boundary, PlanarFacets& facets);

}  // namespace mgdt
