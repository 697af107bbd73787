// SPDX-License-Identifier: MIT
// The area and the centroid of a Voronoi face.
#pragma once

#include "dual/half_spaces.hpp"
#include "predicates/circumcenter.hpp"

namespace mgdt {

// The plane of a face: the unit normal, the distance of the point of the cell from the plane, and
// an upper bound on the error of that distance. The relative error of the normal is at most
// normal_error.
struct FacePlane {
    Vector<double> normal;
    double distance, distance_error;
    double spacing;  // twice the distance if the plane is a bisector, otherwise 0
};
constexpr double normal_error = 8 * rounding_of<double>;

// The plane that bisects two points.
FacePlane bisector(const double* a, const double* b);

struct FaceMeasure {
    double area, area_error;
    // The centroid relative to the point of the cell, and an upper bound on its error.
    Vector<double> centroid;
    double centroid_error;
};

// Whether the area is accurate enough: the error is at most measure_error times the area, or tiny
// beside the square of the distance between the two points of the face.
bool is_accurate(const FaceMeasure& measure, const FacePlane& plane);

// Measures the face of the cell of point a with these corners, which are counter-clockwise about
// the normal. The corrections of the corners carry the factor 1 / unit. The error is infinite if
// doubles are of no use.
FaceMeasure measure_face(const double* a, const FacePlane& plane, const SplitPoint* const* corners,
                         std::size_t n, double unit);

// Computes the area again, with an error that is_accurate() accepts. Half-space 0 has the plane of
// the face. Half-space i has the edge i - 1, from 1 to n, in the order about the normal.
void measure_exactly(Allocator& allocator, HalfSpaces& half_spaces, std::size_t n,
                     const FacePlane& plane, FaceMeasure& measure);

// Measures a face by measure_face(), and by measure_exactly() if the area is not accurate then.
// add_half_spaces() adds the half-spaces of the face, and returns the number of its edges.
template <class AddHalfSpaces>
FaceMeasure measure_accurately(HalfSpaces& half_spaces, const double* a, const FacePlane& plane,
                               const Buffer<const SplitPoint*>& corners, double unit,
                               AddHalfSpaces add_half_spaces) {
    FaceMeasure result = measure_face(a, plane, corners.data(), corners.size(), unit);
    if (is_accurate(result, plane)) return result;
    half_spaces.clear(a, 1);
    const std::size_t edges = add_half_spaces();
    measure_exactly(corners.allocator(), half_spaces, edges, plane, result);
    return result;
}

}  // namespace mgdt
