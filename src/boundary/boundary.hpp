// SPDX-License-Identifier: MIT
// What bounds a domain: triangles, segments, and points that belong to neither.
#pragma once

#include "boundary/box_tree.hpp"
#include "boundary/simplex_pair.hpp"
#include "platform/memory.hpp"

namespace mgdt {

// The box of the corners of a simplex.
BoundingBox box_of(const Simplex& s) noexcept;

struct Boundary {
    explicit Boundary(Allocator& allocator)
        : points(allocator), triangles(allocator), segments(allocator), lone_points(allocator) {}

    // Simplices are numbered: first the triangles, then the segments, then the lone points.
    std::size_t size() const noexcept {
        return triangles.size() / 3 + segments.size() / 2 + lone_points.size();
    }
    Simplex simplex(std::size_t i) const noexcept;
    BoundingBox box(std::size_t i) const noexcept;

    Buffer<double> points;              // 3 coordinates for each point; no two points are equal
    Buffer<std::uint32_t> triangles;    // 3 points for each
    Buffer<std::uint32_t> segments;     // 2 points for each
    Buffer<std::uint32_t> lone_points;  // the points that no triangle or segment has
};

// The boxes of all simplices, each larger by `margin` on all sides. Refuses more simplices than can
// be numbered.
Buffer<BoundingBox> boxes_of(const Boundary& boundary, double margin, Team& team,
                             Allocator& allocator);

// Sets the lone points.
void find_lone_points(Boundary& boundary, Allocator& allocator);

}  // namespace mgdt
