// SPDX-License-Identifier: MIT
// Conflicts that the filter of cached spheres leaves open, where doubles can still tell: on a
// lattice, whose ties they break exactly, and by the predicates' own filter, which does not mind
// how long and thin a tetrahedron is. The formulas are those of predicates/perturbation.cpp, with
// the four vertices side by side.
#pragma once

#include "kernel/powers.hpp"
#include "mesh/mesh.hpp"
#include "predicates/lattice.hpp"
#include "predicates/predicates.hpp"
#include "predicates/stages.hpp"

namespace mgdt {
inline namespace MGDT_ISA {

#if defined(__AVX2__) && defined(__FMA__)

// Each element's neighbour so many places on, around the end.
template <int Places>
MGDT_ALWAYS_INLINE __m256d turned(__m256d v) {
    constexpr int order = 0xE4E4 >> 2 * Places & 0xFF;
    return _mm256_permute4x64_pd(v, order);
}

// A number and a bound of the magnitude of all that it was made of.
struct Bounded {
    __m256d value, size;
};

MGDT_ALWAYS_INLINE Bounded bounded(__m256d v) {
    const __m256d magnitude = _mm256_castsi256_pd(_mm256_set1_epi64x(0x7FFFFFFFFFFFFFFF));
    return {v, _mm256_and_pd(v, magnitude)};
}
template <int Places>
MGDT_ALWAYS_INLINE Bounded turned(const Bounded& v) {
    return {turned<Places>(v.value), turned<Places>(v.size)};
}
// a b - c d and a b + c
MGDT_ALWAYS_INLINE Bounded minor(const Bounded& a, const Bounded& b, const Bounded& c,
                                 const Bounded& d) {
    return {_mm256_fmsub_pd(a.value, b.value, _mm256_mul_pd(c.value, d.value)),
            _mm256_fmadd_pd(a.size, b.size, _mm256_mul_pd(c.size, d.size))};
}

MGDT_ALWAYS_INLINE double largest_element(__m256d v) {
    const __m128d pair = _mm_max_pd(_mm256_castpd256_pd128(v), _mm256_extractf128_pd(v, 1));
    return _mm_cvtsd_f64(_mm_max_sd(pair, _mm_unpackhi_pd(pair, pair)));
}
MGDT_ALWAYS_INLINE double sum_of_elements(__m256d v) {
    const __m128d pair = _mm_add_pd(_mm256_castpd256_pd128(v), _mm256_extractf128_pd(v, 1));
    return _mm_cvtsd_f64(_mm_add_sd(pair, _mm_unpackhi_pd(pair, pair)));
}

// exact::perturbed_doubles() for a finite tetrahedron that q is no vertex of.
inline int perturbed_doubles(const Tetrahedron& t, const Vertex* vertices, const Query& q) {
    const FourRows rows([&](unsigned k) { return vertices[t.v[k]].x; });
    const __m256d qx = _mm256_set1_pd(q.x), qy = _mm256_set1_pd(q.y), qz = _mm256_set1_pd(q.z);
    const Bounded x = bounded(_mm256_sub_pd(rows.first, qx)),
                  y = bounded(_mm256_sub_pd(rows.second, qy)),
                  z = bounded(_mm256_sub_pd(rows.third, qz));
    const double largest = largest_element(_mm256_max_pd(_mm256_max_pd(x.size, y.size), z.size));
    if (!(largest >= exact::lattice_least && largest <= exact::lattice_most))
        return exact::undecided;
    const __m256d shifter =
        _mm256_set1_pd(exact::lattice_shifter<exact::sphere_lattice_bits>(largest));
    const auto is_off = [&](__m256d v) {
        const __m256d size = bounded(v).size;
        const __m256d rounded = _mm256_sub_pd(_mm256_add_pd(size, shifter), shifter);
        return _mm256_cmp_pd(rounded, size, _CMP_NEQ_UQ);
    };
    const __m256d origin = _mm256_blend_pd(_mm256_blend_pd(qx, qy, 2), qz, 4);
    const __m256d off = _mm256_or_pd(_mm256_or_pd(is_off(rows.first), is_off(rows.second)),
                                     _mm256_or_pd(is_off(rows.third), is_off(origin)));

    // ab, bc, cd, da and ac, bd, ca, db; then bcd, cda, dab, abc, of which the second and the last
    // count as they are and the others too, since even permutations of three rows change nothing.
    const Bounded next_x = turned<1>(x), next_y = turned<1>(y), next_z = turned<1>(z);
    const Bounded across_x = turned<2>(x), across_y = turned<2>(y), across_z = turned<2>(z);
    const Bounded side = minor(x, next_y, next_x, y), diagonal = minor(x, across_y, across_x, y);
    const Bounded next_side = turned<1>(side), next_diagonal = turned<1>(diagonal);
    const Bounded across_side = turned<2>(side), last_z = turned<3>(z);
    const __m256d minors =
        _mm256_fmadd_pd(last_z.value, next_side.value,
                        _mm256_fmsub_pd(next_z.value, across_side.value,
                                        _mm256_mul_pd(across_z.value, next_diagonal.value)));
    const __m256d square = _mm256_fmadd_pd(
        z.value, z.value, _mm256_fmadd_pd(y.value, y.value, _mm256_mul_pd(x.value, x.value)));
    const __m256d coefficients = _mm256_xor_pd(minors, _mm256_setr_pd(0.0, -0.0, 0.0, -0.0));
    const double value = sum_of_elements(_mm256_mul_pd(square, coefficients));

    if (_mm256_movemask_pd(off) == 0) {
        if (value != 0) return value > 0 ? 1 : -1;
        const __m256d base = _mm256_set1_pd(exact::sphere_lattice_base), zero = _mm256_setzero_pd();
        const __m256d key = _mm256_fmadd_pd(_mm256_fmadd_pd(x.value, base, y.value), base, z.value);
        const __m256d counted = _mm256_and_pd(key, _mm256_cmp_pd(coefficients, zero, _CMP_NEQ_UQ));
        const double first = largest_element(_mm256_max_pd(counted, zero));
        const int inside =
            _mm256_movemask_pd(_mm256_cmp_pd(counted, _mm256_set1_pd(first), _CMP_EQ_OQ)) &
            _mm256_movemask_pd(_mm256_cmp_pd(coefficients, zero, _CMP_GT_OQ));
        return inside != 0 ? 1 : -1;
    }

    const __m256d sizes =
        _mm256_fmadd_pd(last_z.size, next_side.size,
                        _mm256_fmadd_pd(next_z.size, across_side.size,
                                        _mm256_mul_pd(across_z.size, next_diagonal.size)));
    return exact::filtered_value(value, sum_of_elements(_mm256_mul_pd(square, sizes)), largest,
                                 exact::sphere_bound);
}

#else

inline int perturbed_doubles(const Tetrahedron& t, const Vertex* vertices, const Query& q) {
    return exact::perturbed_doubles(vertices[t.v[0]].x, vertices[t.v[1]].x, vertices[t.v[2]].x,
                                    vertices[t.v[3]].x, q.point);
}

#endif

// Whether q is in conflict with t, as is_conflict_exact() decides it.
MGDT_PREDICATES_APART inline bool is_conflict_near_tie(const Mesh& mesh, const Tetrahedron& t,
                                                       const Query& q) {
    if (t.is_ghost()) return is_conflict_exact(mesh, t, q.point);
    const Vertex* const vertices = mesh.vertices.data();
    int s = perturbed_doubles(t, vertices, q);
    if (MGDT_UNLIKELY(s == exact::undecided))
        s = exact::perturbed_integers(vertices[t.v[0]].x, vertices[t.v[1]].x, vertices[t.v[2]].x,
                                      vertices[t.v[3]].x, q.point);
    return s > 0;
}

}  // namespace MGDT_ISA
}  // namespace mgdt
