// SPDX-License-Identifier: MIT
// A grid on which the images of points in a periodic box are exact: a power of two for each axis,
// of which all coordinates of points and of the vectors of the box are multiples.
#pragma once

#include "periodic/box_lattice.hpp"

namespace mgdt {

class ImageGrid {
  public:
    // Bounds of the coordinates that points have when they are within the box.
    struct Bounds {
        double largest[3] = {};
    };

    // Coordinates are rounded to at most 2^-48 of the size of the box, or of the extent of the
    // points where that is larger. An axis in whose direction the lattice does not extend has no
    // grid. Throws MGDT_ERR_INVALID_ARGUMENT if the rounded vectors do not span.
    ImageGrid(const BoxLattice& lattice, const Bounds& bounds);

    // Rounds a point to the grid and moves it into the box by multiples of the lattice's basis. The
    // box is the half-open parallelepiped of the basis, which has exactly one image of each point.
    // The rounded point is `wrapped` plus `taken` times the basis. Returns false if the point is
    // more than `farthest` boxes away.
    bool wrap(const double* x, double* wrapped, Multiples& taken) const;
    // The point x plus k times the basis. Exact for multiples up to 8, and points in the box.
    void image(const double* x, const Multiples& k, double* to) const {
        for (unsigned c = 0; c < 3; ++c) {
            const double step = k[0] * basis_[0][c] + k[1] * basis_[1][c] + k[2] * basis_[2][c];
            to[c] = x[c] + step;
        }
    }
    // The distance of two neighbouring coordinates of an axis, or 0 if they are not rounded.
    double unit(unsigned axis) const { return unit_[axis]; }
    // The rounded vectors, with zeros for those that a slab or a wire lacks.
    const double* vector(unsigned k) const { return basis_[k]; }

    static constexpr double farthest = 0x1p30;

  private:
    bool is_below(unsigned k, const double* x, bool from_the_far_side) const;
    void reduce(const double* x, const Multiples& k, double* to) const;

    const BoxLattice& lattice_;
    double basis_[3][3] = {};
    double spanning_[3][3] = {};  // the same, with vectors of the complement
    double unit_[3] = {}, per_unit_[3] = {};
    double margin_[3] = {};  // a point with coordinates from this to 1 - this is in the box
    int handedness_ = 0;
};

// Where a point is in units of the box, near enough to find bounds: the fractional parts of its
// coordinates along the vectors of the lattice, multiplied with these, and the rest.
void add_wrapped(const BoxLattice& lattice, const double* x, ImageGrid::Bounds& bounds);

}  // namespace mgdt
