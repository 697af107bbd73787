// SPDX-License-Identifier: MIT
// The volume of a tetrahedron in doubles, with a bound on its error.
#pragma once

#include <cmath>

#include "predicates/vector.hpp"

namespace mgdt {

// An upper bound on the error of six times the volume of a tetrahedron, as rounded_volume()
// computes it from rounded edges, relative to the same sum with all terms positive (docs/theory.md,
// "The quality of a tetrahedron").
constexpr double volume_error = 9 * 0x1p-53;
// What underflow can lose of a volume is below this, and what is below it counts as nothing.
constexpr double least_product = 0x1p-1000;

// Six times the volume of the tetrahedron with the edges u, v and w at a corner, positive if it is
// positively oriented. `size` is the same sum with all terms positive.
inline double rounded_volume(const Vector<double>& u, const Vector<double>& v,
                             const Vector<double>& w, double& size) noexcept {
    const auto minor = [&](int i, int j) { return v.x[i] * w.x[j] - v.x[j] * w.x[i]; };
    const auto minor_size = [&](int i, int j) {
        return std::fabs(v.x[i] * w.x[j]) + std::fabs(v.x[j] * w.x[i]);
    };
    size = (std::fabs(u.x[0]) * minor_size(1, 2) + std::fabs(u.x[1]) * minor_size(2, 0)) +
           std::fabs(u.x[2]) * minor_size(0, 1);
    return (u.x[0] * minor(1, 2) + u.x[1] * minor(2, 0)) + u.x[2] * minor(0, 1);
}

}  // namespace mgdt
