// SPDX-License-Identifier: MIT
// The area and the centroid of a Voronoi face.
#pragma once

#include "dual/half_spaces.hpp"
#include "mesh/scale.hpp"
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
    // The area and its error carry the mesh's scale. If the area is infinite or 0 because it is
    // outside of the range of doubles, its error is at least the least normal double.
    double area, area_error;
    Vector<double> centroid;  // relative to the point of the cell
    double centroid_error;
    double reach;  // the distance of the farthest corner from the point of the cell
    // The results in the caller's scale.
    double unscaled_area;
    Vector<double> unscaled_centroid;
};

// Whether area and centroid are accurate enough for the result. docs/theory.md, "Voronoi faces",
// has the bounds.
bool is_accurate(const FaceMeasure& measure, const FacePlane& plane);

// Measures a face of the cell of point a. Its corners are counter-clockwise about the normal, and
// their corrections carry the factor 1 / unit. If doubles do not suffice, the errors are infinite.
// The function does not set the results in the caller's scale.
FaceMeasure measure_face(const double* a, const FacePlane& plane, const SplitPoint* const* corners,
                         std::size_t n, double unit);

// Measures a face from the planes of its edges, as accurately as is_accurate() demands. Half-space
// 0 has the plane of the face, and half-spaces 1 to n have the n edges, in their order about the
// normal. The origin of the half-spaces is the point of the cell.
FaceMeasure measure_exactly(Allocator& allocator, HalfSpaces& half_spaces, std::size_t n,
                            const FacePlane& plane, int scale);

// Measures a face by measure_face(); if the result is not accurate, by measure_exactly().
// add_half_spaces() adds the half-spaces of the face, and returns the number of its edges.
template <class AddHalfSpaces>
FaceMeasure measure_accurately(HalfSpaces& half_spaces, const double* a, const FacePlane& plane,
                               const Buffer<const SplitPoint*>& corners, double unit, int scale,
                               AddHalfSpaces add_half_spaces) {
    FaceMeasure result = measure_face(a, plane, corners.data(), corners.size(), unit);
    if (is_accurate(result, plane)) {
        result.unscaled_area = scale == 0 ? result.area : std::ldexp(result.area, -2 * scale);
        for (int k = 0; k < 3; ++k)
            result.unscaled_centroid.x[k] = scaled(result.centroid.x[k], -scale);
        return result;
    }
    half_spaces.clear(a, 1);
    const std::size_t edges = add_half_spaces();
    return measure_exactly(corners.allocator(), half_spaces, edges, plane, scale);
}

}  // namespace mgdt
