// SPDX-License-Identifier: MIT
// Conflicts near ties, with the four vertices side by side: see kernel/ties.hpp. The formulas are
// those of predicates/perturbation.cpp.
#pragma once

#include "kernel/avx2/transpose.hpp"
#include "predicates/lattice.hpp"
#include "predicates/stages.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// (v0, v1, v2, v3) turned by one place: (v1, v2, v3, v0).
template <int Places>
MGDT_ALWAYS_INLINE __m256d turned(__m256d v) {
    constexpr int order = 0xE4E4 >> 2 * Places & 0xFF;
    return _mm256_permute4x64_pd(v, order);
}

MGDT_ALWAYS_INLINE double largest_element(__m256d v) {
    const __m128d pair = _mm_max_pd(_mm256_castpd256_pd128(v), _mm256_extractf128_pd(v, 1));
    return _mm_cvtsd_f64(_mm_max_sd(pair, _mm_unpackhi_pd(pair, pair)));
}
MGDT_ALWAYS_INLINE double sum_of_elements(__m256d v) {
    const __m128d pair = _mm_add_pd(_mm256_castpd256_pd128(v), _mm256_extractf128_pd(v, 1));
    return _mm_cvtsd_f64(_mm_add_sd(pair, _mm_unpackhi_pd(pair, pair)));
}

// a b - c d, or plus where all terms are to be positive.
template <bool Positive>
MGDT_ALWAYS_INLINE __m256d difference(__m256d a, __m256d b, __m256d cd) {
    return Positive ? _mm256_fmadd_pd(a, b, cd) : _mm256_fmsub_pd(a, b, cd);
}

// [bcd], [cda], [dab], [abc] of four rows by columns: the minors of SphereDeterminant, since even
// permutations of rows change nothing. With indices modulo 4:
//   next[i]   = x[i] y[i+1] - x[i+1] y[i]
//   across[i] = x[i] y[i+2] - x[i+2] y[i]
//   minor[i]  = z[i+1] next[i+2] - z[i+2] across[i+1] + z[i+3] next[i+1]
template <bool Positive>
MGDT_ALWAYS_INLINE __m256d minors(__m256d x, __m256d y, __m256d z) {
    const __m256d next = difference<Positive>(x, turned<1>(y), _mm256_mul_pd(turned<1>(x), y));
    const __m256d across = difference<Positive>(x, turned<2>(y), _mm256_mul_pd(turned<2>(x), y));
    return _mm256_fmadd_pd(turned<3>(z), turned<1>(next),
                           difference<Positive>(turned<1>(z), turned<2>(next),
                                                _mm256_mul_pd(turned<2>(z), turned<1>(across))));
}

// Of a, b, c and d in the determinant, whose rows alternate in sign: minors with the second and the
// fourth negated.
MGDT_ALWAYS_INLINE __m256d coefficients(__m256d x, __m256d y, __m256d z) {
    return _mm256_xor_pd(minors<false>(x, y, z), _mm256_setr_pd(0.0, -0.0, 0.0, -0.0));
}

// The side of q in a tie, from vertices relative to it in units of a lattice. Of q, whose key is 0,
// and the vertices whose coefficient is not 0, the one of greatest key = (x base + y) base + z
// decides: inside if it is a vertex with a positive coefficient.
MGDT_ALWAYS_INLINE int broken_tie(__m256d x, __m256d y, __m256d z, __m256d coefficients) {
    const __m256d base = _mm256_set1_pd(exact::sphere_lattice_base), zero = _mm256_setzero_pd();
    const __m256d key = _mm256_fmadd_pd(_mm256_fmadd_pd(x, base, y), base, z);
    const __m256d counted = _mm256_and_pd(key, _mm256_cmp_pd(coefficients, zero, _CMP_NEQ_UQ));
    const __m256d first = _mm256_set1_pd(largest_element(_mm256_max_pd(counted, zero)));
    const int inside = _mm256_movemask_pd(_mm256_cmp_pd(counted, first, _CMP_EQ_OQ)) &
                       _mm256_movemask_pd(_mm256_cmp_pd(coefficients, zero, _CMP_GT_OQ));
    return inside != 0 ? 1 : -1;
}

// One coordinate of four vertices and q: where a vertex differs from q, and where from q and from
// another vertex that does, which makes three values.
struct Values {
    MGDT_ALWAYS_INLINE Values(__m256d v, __m256d q) : other(_mm256_cmp_pd(v, q, _CMP_NEQ_UQ)) {
        const auto differs = [&](__m256d w, __m256d is_other) {
            return _mm256_and_pd(_mm256_cmp_pd(v, w, _CMP_NEQ_UQ), is_other);
        };
        third = _mm256_and_pd(other, _mm256_or_pd(differs(turned<1>(v), turned<1>(other)),
                                                  differs(turned<2>(v), turned<2>(other))));
    }
    // -1, 0 or 1 for each.
    MGDT_ALWAYS_INLINE __m256d signs(__m256d difference) const {
        const __m256d minus = _mm256_set1_pd(-0.0), one = _mm256_set1_pd(1.0);
        return _mm256_and_pd(other, _mm256_or_pd(one, _mm256_and_pd(difference, minus)));
    }
    __m256d other, third;
};

// Differences below 2^wide_lattice_bits units make 2 x 2 minors and squares of length doubles
// without rounding, 3 x 3 minors fit 64 bits, and a determinant that no filter decides is below
// 2^63.
inline constexpr int wide_lattice_bits = 20;

// Multiples of a unit below 2^51 of them as integers; shifter = 1.5 * 2^52 units.
MGDT_ALWAYS_INLINE __m256i whole_units(__m256d v, double shifter) {
    const __m256d zero = _mm256_set1_pd(shifter);
    return _mm256_sub_epi64(_mm256_castpd_si256(_mm256_add_pd(v, zero)), _mm256_castpd_si256(zero));
}

// The same for points of a wide lattice whose determinant the filter left open: modulo 2^64, which
// is exact then. shifter is that of the lattice.
MGDT_PREDICATES_APART inline int decided_modulo(__m256d x, __m256d y, __m256d z, double shifter) {
    const double unit = exact::double_of(exact::bits_of(shifter) & exact::exponent_mask) * 0x1p-52,
                 square_shifter = shifter * unit, cube_shifter = square_shifter * unit;
    // 2 x 2 minors in two parts, so that products with the third coordinate are exact.
    constexpr double part = 0x1p21;
    const __m256d cut = _mm256_set1_pd(square_shifter * part);
    const __m256d next = _mm256_fmsub_pd(x, turned<1>(y), _mm256_mul_pd(turned<1>(x), y));
    const __m256d across = _mm256_fmsub_pd(x, turned<2>(y), _mm256_mul_pd(turned<2>(x), y));
    const auto high = [&](__m256d v) { return _mm256_sub_pd(_mm256_add_pd(v, cut), cut); };
    const __m256d next_high = high(next), across_high = high(across);
    const __m256d z1 = turned<1>(z), z2 = turned<2>(z), z3 = turned<3>(z);
    const auto cubic = [&](__m256d n, __m256d a) {
        return _mm256_fmadd_pd(z3, turned<1>(n),
                               _mm256_fmsub_pd(z1, turned<2>(n), _mm256_mul_pd(z2, turned<1>(a))));
    };
    const __m256i upper = whole_units(cubic(next_high, across_high), cube_shifter * part);
    const __m256i lower = whole_units(
        cubic(_mm256_sub_pd(next, next_high), _mm256_sub_pd(across, across_high)), cube_shifter);
    const __m256d square = _mm256_fmadd_pd(z, z, _mm256_fmadd_pd(y, y, _mm256_mul_pd(x, x)));
    const __m256i key = _mm256_add_epi64(
        _mm256_slli_epi64(whole_units(x, shifter), 2 * (wide_lattice_bits + 1)),
        _mm256_add_epi64(_mm256_slli_epi64(whole_units(y, shifter), wide_lattice_bits + 1),
                         whole_units(z, shifter)));

    alignas(32) std::int64_t minor[4], squares[4], keys[4];
    _mm256_store_si256(reinterpret_cast<__m256i*>(minor),
                       _mm256_add_epi64(_mm256_slli_epi64(upper, 21), lower));
    _mm256_store_si256(reinterpret_cast<__m256i*>(squares), whole_units(square, square_shifter));
    _mm256_store_si256(reinterpret_cast<__m256i*>(keys), key);
    minor[1] = -minor[1];
    minor[3] = -minor[3];
    std::uint64_t value = 0;
    for (unsigned i = 0; i < 4; ++i)
        value += static_cast<std::uint64_t>(minor[i]) * static_cast<std::uint64_t>(squares[i]);
    if (value != 0) return value >> 63 ? -1 : 1;
    // About half of these decide, in no order: a branch would be mispredicted.
    std::int64_t first = 0, side = -1;
    for (unsigned i = 0; i < 4; ++i) {
        const std::int64_t decides = -static_cast<std::int64_t>(
            hide_from_optimizer(static_cast<std::uint32_t>(keys[i] > first) & (minor[i] != 0)));
        first ^= (first ^ keys[i]) & decides;
        side ^= (side ^ (minor[i] >> 63 | 1)) & decides;
    }
    return static_cast<int>(side);
}

// exact::perturbed_doubles() for a finite tetrahedron that q is no vertex of. It also knows the
// corners of a box, as there are in a lattice of any spacing, however its coordinates are rounded.
inline int perturbed_doubles(const Tetrahedron& t, const Vertex* vertices, const Query& q) {
    const Transpose4 rows([&](unsigned k) { return vertices[t.v[k]].x; });
    const __m256d qx = _mm256_set1_pd(q.x), qy = _mm256_set1_pd(q.y), qz = _mm256_set1_pd(q.z);
    const auto [x, y, z] = relative_to(rows, {qx, qy, qz});
    const __m256d ax = Four::magnitude(x), ay = Four::magnitude(y), az = Four::magnitude(z);
    const double largest = largest_element(_mm256_max_pd(_mm256_max_pd(ax, ay), az));
    if (!(largest >= exact::lattice_least && largest <= exact::lattice_most))
        return exact::undecided;
    const __m256d origin = _mm256_blend_pd(_mm256_blend_pd(qx, qy, 2), qz, 4);
    const auto is_lattice = [&](double shifter) {
        const __m256d zero = _mm256_set1_pd(shifter);
        const auto is_off = [&](__m256d v) {
            const __m256d size = Four::magnitude(v);
            return _mm256_cmp_pd(_mm256_sub_pd(_mm256_add_pd(size, zero), zero), size, _CMP_NEQ_UQ);
        };
        const __m256d off = _mm256_or_pd(_mm256_or_pd(is_off(rows.first), is_off(rows.second)),
                                         _mm256_or_pd(is_off(rows.third), is_off(origin)));
        return _mm256_movemask_pd(off) == 0;
    };

    const __m256d square = _mm256_fmadd_pd(z, z, _mm256_fmadd_pd(y, y, _mm256_mul_pd(x, x)));
    const __m256d c = coefficients(x, y, z);
    const double value = sum_of_elements(_mm256_mul_pd(square, c));
    if (is_lattice(exact::lattice_shifter<exact::sphere_lattice_bits>(largest))) {
        if (value != 0) return value > 0 ? 1 : -1;
        return broken_tie(x, y, z, c);
    }
    const double size = sum_of_elements(_mm256_mul_pd(square, minors<true>(ax, ay, az)));
    const int s = exact::filtered_value(value, size, largest, exact::sphere_bound);
    if (s != exact::undecided) return s;
    const Values in_x(rows.first, qx), in_y(rows.second, qy), in_z(rows.third, qz);
    const __m256d third = _mm256_or_pd(_mm256_or_pd(in_x.third, in_y.third), in_z.third);
    if (_mm256_movemask_pd(third) != 0) {
        const double wide = exact::lattice_shifter<wide_lattice_bits>(largest);
        return is_lattice(wide) ? decided_modulo(x, y, z, wide) : exact::undecided;
    }
    const __m256d sx = in_x.signs(x), sy = in_y.signs(y), sz = in_z.signs(z);
    return broken_tie(sx, sy, sz, coefficients(sx, sy, sz));
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
