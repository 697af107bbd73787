// SPDX-License-Identifier: MIT
// The floating-point filter: a determinant evaluated in doubles, with an error bound from the same
// formula with all terms positive. docs/theory.md derives the constants.
#pragma once

#include <cmath>

#include "predicates/differences.hpp"

namespace mgdt::exact {

// The error of a determinant D is at most relative * P + underflow * (1 + m^3), where P is the
// value with all terms positive and m the largest difference.
struct Bound {
    double relative;
    double underflow;
};

// This bound is far more than underflow can lose. It is a normal number, since arithmetic with
// subnormals is slow.
constexpr double underflow_bound = 0x1p-1000;

constexpr double half_ulp = 0x1p-53;
constexpr Bound collinear_bound{5 * half_ulp, underflow_bound};
constexpr Bound distance_bound{7 * half_ulp, underflow_bound};
constexpr Bound orientation_bound{9 * half_ulp, underflow_bound};
constexpr Bound edge_bound{13 * half_ulp, underflow_bound};
constexpr Bound sphere_bound{17 * half_ulp, underflow_bound};

// If a difference is above this limit, a determinant of degree 5 might overflow.
constexpr double filter_limit = 0x1p200;

// A magnitude. Evaluating the formula of a determinant over this type makes all terms positive,
// which gives the value P of Bound.
struct Magnitude {
    double value;
};

MGDT_PREDICATES_INLINE Magnitude operator+(Magnitude a, Magnitude b) {
    return {a.value + b.value};
}
MGDT_PREDICATES_INLINE Magnitude operator-(Magnitude a, Magnitude b) {
    return {a.value + b.value};
}
MGDT_PREDICATES_INLINE Magnitude operator*(Magnitude a, Magnitude b) {
    return {a.value * b.value};
}

// The sign of a determinant, or `undecided`. `value` is the computed determinant D; `size` is P and
// m is the largest difference (see Bound).
MGDT_PREDICATES_INLINE int filtered_value(double value, double size, double m, const Bound& bound) {
    const double error = bound.relative * size + bound.underflow * (1 + m * m * m);
    return std::fabs(value) > error ? 1 - 2 * std::signbit(value) : undecided;
}

// The value P (see Bound) of polynomial(d).
template <int N, class Polynomial>
MGDT_PREDICATES_INLINE double size_of(const Differences<N>& d, const Polynomial& polynomial) {
    Magnitude size[N];
    each<N>([&](auto i) { size[i].value = std::fabs(d.rounded[i]); });
    return polynomial(size).value;
}

// The sign of polynomial(d), or `undecided`.
template <int N, class Polynomial>
MGDT_PREDICATES_INLINE int filtered(const Differences<N>& d, const Bound& bound,
                                    const Polynomial& polynomial) {
    if (!(d.largest <= filter_limit)) return undecided;
    return filtered_value(polynomial(d.rounded), size_of(d, polynomial), d.largest, bound);
}

}  // namespace mgdt::exact
