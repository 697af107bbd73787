// SPDX-License-Identifier: MIT
// Points of a lattice: if all coordinates are multiples of a power of two, and the differences are
// small multiples, doubles compute determinants without rounding.
#pragma once

#include "predicates/differences.hpp"

namespace mgdt::exact {

// If differences are below 2^bits units, the determinant of degree 3 and its intermediate results
// are below 6 * 2^(3 bits), and those of degree 5 are below 72 * 2^(5 bits). With these bits, both
// bounds are below 2^53.
constexpr int orientation_lattice_bits = 16;
constexpr int sphere_lattice_bits = 9;

// If the largest difference is in this range, products of five differences and the sums in
// is_lattice() are normal numbers.
constexpr double lattice_least = 0x1p-180, lattice_most = 0x1p180;

MGDT_PREDICATES_INLINE int sign_of(double v) {
    return (v > 0) - (v < 0);
}

// 1.5 * 2^52 g, where g is the least power of two for which differences up to `largest` are below
// 2^Bits g. Adding this to a non-negative number rounds it to a multiple of g.
template <int Bits>
MGDT_PREDICATES_INLINE double lattice_shifter(double largest) {
    static_assert(Bits <= 51, "differences of multiples of g must be exact");
    const double power = double_of(bits_of(largest) & exponent_mask);  // largest < 2 power
    constexpr double scale = 1.5 * static_cast<double>(std::uint64_t{1} << (53 - Bits));
    return scale * power;
}

// Whether all coordinates are multiples of the g of lattice_shifter(), so that differences are
// exact.
template <int Bits, int N>
MGDT_PREDICATES_INLINE bool is_lattice(const Differences<N>& d) {
    if (!(d.largest >= lattice_least && d.largest <= lattice_most)) return false;
    const double shifter = lattice_shifter<Bits>(d.largest);
    const auto misfit = [&](double x) {
        const double size = std::fabs(x);
        return std::fabs(((size + shifter) - shifter) - size);
    };
    const auto misfits = [&](const double* p) {
        return (misfit(p[0]) + misfit(p[1])) + misfit(p[2]);
    };
    double sum = misfits(d.origin);
    each<N / 3>([&](auto i) { sum += misfits(d.point[i]); });
    return sum == 0;
}

// The base of the number (x base + y) base + z of a point relative to another one. If coordinates
// are below 2^sphere_lattice_bits units, these numbers have the lexicographic order of the points.
constexpr double sphere_lattice_base = 2 << sphere_lattice_bits;

}  // namespace mgdt::exact
