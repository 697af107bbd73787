// SPDX-License-Identifier: MIT
// How flat tetrahedra are.
#pragma once

#include <cmath>

namespace mgdt {

// How flat a positive tetrahedron is: the cube of its size over its volume.
inline double flatness_of(const double* a, const double* b, const double* c,
                          const double* d) noexcept {
    const double* const x[3] = {b, c, d};
    double e[3][3], size = 0;
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            e[i][k] = x[i][k] - a[k];
            size += e[i][k] * e[i][k];
        }
    const double volume = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
                          e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
                          e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
    const double relative = std::fabs(volume) / (size * std::sqrt(size));
    return relative > 1e-300 ? 1 / relative : 1e300;
}

}  // namespace mgdt
