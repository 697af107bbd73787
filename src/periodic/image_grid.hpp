// SPDX-License-Identifier: MIT
// A grid on which the images of points in a periodic box are exact: a power of two for each axis,
// of which all coordinates of points and of the vectors of the box are multiples.
#pragma once

#include <algorithm>
#include <cmath>

#include "periodic/box_lattice.hpp"

namespace mgdt {

// How far points reach in the directions in which a box is not periodic.
class PointReach {
  public:
    explicit PointReach(const BoxLattice& lattice) : lattice_(lattice) {}

    // Returns false if the point is too far away from the box.
    bool add(const double* x);
    // The largest coordinate that a point can have along an axis when it is within the box.
    double largest(unsigned axis) const { return largest_[axis]; }
    // No point is farther from the span of the box's vectors.
    double height() const { return height_; }

  private:
    const BoxLattice& lattice_;
    double largest_[3] = {};
    double height_ = 0;
};

class ImageGrid {
  public:
    // Coordinates are rounded to at most 2^-47 of the size of the box along an axis, or of the
    // extent of the points where that is larger, or to 2^-900 of the whole box. An axis in whose
    // direction the lattice does not extend has no grid. Throws MGDT_ERR_INVALID_ARGUMENT if the
    // rounded vectors do not span, or hardly.
    ImageGrid(const BoxLattice& lattice, const PointReach& reach);

    // The lattice of the rounded vectors. Places on the grid have its exponent.
    const BoxLattice& lattice() const { return lattice_; }
    // Rounds a point of the caller to the grid, and moves it into the box by multiples of the
    // basis. The box is the half-open parallelepiped of the basis, which has exactly one image of
    // each point. The rounded point is `wrapped` plus `taken` times the basis. Returns false if the
    // point is more than `farthest` boxes away.
    bool wrap(const double* x, double* wrapped, Multiples& taken) const;
    // Rounds a point of the caller to the grid.
    void round(const double* x, double* rounded) const;
    // The point x plus k times the basis. The result is exact if x is in the box and no multiple
    // exceeds 8.
    void image(const double* x, const Multiples& k, double* to) const {
        for (unsigned c = 0; c < 3; ++c) {
            const double step = k[0] * basis_[0][c] + k[1] * basis_[1][c] + k[2] * basis_[2][c];
            to[c] = x[c] + step;
        }
    }
    // The step of the grid along an axis, or 0 if coordinates along this axis are not rounded.
    double unit(unsigned axis) const { return unit_[axis]; }
    // An upper bound of the magnitudes of the coordinates of points in the box, and of images by
    // multiples of at most 4.
    double size() const { return size_; }

    static constexpr double farthest = 0x1p29;

  private:
    void set_units(const PointReach& reach);
    bool is_below(unsigned k, const double* x, bool from_the_far_side) const;
    void reduce(const double* x, const Multiples& k, double* to) const;

    BoxLattice lattice_;
    double basis_[3][3] = {};  // zeros for the vectors that a slab or a wire lacks
    double unit_[3] = {}, per_unit_[3] = {};
    double margin_[3] = {};  // a point with coordinates from this to 1 - this is in the box
    double size_ = 0;
    int handedness_ = 0;
};

}  // namespace mgdt
