// SPDX-License-Identifier: MIT
#include "boundary/complex.hpp"

#include "boundary/polygon.hpp"
#include "platform/error.hpp"
#include "platform/hash.hpp"
#include "platform/number_table.hpp"

namespace mgdt {
namespace {

bool are_equal(const double* a, const double* b) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

// Sets the points of a complex, and their numbers.
void join_equal_points(const Buffer<double>& given, Complex& complex, Allocator& allocator) {
    const std::size_t n = given.size() / 3;
    NumberTable table(allocator);
    table.clear(n);
    complex.number_of_point.resize(n);
    Buffer<double>& points = complex.boundary.points;
    points.reserve(3 * n);
    for (std::uint32_t i = 0; i < n; ++i) {
        const double* const p = given.begin() + 3 * std::size_t{i};
        const std::uint32_t number = table.number(hash_of_coordinates(p), [&](std::uint32_t other) {
            return are_equal(points.begin() + 3 * std::size_t{other}, p);
        });
        complex.number_of_point[i] = number;
        if (number < points.size() / 3) continue;
        for (int k = 0; k < 3; ++k) points.push_back(p[k] + 0.0);
        complex.point_of_number.push_back(i);
    }
}

void divide_facets(const DomainInput& input, Complex& complex, Allocator& allocator) {
    Buffer<std::uint32_t> corners(allocator);
    Buffer<std::uint32_t>& triangles = complex.boundary.triangles;
    for (std::uint32_t f = 0; f < input.facet_count(); ++f) {
        corners.clear();
        for (std::uint32_t i = input.facet_begin[f]; i < input.facet_begin[f + 1]; ++i) {
            // A corner that repeats the one before it is left out.
            const std::uint32_t corner = complex.number_of_point[input.corners[i]];
            if (corners.empty() || corners.back() != corner) corners.push_back(corner);
        }
        while (corners.size() > 1 && corners.back() == corners[0]) corners.pop_back();
        if (!triangulate_polygon(complex.boundary.points.begin(), corners.begin(), corners.size(),
                                 triangles))
            complex.bad_facets.push_back(f);
        while (complex.facet_of_triangle.size() < triangles.size() / 3) {
            complex.facet_of_triangle.push_back(f);
            complex.markers.push_back(input.facet_markers[f]);
        }
        // Corners of triangles are numbered.
        if (triangles.size() >= 0xFFFFFFFFu)
            fail(MGDT_ERR_TOO_LARGE, "the facets have more triangles than can be numbered");
    }
}

}  // namespace

bool are_distinct(const Buffer<double>& points, Allocator& allocator) {
    Complex complex(allocator);
    join_equal_points(points, complex, allocator);
    return complex.point_of_number.size() == points.size() / 3;
}

Complex make_complex(const DomainInput& input, Allocator& allocator) {
    Complex complex = make_complex(input.points, input, allocator);
    for (std::uint32_t& f : complex.facet_of_triangle) f = input.facet_origin(f);
    for (std::uint32_t& f : complex.bad_facets) f = input.facet_origin(f);
    return complex;
}

Complex make_complex(const Buffer<double>& points, const DomainInput& input, Allocator& allocator) {
    Complex complex(allocator);
    join_equal_points(points, complex, allocator);
    divide_facets(input, complex, allocator);
    Boundary& boundary = complex.boundary;
    for (const std::uint32_t end : input.segments)
        boundary.segments.push_back(complex.number_of_point[end]);
    find_lone_points(boundary, allocator);
    return complex;
}

}  // namespace mgdt
