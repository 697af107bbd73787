// SPDX-License-Identifier: MIT
// Powers with respect to four tetrahedra: see kernel/powers.hpp. Their records and base vertices
// are transposed in registers, so that a test costs some fifteen instructions and the four lines
// are waited for together. Spheres that are not kept are computed for the four together.
#pragma once

#include "kernel/avx2/transpose.hpp"
#include "kernel/sphere_source.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// A point four times.
struct QueryRows {
    MGDT_ALWAYS_INLINE explicit QueryRows(const Query& q)
        : x(_mm256_set1_pd(q.x)),
          y(_mm256_set1_pd(q.y)),
          z(_mm256_set1_pd(q.z)),
          quadratic(_mm256_set1_pd(q.quadratic)) {}
    __m256d x, y, z, quadratic;
};

class FourPowers {
  public:
    template <class Spheres, class Tetrahedra>
    MGDT_ALWAYS_INLINE FourPowers(const Spheres& from, const Tetrahedra& four, const Query& q)
        : FourPowers(from, four, QueryRows(q)) {}
    template <class Tetrahedra>
    MGDT_ALWAYS_INLINE FourPowers(const KeptSpheres& from, const Tetrahedra& four,
                                  const QueryRows& q) {
        set(Transpose4::of_upper_halves([&](unsigned k) { return four.sphere(k).w; }),
            vertices(from, four, 0), q);
    }
    template <class Tetrahedra>
    FourPowers(const ComputedSpheres& from, const Tetrahedra& four, const QueryRows& q) {
        const Transpose4 bases = vertices(from, four, 0);
        const auto local = [&](unsigned i) {
            return LocalColumns<Four>(
                relative_to(vertices(from, four, i), {bases.first, bases.second, bases.third}));
        };
        const SphereColumns<Four> s = spheres_through<false>(local(1), local(2), local(3));
        Transpose4 spheres = {s.x, s.y, s.z, s.e};
        std::uint32_t special = from.has_extremes ? 0xFu : 0u;
        for (unsigned k = 0; k < 4; ++k)
            special |= static_cast<std::uint32_t>(four[k].is_ghost()) << k;
        if (MGDT_UNLIKELY(special != 0)) replace(spheres, special, from, four);
        set(spheres, bases, q);
    }

    // As bits, the first tetrahedron in the lowest: where the power is negative, where it is
    // certain whether it is, and which are ghosts.
    MGDT_ALWAYS_INLINE std::uint32_t negative() const {
        return static_cast<std::uint32_t>(_mm256_movemask_pd(value_));
    }
    MGDT_ALWAYS_INLINE std::uint32_t decided() const {
        return static_cast<std::uint32_t>(
            _mm256_movemask_pd(_mm256_cmp_pd(Four::magnitude(value_), error_, _CMP_GT_OQ)));
    }
    MGDT_ALWAYS_INLINE std::uint32_t ghosts() const {
        return static_cast<std::uint32_t>(_mm256_movemask_pd(ghost_));
    }
    MGDT_ALWAYS_INLINE Power operator[](unsigned k) const {
        return {element(value_, k), element(error_, k)};
    }
    // Where the power, or that of a ghost, is certainly above that of a tetrahedron, or of none.
    MGDT_ALWAYS_INLINE std::uint32_t above(Power other) const {
        const __m256d floor = _mm256_blendv_pd(_mm256_set1_pd(other.value + other.error),
                                               _mm256_setzero_pd(), ghost_);
        return static_cast<std::uint32_t>(
            _mm256_movemask_pd(_mm256_cmp_pd(_mm256_sub_pd(value_, floor), error_, _CMP_GT_OQ)));
    }
    // The finite tetrahedron of least power, if it is below the bound; else 4.
    MGDT_ALWAYS_INLINE unsigned least_finite(double bound) const {
        const __m256d finite =
            _mm256_blendv_pd(value_, _mm256_set1_pd(infinity), ghost_);  // by the sign
        const __m256d pairs = _mm256_min_pd(finite, _mm256_permute_pd(finite, 5));
        const __m256d least = _mm256_min_pd(pairs, _mm256_permute2f128_pd(pairs, pairs, 1));
        const int equal = _mm256_movemask_pd(_mm256_cmp_pd(finite, least, _CMP_EQ_OQ));
        return _mm256_cvtsd_f64(least) < bound ? lowest_bit(static_cast<std::uint32_t>(equal) | 16u)
                                               : 4;
    }

  private:
    // The i-th vertex of each. A mark may be on the second.
    template <class Spheres, class Tetrahedra>
    MGDT_ALWAYS_INLINE static Transpose4 vertices(const Spheres& from, const Tetrahedra& four,
                                                  unsigned i) {
        const VertexId mask = i == 1 ? ~in_cavity : ~VertexId{0};
        return Transpose4([&](unsigned k) { return from.vertices[four[k].v[i] & mask].x; });
    }
    // Ghosts, and all where some vertex is outside the normal range, are rare enough for one by
    // one. The way depends on the tetrahedron alone, so that its power does.
    template <class Tetrahedra>
    static void replace(Transpose4& spheres, std::uint32_t special, const ComputedSpheres& from,
                        const Tetrahedra& four) {
        alignas(32) double columns[4][4];
        __m256d* const column[4] = {&spheres.first, &spheres.second, &spheres.third,
                                    &spheres.fourth};
        for (unsigned i = 0; i < 4; ++i) _mm256_store_pd(columns[i], *column[i]);
        for (unsigned k = 0; k < 4; ++k) {
            if (!(special >> k & 1)) continue;
            const Sphere s = from.sphere(four, k);
            for (unsigned i = 0; i < 3; ++i) columns[i][k] = s.w[i];
            columns[3][k] = s.e;
        }
        for (unsigned i = 0; i < 4; ++i) *column[i] = _mm256_load_pd(columns[i]);
    }
    MGDT_ALWAYS_INLINE void set(const Transpose4& spheres, const Transpose4& bases,
                                const QueryRows& q) {
        // u = q - p, value = |u|^2 - w . u, error = |e| (|u.x| + |u.y| + |u.z|) + quadratic |u|^2
        const __m256d ux = _mm256_sub_pd(q.x, bases.first);
        const __m256d uy = _mm256_sub_pd(q.y, bases.second);
        const __m256d uz = _mm256_sub_pd(q.z, bases.third);
        const __m256d wx = spheres.first, wy = spheres.second, wz = spheres.third;
        ghost_ = spheres.fourth;

        const __m256d all = _mm256_fmadd_pd(uz, uz, _mm256_fmadd_pd(uy, uy, _mm256_mul_pd(ux, ux)));
        // A ghost has no quadratic term.
        const __m256d square =
            _mm256_andnot_pd(_mm256_castsi256_pd(_mm256_cmpgt_epi64(_mm256_setzero_si256(),
                                                                    _mm256_castpd_si256(ghost_))),
                             all);
        const __m256d linear =
            _mm256_fmadd_pd(wz, uz, _mm256_fmadd_pd(wy, uy, _mm256_mul_pd(wx, ux)));
        value_ = _mm256_sub_pd(square, linear);
        const __m256d length = _mm256_add_pd(
            Four::magnitude(uz), _mm256_add_pd(Four::magnitude(uy), Four::magnitude(ux)));
        error_ = _mm256_fmadd_pd(Four::magnitude(spheres.fourth), length,
                                 _mm256_mul_pd(q.quadratic, square));
    }
    MGDT_ALWAYS_INLINE static double element(__m256d of, unsigned k) {
        alignas(32) double all[4];
        _mm256_store_pd(all, of);
        return all[k];
    }

    __m256d value_, error_, ghost_;
};

}  // namespace MGDT_ISLAND
}  // namespace mgdt
