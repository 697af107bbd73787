// SPDX-License-Identifier: MIT
// The boundary that a caller's points, facets and segments make.
#pragma once

#include "boundary/boundary.hpp"
#include "boundary/input.hpp"

namespace mgdt {

struct Complex {
    explicit Complex(Allocator& allocator)
        : boundary(allocator),
          number_of_point(allocator),
          point_of_number(allocator),
          facet_of_triangle(allocator),
          markers(allocator),
          bad_facets(allocator) {}

    Boundary boundary;                        // of distinct points
    Buffer<std::uint32_t> number_of_point;    // the distinct point of each of the caller's
    Buffer<std::uint32_t> point_of_number;    // the least of the caller's points at each
    Buffer<std::uint32_t> facet_of_triangle;  // the facet that each triangle is a part of
    Buffer<std::int32_t> markers;             // of each triangle
    Buffer<std::uint32_t> bad_facets;  // facets that are no polygons and have no triangles; sorted
};

// Whether no two points are equal.
bool are_distinct(const Buffer<double>& points, Allocator& allocator);

// Makes the complex of an input: joins equal points, and divides facets into triangles. Facets have
// the numbers by which the caller knows them.
Complex make_complex(const DomainInput& input, Allocator& allocator);
// The same with other coordinates of the points, and with the numbers that facets have in the
// input.
Complex make_complex(const Buffer<double>& points, const DomainInput& input, Allocator& allocator);

}  // namespace mgdt
