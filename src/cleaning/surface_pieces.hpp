// SPDX-License-Identifier: MIT
// The facets and segments of a domain while they are cleaned: triangles and segments, each of which
// is a part of one of the caller's.
#pragma once

#include "boundary/complex.hpp"
#include "platform/no_index.hpp"

namespace mgdt {

struct SurfacePieces {
    explicit SurfacePieces(Allocator& allocator)
        : boundary(allocator),
          facet_of_triangle(allocator),
          patch_of_triangle(allocator),
          is_new(allocator),
          source_of_segment(allocator) {}

    const double* point(std::uint32_t v) const noexcept {
        return boundary.points.begin() + 3 * std::size_t{v};
    }
    const std::uint32_t* triangle(std::uint32_t t) const noexcept {
        return boundary.triangles.begin() + 3 * std::size_t{t};
    }
    std::size_t triangle_count() const noexcept { return boundary.triangles.size() / 3; }
    // Adds a triangle, which is not in a patch yet.
    void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t facet,
                      std::uint8_t new_one) {
        for (const std::uint32_t v : {a, b, c}) boundary.triangles.push_back(v);
        facet_of_triangle.push_back(facet);
        patch_of_triangle.push_back(no_index);
        is_new.push_back(new_one);
    }
    void add_segment(std::uint32_t a, std::uint32_t b, std::uint32_t source) {
        for (const std::uint32_t v : {a, b}) boundary.segments.push_back(v);
        source_of_segment.push_back(source);
    }

    Boundary boundary;
    Buffer<std::uint32_t> facet_of_triangle;
    Buffer<std::uint32_t> patch_of_triangle;  // patches.hpp
    Buffer<std::uint8_t> is_new;  // whether a triangle has been made by the current round
    Buffer<std::uint32_t> source_of_segment;
};

}  // namespace mgdt
