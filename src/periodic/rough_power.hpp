// SPDX-License-Identifier: MIT
// The power of points with respect to a sphere, in doubles, with bounds on its error and its least
// value in a box.
#pragma once

#include <algorithm>
#include <cmath>

#include "mesh/bounding_box.hpp"

namespace mgdt {

// With u = x - base for a point `base` on the sphere, the power of x is u . (u - w), where w is
// twice the centre relative to the base. Unlike a distance from the centre, it is accurate for
// small u however large the sphere is. docs/theory.md, "Periodic boxes", derives the error.
class RoughPower {
  public:
    // Coordinates of w have errors of at most 2^-50 of the largest.
    RoughPower(const double* base, const double* w)
        : base_{base[0], base[1], base[2]},
          w_{w[0], w[1], w[2]},
          largest_(std::max({std::fabs(w[0]), std::fabs(w[1]), std::fabs(w[2])})) {}

    double of(const double* x) const {
        double sum = 0;
        for (unsigned c = 0; c < 3; ++c) {
            const double u = x[c] - base_[c];
            sum += u * (u - w_[c]);
        }
        return sum;
    }
    // An upper bound of the error of of(x).
    double error_at(const double* x) const {
        double size = 0;
        for (unsigned c = 0; c < 3; ++c) size += std::fabs(x[c] - base_[c]);
        return error_of(size);
    }
    // A lower bound of of(x) over all points x of the box, up to rounding.
    double least_in(const BoundingBox& box) const {
        double sum = 0;
        for (unsigned c = 0; c < 3; ++c) {
            const double from = box.low[c] - base_[c], to = box.high[c] - base_[c],
                         u = std::min(std::max(from, 0.5 * w_[c]), to);
            sum += u * (u - w_[c]);
        }
        return sum;
    }
    // An upper bound of error_at(x) for all points x of the box, and of the error of least_in() for
    // each box within this one.
    double error_in(const BoundingBox& box) const {
        double size = 0;
        for (unsigned c = 0; c < 3; ++c)
            size += std::max(std::fabs(box.low[c] - base_[c]), std::fabs(box.high[c] - base_[c]));
        return error_of(size);
    }

  private:
    // `size` is the sum of the magnitudes of the coordinates of u.
    double error_of(double size) const { return 0x1p-48 * size * (size + largest_); }

    double base_[3], w_[3], largest_;
};

}  // namespace mgdt
