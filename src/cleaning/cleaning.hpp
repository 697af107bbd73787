// SPDX-License-Identifier: MIT
// Cleans the facets and segments of a domain: what is repeated, collapsed or divided on one side
// only becomes a complex where that takes no new points. Points stay where they are, unless points
// near each other are to become one.
#pragma once

#include "boundary/input.hpp"
#include "cleaning/equal_triangles.hpp"
#include "parallel/team.hpp"
#include "platform/stage_progress.hpp"

namespace mgdt {

// Distances as shares of the size of the points, which is the diagonal of their box.
struct CleaningDistances {
    double weld = 0;      // within which places are one
    double flatness = 0;  // within which facets are in one plane
};

// What cleaning has done.
struct CleaningCounts {
    std::size_t moved_points = 0;
    std::size_t repeated_corners = 0;  // that were left out of facets
    std::size_t collapsed_facets = 0;  // of which nothing is left
    std::size_t points_in_edges = 0;   // pairs of an edge and a point that divides it
    std::size_t points_in_facets = 0;  // pairs of a triangle of a facet and a point inside of it
    std::size_t edges_in_facets = 0;   // edges and segments that planar facets have taken in
    std::size_t exchanged_edges = 0;   // between triangles of planar facets, to make them Delaunay
};

struct CleanedFacets {
    explicit CleanedFacets(Allocator& allocator)
        : points(allocator),
          facet_begin(allocator),
          corners(allocator),
          facet_origins(allocator),
          segments(allocator),
          segment_origins(allocator),
          covered(allocator) {}

    Buffer<double> points;
    Buffer<std::uint32_t> facet_begin, corners;  // as in DomainInput
    Buffer<std::uint32_t> facet_origins;         // the given facet that each is, or is a part of
    Buffer<std::uint32_t> segments, segment_origins;
    Buffer<CoveredFacet> covered;  // sorted
    CleaningCounts counts;
};

// Cleans a domain's facets and segments. A facet that needs no change stays as it is, a polygon
// too.
CleanedFacets clean(const DomainInput& input, const CleaningDistances& distances, Team& team,
                    Allocator& allocator, StageProgress& progress);

}  // namespace mgdt
