/* SPDX-License-Identifier: MIT
 * What barycentric weights promise: the weighted sum of the vertices is the place. In C99 and
 * C++17. */
#ifndef MGDT_TESTS_REPRODUCTION_H
#define MGDT_TESTS_REPRODUCTION_H

#include <math.h>

/* Whether the weights of q in a tetrahedron with the vertices p are within [0, 1] and give q again.
 * Each coordinate may be wrong by seven roundings of the largest that the vertices have there,
 * three of a weight and four of this sum (docs/theory.md, "Barycentric weights"). */
static inline int reproduces(const double* p[4], const double* q, const double* w) {
    const double rounding = 1 / 9007199254740992.0;                    /* 2^-53 */
    const double underflow = 2.2250738585072014e-308 * (4 * rounding); /* 2^-1073 */
    int i, k;
    for (k = 0; k < 3; ++k) {
        double largest = 0, sum = 0, factor;
        for (i = 0; i < 4; ++i) largest = fmax(largest, fabs(p[i][k]));
        factor = largest > 1e300 ? 0.5 : 1; /* so that no sum overflows */
        for (i = 0; i < 4; ++i) {
            if (!(w[i] >= 0 && w[i] <= 1)) return 0;
            sum += w[i] * (p[i][k] * factor);
        }
        if (!(fabs(sum - q[k] * factor) <= 7.01 * rounding * (largest * factor) + underflow))
            return 0;
    }
    return 1;
}

#endif
