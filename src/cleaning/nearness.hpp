// SPDX-License-Identifier: MIT
// What cleaning takes for a common place: points, edges and triangles within a distance of each
// other. With the distance 0 all decisions are exact.
#pragma once

#include "platform/memory.hpp"
#include "predicates/vector.hpp"

namespace mgdt {

class Nearness {
  public:
    // A distance as a share of the size of a set of points, which is the diagonal of its box.
    Nearness(double share, const Buffer<double>& points);

    bool is_exact() const noexcept { return distance_ == 0; }
    // The distance in the units of the points.
    double distance() const noexcept;
    // A point as a vector of ordinary size: multiplied by a power of two, so that no coordinate is
    // larger than 1.
    Vector<double> scaled(const double* x) const noexcept;
    // The normal of the triangle abc, in these units. Its length is twice the area.
    Vector<double> normal(const double* a, const double* b, const double* c) const noexcept {
        const Vector<double> o = scaled(a);
        return cross(scaled(b) - o, scaled(c) - o);
    }
    // The distance in the units of scaled().
    double scaled_distance() const noexcept { return distance_; }

    // Whether p is on the edge ab or near it, and between its ends.
    bool is_on_edge(const double* a, const double* b, const double* p) const;
    // Whether p is in the triangle abc or near it, above or below its inside.
    bool is_in_triangle(const double* a, const double* b, const double* c, const double* p) const;
    // Whether p is certainly not near the plane of abc.
    bool is_apart_from_plane(const double* a, const double* b, const double* c,
                             const double* p) const;
    // Whether p is in the plane of abc or near it.
    bool is_in_plane(const double* a, const double* b, const double* c, const double* p) const;

  private:
    bool is_near(const Vector<double>& foot, const double* p) const;

    int exponent_;     // scaled() multiplies by 2 to the power -exponent_
    double distance_;  // in the units of scaled()
};

}  // namespace mgdt
