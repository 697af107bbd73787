// SPDX-License-Identifier: MIT
// A point inside a tetrahedron that is on no plane through three given points. It is infinitely
// close to the first vertex, displaced towards the second, infinitely less towards the third, and
// so on. It needs no coordinates of its own, so there is one in every tetrahedron, however flat.
#pragma once

#include "predicates/predicates.hpp"

namespace mgdt {

class InteriorPoint {
  public:
    // The interior point of the tetrahedron with these vertices, which must span space.
    InteriorPoint(const double* a, const double* b, const double* c, const double* d)
        : v_{a, b, c, d} {}

    // orientation(a, b, c, this point). It is never 0 if a, b and c span a plane: orientation is
    // affine in its last argument, so the first vertex off the plane decides.
    int orientation_from(const double* a, const double* b, const double* c) const {
        for (const double* v : v_)
            if (const int side = orientation(a, b, c, v)) return side;
        return 0;
    }
    // Whether the point is inside the positively oriented tetrahedron p.
    bool is_in(const double* const (&p)[4]) const {
        // Most tetrahedra are far from the first vertex; comparisons of coordinates rule them out.
        for (int k = 0; k < 3; ++k) {
            const double x = v_[0][k];
            if (p[0][k] < x && p[1][k] < x && p[2][k] < x && p[3][k] < x) return false;
            if (p[0][k] > x && p[1][k] > x && p[2][k] > x && p[3][k] > x) return false;
        }
        return orientation_from(p[0], p[1], p[2]) > 0 && orientation_from(p[0], p[2], p[3]) > 0 &&
               orientation_from(p[0], p[3], p[1]) > 0 && orientation_from(p[1], p[3], p[2]) > 0;
    }

  private:
    const double* v_[4];
};

}  // namespace mgdt
