// SPDX-License-Identifier: MIT
// A sum that does not depend on the order of its terms.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

namespace mgdt {

// The sum of n terms whose magnitudes are at most `largest`. Terms are rounded to multiples of a
// power of two, so that the sum of the rounded terms is exact; the remainders are rounded to
// multiples of a smaller power of two (Demmel and Nguyen, Fast reproducible floating-point
// summation, ARITH 21, 2013). The error is at most n^3 2^-102 largest plus the rounding error of
// one addition. The result is infinite if sums may leave the range of doubles.
inline double order_free_sum(const double* terms, std::size_t n, double largest) {
    if (!(largest > 0)) return 0;
    const auto count = static_cast<double>(n);
    if (!(count * largest < 0x1p1000)) return std::numeric_limits<double>::infinity();
    // Adding a number to 3 2^e rounds it to a multiple of 2^(e - 51).
    const auto rounder = [](double bound) { return std::ldexp(3.0, std::ilogb(bound) + 1); };
    const double coarse = rounder(count * largest), fine = rounder(count * std::ldexp(coarse, -53));
    double high = 0, low = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double rounded = (terms[i] + coarse) - coarse, rest = terms[i] - rounded;
        high += rounded;
        low += (rest + fine) - fine;
    }
    return high + low;
}

}  // namespace mgdt
