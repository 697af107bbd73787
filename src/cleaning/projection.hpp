// SPDX-License-Identifier: MIT
// A plane of two coordinates, onto which nearly flat triangles are projected.
#pragma once

#include <cmath>
#include <cstdlib>

#include "predicates/predicates.hpp"
#include "predicates/vector.hpp"

namespace mgdt {

class Projection {
  public:
    Projection() = default;
    explicit Projection(int axis) : u_((axis + 1) % 3), v_((axis + 2) % 3) {}
    // Along the axis that is nearest to a normal.
    explicit Projection(const Vector<double>& normal) {
        int axis = 0;
        for (int k = 1; k < 3; ++k)
            if (std::fabs(normal.x[k]) > std::fabs(normal.x[axis])) axis = k;
        u_ = (axis + 1) % 3;
        v_ = (axis + 2) % 3;
    }

    // The sign of the area of the projected triangle abc, exactly: that of its orientation with a
    // point above.
    int turn(const double* a, const double* b, const double* c) const {
        const double pa[3] = {a[u_], a[v_], 0}, pb[3] = {b[u_], b[v_], 0},
                     pc[3] = {c[u_], c[v_], 0}, above[3] = {a[u_], a[v_], 1};
        return orientation(pa, pb, pc, above);
    }

  private:
    int u_ = 0, v_ = 1;
};

}  // namespace mgdt
