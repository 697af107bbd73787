// SPDX-License-Identifier: MIT
// Differences of coordinates, with which every predicate begins. The filters use differences that
// are rounded to doubles. The exact stages use differences as integers of a common unit.
#pragma once

#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <type_traits>
#include <utility>

#include "platform/strict.hpp"
#include "predicates/integer.hpp"

namespace mgdt::exact {

static_assert(std::numeric_limits<double>::is_iec559 && FLT_EVAL_METHOD == 0,
              "the bounds assume IEEE doubles without excess precision");

MGDT_PREDICATES_INLINE std::uint64_t bits_of(double v) {
    std::uint64_t bits;
    std::memcpy(&bits, &v, sizeof bits);
    return bits;
}

MGDT_PREDICATES_INLINE double double_of(std::uint64_t bits) {
    double v;
    std::memcpy(&v, &bits, sizeof v);
    return v;
}

constexpr std::uint64_t exponent_mask = 0x7ff0000000000000;
constexpr std::uint64_t fraction_mask = 0x000fffffffffffff;

// The value that a stage returns instead of a sign if it cannot decide.
constexpr int undecided = 2;

template <std::size_t I>
using index = std::integral_constant<std::size_t, I>;

template <class F, std::size_t... I>
MGDT_PREDICATES_INLINE void each(const F& f, std::index_sequence<I...>) {
    (f(index<I>()), ...);
}

// f(0), ..., f(N - 1) with constant indices, so that small arrays become registers.
template <int N, class F>
MGDT_PREDICATES_INLINE void each(const F& f) {
    each(f, std::make_index_sequence<static_cast<std::size_t>(N)>());
}

// The differences between N / 3 points and an origin, which have finite coordinates. The order is
// x, y, z of the first point, then of the second, and so on.
template <int N>
struct Differences {
    const double* point[N / 3];
    const double* origin;
    double rounded[N];
    double largest;  // the largest magnitude among `rounded`
};

// The largest magnitude of v[From] to v[To - 1], by a tree of maxima: a chain of them would have to
// wait for each result.
template <int From, int To>
MGDT_PREDICATES_INLINE double largest_of(const double* v) {
    if constexpr (To - From == 1) {
        return std::fabs(v[From]);
    } else {
        const double a = largest_of<From, (From + To) / 2>(v);
        const double b = largest_of<(From + To) / 2, To>(v);
        return a > b ? a : b;
    }
}

template <int Points>
MGDT_PREDICATES_INLINE Differences<3 * Points> differences(const double* const (&p)[Points],
                                                           const double* origin) {
    Differences<3 * Points> d;
    for (int i = 0; i < Points; ++i) d.point[i] = p[i];
    d.origin = origin;
    each<3 * Points>([&](auto i) { d.rounded[i] = p[i / 3][i % 3] - origin[i % 3]; });
    d.largest = largest_of<0, 3 * Points>(d.rounded);
    return d;
}

// Decomposes v into an integer mantissa times 2^exponent.
inline void take_apart(double v, std::int64_t& mantissa, int& exponent) {
    const std::uint64_t bits = bits_of(v);
    const int biased = static_cast<int>((bits & exponent_mask) >> 52);
    const std::uint64_t size = (bits & fraction_mask) | (biased != 0 ? std::uint64_t{1} << 52 : 0);
    mantissa = static_cast<std::int64_t>(size);
    if (bits >> 63) mantissa = -mantissa;
    exponent = (biased != 0 ? biased : 1) - 1075;
}

inline int trailing_zeros(std::uint64_t v) {
#if defined(__GNUC__)
    return __builtin_ctzll(v);
#else
    int n = 0;
    for (; (v & 1U) == 0; v >>= 1) ++n;
    return n;
#endif
}

// N differences, each an exact sum of two doubles, and the range of their bits: all are multiples
// of 2^low and smaller than 2^high in magnitude.
template <int N>
struct ExactPairs {
    double first[N];
    double second[N];
    int low = 2000;
    int high = -2000;

    // The Bits of an Integer<Bits> that holds every difference in units of 2^low.
    int bits() const { return high - low + 2; }

    template <int Bits>
    Integer<Bits> get(std::size_t i) const {
        const Integer<Bits> a = as_integer<Bits>(first[i]);
        const Integer<Bits> b = as_integer<Bits>(second[i]);
        return narrowed<Bits>(a + b);
    }

    // Sets difference i to a - b, by Knuth's two-sum. If the two-sum would overflow, the two parts
    // are a and -b.
    void set(std::size_t i, double a, double b) {
        const double rounded = a - b;
        const double b_virtual = a - rounded;
        const double a_virtual = rounded + b_virtual;
        const double error = (a - a_virtual) + (b_virtual - b);
        const bool finite = (bits_of(rounded) & exponent_mask) != exponent_mask &&
                            (bits_of(error) & exponent_mask) != exponent_mask;
        first[i] = finite ? rounded : a;
        second[i] = finite ? error : -b;
        cover(first[i]);
        cover(second[i]);
    }

  private:
    void cover(double v) {
        if (v == 0) return;
        std::int64_t mantissa;
        int exponent;
        take_apart(v, mantissa, exponent);
        const int top = exponent + 53;
        const int bottom = exponent + trailing_zeros(static_cast<std::uint64_t>(mantissa));
        if (top > high) high = top;
        if (bottom < low) low = bottom;
    }

    template <int Bits>
    Integer<Bits> as_integer(double v) const {
        if (v == 0) return shifted<Bits>(0, 0);
        std::int64_t mantissa;
        int exponent;
        take_apart(v, mantissa, exponent);
        return shifted<Bits>(mantissa, exponent - low);
    }
};

// The exact differences between points and an origin: x, y, z of the first point first.
template <int N>
struct ExactDifferences : ExactPairs<N> {
    static constexpr int count = N;

    ExactDifferences(const double* const (&p)[N / 3], const double* origin) {
        for (std::size_t i = 0; i < N; ++i) this->set(i, p[i / 3][i % 3], origin[i % 3]);
    }
};

// Like ExactDifferences, but with a separate unit for each axis. This is for results that are
// ratios of determinants, in which a common factor of a column cancels.
template <int N>
struct ExactDifferencesByAxis {
    static constexpr int count = N;
    ExactPairs<N / 3> axis[3];

    ExactDifferencesByAxis(const double* const (&p)[N / 3], const double* origin) {
        for (std::size_t i = 0; i < N; ++i) axis[i % 3].set(i / 3, p[i / 3][i % 3], origin[i % 3]);
    }

    int bits() const {
        const int x = axis[0].bits(), y = axis[1].bits(), z = axis[2].bits();
        return x > y ? (x > z ? x : z) : (y > z ? y : z);
    }

    template <int Bits>
    Integer<Bits> get(std::size_t i) const {
        return axis[i % 3].template get<Bits>(i / 3);
    }
};

// Widths of the integers for the general case. With Bits = 64 k - 1, the products of a determinant
// of degree 5 fill 5 k limbs completely. The last width holds every difference of doubles: 1024 +
// 1074 + 2 = 2100 bits.
constexpr int widths[] = {63, 127, 255, 511, 1023, 2111};
// Up to this width, integers are faster than twofold numbers with bounds, and they always decide.
constexpr int short_width = 63;

// Calls polynomial with the differences as integers of this width. The function is not inlined, so
// that the stack holds the integers of one width only.
template <int Bits, class Exact, class Polynomial>
MGDT_PREDICATES_APART int with_integers_of(const Exact& d, const Polynomial& polynomial) {
    Integer<Bits> v[Exact::count];
    for (std::size_t i = 0; i < Exact::count; ++i) v[i] = d.template get<Bits>(i);
    return polynomial(v);
}

// Calls polynomial with the differences as integers of the smallest width that holds them and is at
// least `least`.
template <int Index = 0, class Exact, class Polynomial>
inline int with_integers(const Exact& d, int least, const Polynomial& polynomial) {
    constexpr int bits = widths[Index];
    constexpr bool last = Index + 1 == sizeof widths / sizeof *widths;
    if constexpr (!last) {
        if (d.bits() > bits || least > bits) {
            return with_integers<Index + 1>(d, least, polynomial);
        }
    }
    return with_integers_of<bits>(d, polynomial);
}

}  // namespace mgdt::exact
