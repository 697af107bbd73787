// SPDX-License-Identifier: MIT
// Decides conflicts near ties, with the four vertices in one vector: see kernel/ties.hpp. The
// formulas are those of predicates/perturbation.cpp.
#pragma once

#include "kernel/four.hpp"
#include "predicates/lattice.hpp"
#include "predicates/stages.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// a b - c d, or a b + c d if all terms are to be positive.
template <bool Positive>
MGDT_ALWAYS_INLINE Four difference(Four a, Four b, Four cd) {
    return Positive ? multiply_add(a, b, cd) : multiply_subtract(a, b, cd);
}

// The determinants [bcd], [cda], [dab] and [abc] of four rows a, b, c, d, given by columns. These
// are the minors of SphereDeterminant, since even permutations of rows change nothing. With indices
// modulo 4:
//   next[i]   = x[i] y[i+1] - x[i+1] y[i]
//   across[i] = x[i] y[i+2] - x[i+2] y[i]
//   minor[i]  = z[i+1] next[i+2] - z[i+2] across[i+1] + z[i+3] next[i+1]
template <bool Positive>
MGDT_ALWAYS_INLINE Four minors(Four x, Four y, Four z) {
    const Four next = difference<Positive>(x, turned<1>(y), turned<1>(x) * y);
    const Four across = difference<Positive>(x, turned<2>(y), turned<2>(x) * y);
    return multiply_add(
        turned<3>(z), turned<1>(next),
        difference<Positive>(turned<1>(z), turned<2>(next), turned<2>(z) * turned<1>(across)));
}

// The coefficients of |a|^2, |b|^2, |c|^2 and |d|^2 in the determinant. Their signs alternate, so
// the second and the fourth minor are negated.
MGDT_ALWAYS_INLINE Four coefficients(Four x, Four y, Four z) {
    return with_sign_changed(minors<false>(x, y, z), {0.0, -0.0, 0.0, -0.0});
}

// Breaks a tie. The vertices are relative to q, in units of a lattice. The key of a point is (x
// base + y) base + z, so the key of q is 0. Among q and the vertices with a nonzero coefficient,
// the point with the greatest key decides: q is inside if this point is a vertex with a positive
// coefficient.
MGDT_ALWAYS_INLINE int broken_tie(Four x, Four y, Four z, Four coefficients) {
    const Four base = exact::sphere_lattice_base, zero = 0.0;
    const Four key = multiply_add(multiply_add(x, base, y), base, z);
    const Four counted = zero_elsewhere(coefficients != zero, key);
    const Four first = largest_element(larger(counted, zero));
    const std::uint32_t inside = (counted == first).bits() & (coefficients > zero).bits();
    return inside != 0 ? 1 : -1;
}

// One coordinate of four vertices and q. Records which vertices differ from q, and whether there
// are three different values: a vertex that differs from q and from another vertex that differs
// from q.
struct Values {
    MGDT_ALWAYS_INLINE Values(Four v, Four q) : other(v != q), third(other) {
        third = other & (((v != turned<1>(v)) & turned<1>(other)) |
                         ((v != turned<2>(v)) & turned<2>(other)));
    }
    // The sign of each difference: -1, 0 or 1.
    MGDT_ALWAYS_INLINE Four signs(Four difference) const {
        return zero_elsewhere(other, unit_with_sign_of(difference));
    }
    FourMask other, third;
};

// If differences are below 2^wide_lattice_bits units, doubles compute 2 x 2 minors and squared
// lengths without rounding, 3 x 3 minors fit 64 bits, and a determinant that no filter decides is
// below 2^63.
inline constexpr int wide_lattice_bits = 20;

// Converts multiples of a unit, below 2^51 units, to integers; shifter = 1.5 * 2^52 units.
MGDT_ALWAYS_INLINE FourIntegers whole_units(Four v, double shifter) {
    return (v + shifter).as_integers() - Four(shifter).as_integers();
}

// Like perturbed_doubles(), for points of a wide lattice whose determinant the filter has not
// decided. The determinant is computed modulo 2^64, which is exact because an undecided determinant
// is below 2^63 in magnitude. `shifter` is the shifter of the lattice.
MGDT_PREDICATES_APART inline int decided_modulo(Four x, Four y, Four z, double shifter) {
    const double unit = exact::double_of(exact::bits_of(shifter) & exact::exponent_mask) * 0x1p-52,
                 square_shifter = shifter * unit, cube_shifter = square_shifter * unit;
    // 2 x 2 minors are split into two parts, so that products with the third coordinate are exact.
    constexpr double part = 0x1p21;
    const Four cut = square_shifter * part;
    const Four next = multiply_subtract(x, turned<1>(y), turned<1>(x) * y);
    const Four across = multiply_subtract(x, turned<2>(y), turned<2>(x) * y);
    const Four next_high = (next + cut) - cut, across_high = (across + cut) - cut;
    const auto cubic = [&](Four n, Four a) {
        return multiply_add(
            turned<3>(z), turned<1>(n),
            multiply_subtract(turned<1>(z), turned<2>(n), turned<2>(z) * turned<1>(a)));
    };
    const FourIntegers upper = whole_units(cubic(next_high, across_high), cube_shifter * part);
    const FourIntegers lower =
        whole_units(cubic(next - next_high, across - across_high), cube_shifter);
    const Four square = multiply_add(z, z, multiply_add(y, y, x * x));
    constexpr int bits = wide_lattice_bits + 1;

    alignas(32) std::int64_t minor[4], squares[4], keys[4];
    ((upper << 21) + lower).store(minor);
    whole_units(square, square_shifter).store(squares);
    ((whole_units(x, shifter) << 2 * bits) +
     ((whole_units(y, shifter) << bits) + whole_units(z, shifter)))
        .store(keys);
    minor[1] = -minor[1];
    minor[3] = -minor[3];
    std::uint64_t value = 0;
    for (unsigned i = 0; i < 4; ++i)
        value += static_cast<std::uint64_t>(minor[i]) * static_cast<std::uint64_t>(squares[i]);
    if (value != 0) return value >> 63 ? -1 : 1;
    // About half of the vertices pass this test, in random order, so a branch would be
    // mispredicted.
    std::int64_t first = 0, side = -1;
    for (unsigned i = 0; i < 4; ++i) {
        const std::int64_t decides = -static_cast<std::int64_t>(
            hide_from_optimizer(static_cast<std::uint32_t>(keys[i] > first) & (minor[i] != 0)));
        first ^= (first ^ keys[i]) & decides;
        side ^= (side ^ (minor[i] >> 63 | 1)) & decides;
    }
    return static_cast<int>(side);
}

// exact::perturbed_doubles() for a finite tetrahedron that does not have q as a vertex. This
// function also decides the corners of a box, which occur in a lattice of any spacing, even if the
// coordinates of the lattice are rounded.
inline int perturbed_doubles(const Tetrahedron& t, const Vertex* vertices, const Query& q) {
    const Transpose4 rows([&](unsigned k) { return vertices[t.v[k]].x; });
    const Four qx = q.x, qy = q.y, qz = q.z;
    const auto [x, y, z] = relative_to(rows, {qx, qy, qz});
    const Four ax = magnitude(x), ay = magnitude(y), az = magnitude(z);
    const double largest = largest_element(larger(larger(ax, ay), az));
    if (!(largest >= exact::lattice_least && largest <= exact::lattice_most))
        return exact::undecided;
    const Four origin = diagonal(qx, qy, qz);
    const auto is_lattice = [&](double shifter) {
        const Four zero = shifter;
        // Adding the shifter rounds to multiples of the unit.
        const auto is_off = [&](Four v) {
            const Four size = magnitude(v);
            return (size + zero) - zero != size;
        };
        const FourMask off =
            (is_off(rows.first) | is_off(rows.second)) | (is_off(rows.third) | is_off(origin));
        return off.bits() == 0;
    };

    const Four square = multiply_add(z, z, multiply_add(y, y, x * x));
    const Four c = coefficients(x, y, z);
    const double value = sum_of_elements(square * c);
    if (is_lattice(exact::lattice_shifter<exact::sphere_lattice_bits>(largest))) {
        if (value != 0) return value > 0 ? 1 : -1;
        return broken_tie(x, y, z, c);
    }
    const double size = sum_of_elements(square * minors<true>(ax, ay, az));
    const int s = exact::filtered_value(value, size, largest, exact::sphere_bound);
    if (s != exact::undecided) return s;
    const Values in_x(rows.first, qx), in_y(rows.second, qy), in_z(rows.third, qz);
    if (((in_x.third | in_y.third) | in_z.third).bits() != 0) {
        const double wide = exact::lattice_shifter<wide_lattice_bits>(largest);
        return is_lattice(wide) ? decided_modulo(x, y, z, wide) : exact::undecided;
    }
    const Four sx = in_x.signs(x), sy = in_y.signs(y), sz = in_z.signs(z);
    return broken_tie(sx, sy, sz, coefficients(sx, sy, sz));
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
