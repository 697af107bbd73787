// SPDX-License-Identifier: MIT
// Doubles with a separate exponent, which neither overflow nor underflow, and a filter that uses
// them. The filter decides points whose coordinates differ in magnitude by any power of two, where
// plain doubles leave their range. See docs/theory.md, "The ranged filter".
#pragma once

#include "predicates/filter.hpp"

namespace mgdt::exact {

// mantissa * 2^exponent. The mantissa of a coordinate difference is in [1, 2) or 0. Products
// multiply mantissas and add exponents, so mantissas stay near 1 without being normalised.
struct Ranged {
    double mantissa;
    int exponent;
};

// The exponent of 0. It is less than every exponent that a product of five differences can have.
constexpr int exponent_of_zero = -100000;

// 2^-shift for a non-negative shift; 0 if that is far below a unit in the last place.
MGDT_PREDICATES_INLINE double shifted_one(int shift) {
    return shift < 1000 ? double_of(static_cast<std::uint64_t>(1023 - shift) << 52) : 0.0;
}

MGDT_PREDICATES_INLINE Ranged ranged(double x, int exponent = 0) {
    std::uint64_t bits = bits_of(x);
    int biased = static_cast<int>((bits & exponent_mask) >> 52);
    if (biased == 0) {
        if (x == 0) return {0.0, exponent_of_zero};
        bits = bits_of(x * 0x1p64);  // a subnormal number becomes a normal one
        biased = static_cast<int>((bits & exponent_mask) >> 52) - 64;
    }
    return {double_of((bits & ~exponent_mask) | std::uint64_t{1023} << 52),
            biased - 1023 + exponent};
}

MGDT_PREDICATES_INLINE Ranged operator*(Ranged a, Ranged b) {
    return {a.mantissa * b.mantissa, a.exponent + b.exponent};
}
MGDT_PREDICATES_INLINE Ranged operator-(Ranged a) {
    return {-a.mantissa, a.exponent};
}
MGDT_PREDICATES_INLINE Ranged operator+(Ranged a, Ranged b) {
    const bool swap = a.exponent < b.exponent;
    const Ranged high = swap ? b : a, low = swap ? a : b;
    const double sum = high.mantissa + low.mantissa * shifted_one(high.exponent - low.exponent);
    return {sum, sum != 0 ? high.exponent : exponent_of_zero};
}
MGDT_PREDICATES_INLINE Ranged operator-(Ranged a, Ranged b) {
    return a + -b;
}

// The difference of two finite doubles, rounded once.
MGDT_PREDICATES_INLINE Ranged ranged_difference(double a, double b) {
    const double d = a - b;
    // If the difference overflows, it is computed from halves. A half that has to be rounded is too
    // small to matter.
    return std::fabs(d) <= std::numeric_limits<double>::max() ? ranged(d)
                                                              : ranged(a * 0.5 - b * 0.5, 1);
}

// A magnitude. Evaluating the formula of a determinant over this type gives the value with all
// terms positive.
struct RangedMagnitude {
    Ranged value;
};

MGDT_PREDICATES_INLINE RangedMagnitude magnitude(Ranged a) {
    return {{std::fabs(a.mantissa), a.exponent}};
}
MGDT_PREDICATES_INLINE RangedMagnitude operator+(RangedMagnitude a, RangedMagnitude b) {
    return {a.value + b.value};
}
MGDT_PREDICATES_INLINE RangedMagnitude operator-(RangedMagnitude a, RangedMagnitude b) {
    return {a.value + b.value};
}
MGDT_PREDICATES_INLINE RangedMagnitude operator*(RangedMagnitude a, RangedMagnitude b) {
    return {a.value * b.value};
}

// The sign of a value whose error is at most `relative` times `size`, or `undecided`. If the size
// is 0, all terms are 0, and so is the value.
MGDT_PREDICATES_INLINE int ranged_sign(Ranged value, RangedMagnitude size, double relative) {
    if (size.value.mantissa == 0) return 0;
    const Ranged error = size.value * Ranged{relative, 0};
    const Ranged margin = magnitude(value).value - error;
    return margin.mantissa > 0 ? (value.mantissa < 0 ? -1 : 1) : undecided;
}

// The differences between N / 3 points and an origin.
template <int N>
struct RangedDifferences {
    Ranged value[N];
    RangedMagnitude size[N];

    RangedDifferences(const double* const (&p)[N / 3], const double* origin) {
        each<N>([&](auto i) {
            value[i] = ranged_difference(p[i / 3][i % 3], origin[i % 3]);
            size[i] = magnitude(value[i]);
        });
    }
    template <class Polynomial>
    int sign(const Polynomial& polynomial, double relative) const {
        return ranged_sign(polynomial(value), polynomial(size), relative);
    }
};

// The bounds of filter.hpp, for coordinates that are relative to a nearby point.
constexpr double ranged_orientation_bound = 10 * half_ulp;
constexpr double ranged_sphere_bound = 20 * half_ulp;

}  // namespace mgdt::exact
