// SPDX-License-Identifier: MIT
// What the caller gives of a domain.
#pragma once

#include <cstdint>

#include "platform/memory.hpp"

namespace mgdt {

struct DomainInput {
    explicit DomainInput(Allocator& allocator)
        : points(allocator),
          facet_begin(allocator),
          corners(allocator),
          facet_markers(allocator),
          facet_origins(allocator),
          segments(allocator),
          segment_markers(allocator),
          segment_origins(allocator),
          regions(allocator),
          holes(allocator) {}

    std::size_t point_count() const noexcept { return points.size() / 3; }
    std::size_t facet_count() const noexcept {
        return facet_begin.empty() ? 0 : facet_begin.size() - 1;
    }
    std::size_t segment_count() const noexcept { return segments.size() / 2; }
    // The numbers by which the caller knows a facet or a segment.
    std::uint32_t facet_origin(std::uint32_t f) const noexcept {
        return facet_origins.empty() ? f : facet_origins[f];
    }
    std::uint32_t segment_origin(std::uint32_t s) const noexcept {
        return segment_origins.empty() ? s : segment_origins[s];
    }

    // A place inside a region, and the marker of the region. Holes have no marker.
    struct Place {
        double x[3];
        std::int32_t marker;
    };

    Buffer<double> points;  // 3 coordinates for each
    // The corners of facet i are corners[facet_begin[i]] to corners[facet_begin[i + 1] - 1].
    Buffer<std::uint32_t> facet_begin, corners;
    Buffer<std::int32_t> facet_markers;
    Buffer<std::uint32_t> facet_origins;  // empty if facets are as the caller has set them
    Buffer<std::uint32_t> segments;       // 2 points for each
    Buffer<std::int32_t> segment_markers;
    Buffer<std::uint32_t> segment_origins;  // the same
    Buffer<Place> regions, holes;
};

}  // namespace mgdt
