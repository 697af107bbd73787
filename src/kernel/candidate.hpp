// SPDX-License-Identifier: MIT
// One candidate of the cavity: its power, and what it leaves behind in the arrays. The vector
// form does the same in a third of the instructions; see docs/theory.md for why the same error
// bound holds for either order of the operations.
#pragma once

#include "kernel/circumsphere.hpp"
#include "kernel/workspace.hpp"

#if defined(__AVX2__) && defined(__FMA__)
#include <immintrin.h>
#endif

namespace mgdt {
inline namespace MGDT_ISA {

MGDT_ALWAYS_INLINE void prefetch(const void* p) {
#if defined(__GNUC__)
    __builtin_prefetch(p);
#else
    static_cast<void>(p);
#endif
}

// Keeps the compiler from turning arithmetic on a condition back into a branch on it.
MGDT_ALWAYS_INLINE std::uint32_t opaque(std::uint32_t x) {
#if defined(__GNUC__)
    __asm__("" : "+r"(x));
#endif
    return x;
}

#if defined(__AVX2__) && defined(__FMA__)

// outer_face for the vertices and the neighbours of a record at once.
alignas(32) constexpr std::int32_t outer_picks[4][8] = {{1, 3, 2, 0, 5, 7, 6, 4},
                                                        {0, 2, 3, 0, 4, 6, 7, 4},
                                                        {0, 3, 1, 0, 4, 7, 5, 4},
                                                        {0, 1, 2, 0, 4, 5, 6, 4}};

class CandidateTest {
  public:
    MGDT_ALWAYS_INLINE explicit CandidateTest(const Query& q)
        : q_(_mm256_setr_pd(q.x, q.y, q.z, 0)), quadratic_(_mm256_set1_pd(q.quadratic)) {}

    MGDT_ALWAYS_INLINE Power operator()(const Tetrahedron& t, const Vertex* vertices) const {
        const __m256d three = _mm256_castsi256_pd(_mm256_setr_epi64x(-1, -1, -1, 0));
        const __m256d magnitude = _mm256_castsi256_pd(_mm256_set1_epi64x(0x7FFFFFFFFFFFFFFF));
        const __m256d p = _mm256_and_pd(_mm256_load_pd(vertices[t.v[0]].x), three);
        const __m256d w = _mm256_and_pd(_mm256_load_pd(t.w), three);
        const __m128 e = _mm_load_ss(&t.e);
        const __m128i sign = _mm_srai_epi32(_mm_castps_si128(e), 31);
        const __m256d ghost = _mm256_castsi256_pd(_mm256_broadcastd_epi32(sign));
        const __m256d bound =
            _mm256_and_pd(_mm256_broadcastsd_pd(_mm_cvtss_sd(_mm_setzero_pd(), e)), magnitude);
        const __m256d u = _mm256_sub_pd(q_, p);
        const __m256d quadratic = _mm256_andnot_pd(ghost, u);  // the term that a ghost has not
        const __m256d terms = _mm256_mul_pd(u, _mm256_sub_pd(quadratic, w));
        const __m256d errors =
            _mm256_mul_pd(_mm256_and_pd(u, magnitude),
                          _mm256_fmadd_pd(quadratic_, _mm256_and_pd(quadratic, magnitude), bound));
        const __m256d pairs = _mm256_hadd_pd(terms, errors);
        const __m128d sums =
            _mm_add_pd(_mm256_castpd256_pd128(pairs), _mm256_extractf128_pd(pairs, 1));
        return {_mm_cvtsd_f64(sums), _mm_cvtsd_f64(_mm_unpackhi_pd(sums, sums))};
    }

    // Writes the facet of the boundary that the candidate is if it stays, and the neighbours
    // beyond its other faces, which are candidates if it goes. The latter takes a fourth place.
    MGDT_ALWAYS_INLINE static void write(const Tetrahedron& t, FacetCode code,
                                         BoundaryFacet* boundary, FacetCode* candidates) {
        const __m256i both = _mm256_load_si256(reinterpret_cast<const __m256i*>(t.v));
        const __m256i pick =
            _mm256_load_si256(reinterpret_cast<const __m256i*>(outer_picks[code & 3]));
        const __m256i picked = _mm256_permutevar8x32_epi32(both, pick);
        _mm_storeu_si128(reinterpret_cast<__m128i*>(boundary),
                         _mm_blend_epi32(_mm256_castsi256_si128(picked),
                                         _mm_set1_epi32(static_cast<std::int32_t>(code)), 8));
        _mm_storeu_si128(reinterpret_cast<__m128i*>(candidates),
                         _mm256_extracti128_si256(picked, 1));
    }

  private:
    __m256d q_, quadratic_;
};

#else

class CandidateTest {
  public:
    MGDT_ALWAYS_INLINE explicit CandidateTest(const Query& q) : q_(q) {}

    MGDT_ALWAYS_INLINE Power operator()(const Tetrahedron& t, const Vertex* vertices) const {
        return power(t, vertices, q_);
    }

    MGDT_ALWAYS_INLINE static void write(const Tetrahedron& t, FacetCode code,
                                         BoundaryFacet* boundary, FacetCode* candidates) {
        const unsigned char* order = outer_face[code & 3];
        const unsigned a = order[0], b = order[1], c = order[2];
        *boundary = {{t.v[a], t.v[b], t.v[c]}, code};
        candidates[0] = t.n[a];
        candidates[1] = t.n[b];
        candidates[2] = t.n[c];
    }

  private:
    const Query q_;
};

#endif

}  // namespace MGDT_ISA
}  // namespace mgdt
