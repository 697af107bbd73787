// SPDX-License-Identifier: MIT
// The grid to which the points of a domain are rounded.
#pragma once

#include "platform/memory.hpp"

namespace mgdt {

// Rounds points so that segments between them have many points whose coordinates are doubles,
// exactly: the coordinates of rounded points are multiples of a step, a power of two, and at most
// 2^bits steps. A coarser grid leaves more such points on each segment (docs/theory.md, "Points on
// segments").
class RoundingGrid {
  public:
    // The bits of the grid that is tried first. It is fine enough for nearly all surfaces, and has
    // enough points on segments.
    static constexpr int usual_bits = 36;
    static constexpr int least_bits = 24, most_bits = 44;
    // As the number of bits: points are not rounded, and the step is 1.
    static constexpr int no_rounding = 0;
    // Points of segments are multiples of 2^-digits steps, which are doubles as well.
    static constexpr int digits = 36;

    // The grid for points with these coordinates.
    RoundingGrid(const Buffer<double>& coordinates, int bits) noexcept;
    // The grid for points whose largest coordinate has this magnitude, which is finite.
    RoundingGrid(double largest, int bits) noexcept;

    int bits() const noexcept { return bits_; }

    // The number of steps, an integer, whose product with the step is nearest to x.
    double round(double x) const noexcept;
    // x over the step.
    double scaled(double x) const noexcept;
    // Converts a place to steps. Returns false if the place is so far from the grid that no
    // tetrahedron can contain it; further computations with it might overflow.
    bool scale_place(const double (&x)[3], double (&result)[3]) const noexcept;
    // The product of the step and a coordinate in steps.
    double unround(double x) const noexcept;

  private:
    int bits_;
    int exponent_;  // the step is 2^exponent_
};

}  // namespace mgdt
