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
          segments(allocator),
          segment_markers(allocator),
          regions(allocator),
          holes(allocator) {}

    std::size_t point_count() const noexcept { return points.size() / 3; }
    std::size_t facet_count() const noexcept {
        return facet_begin.empty() ? 0 : facet_begin.size() - 1;
    }
    std::size_t segment_count() const noexcept { return segments.size() / 2; }

    // A place inside a region, and the marker of the region. Holes have no marker.
    struct Place {
        double x[3];
        std::int32_t marker;
    };

    Buffer<double> points;  // 3 coordinates for each
    // The corners of facet i are corners[facet_begin[i]] to corners[facet_begin[i + 1] - 1].
    Buffer<std::uint32_t> facet_begin, corners;
    Buffer<std::int32_t> facet_markers;
    Buffer<std::uint32_t> segments;  // 2 points for each
    Buffer<std::int32_t> segment_markers;
    Buffer<Place> regions, holes;
};

}  // namespace mgdt
