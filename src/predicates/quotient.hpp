// SPDX-License-Identifier: MIT
// The ratio of two integers as a double that is rounded once.
#pragma once

#include <cmath>

#include "predicates/integer.hpp"

namespace mgdt::exact {

// n / d * 2^exponent, rounded to nearest, ties to even; infinite beyond the largest double. d is
// not 0. The limbs are in two's complement and are overwritten; `rest` has room for d_size limbs.
double rounded_quotient(Limb* n, int n_size, Limb* d, int d_size, Limb* rest, int exponent);

template <int A, int B>
MGDT_PREDICATES_APART double rounded_quotient(const Integer<A>& n, const Integer<B>& d,
                                              int exponent) {
    Limb of_n[limb_count(A)], of_d[limb_count(B)], rest[limb_count(B)];
    to_limbs(n, of_n);
    to_limbs(d, of_d);
    return rounded_quotient(of_n, limb_count(A), of_d, limb_count(B), rest, exponent);
}

// The ratio of two rounded numbers. It has three roundings, and one more if it is subnormal.
inline double quotient(const Rounded& a, const Rounded& b) {
    return a.value == 0 ? 0 : std::ldexp(a.value / b.value, a.exponent - b.exponent);
}

}  // namespace mgdt::exact
