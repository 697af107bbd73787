// SPDX-License-Identifier: MIT
// Small pieces of the cavity and the star.
#pragma once

#include "kernel/vector_sphere.hpp"
#include "kernel/workspace.hpp"

namespace mgdt {
inline namespace MGDT_ISA {

// Keeps the compiler from turning arithmetic on a condition back into a branch on it.
MGDT_ALWAYS_INLINE std::uint32_t hide_from_optimizer(std::uint32_t x) {
#if defined(__GNUC__)
    __asm__("" : "+r"(x));
#endif
    return x;
}

#if defined(MGDT_HAVE_FOUR_ROWS)

#if !defined(MGDT_HAVE_EIGHT_ROWS)
// For each choice among four words, the places of those chosen.
alignas(16) constexpr std::int32_t chosen_picks[16][4] = {
    {},  {0},    {1},    {0, 1},    {2},    {0, 2},    {1, 2},    {0, 1, 2},
    {3}, {0, 3}, {1, 3}, {0, 1, 3}, {2, 3}, {0, 2, 3}, {1, 2, 3}, {0, 1, 2, 3}};
#endif

// Writes those of four words whose bits are set, and anything in what is left of 16 bytes. Returns
// how many they are.
MGDT_ALWAYS_INLINE unsigned append(std::uint32_t* to, const std::uint32_t* words,
                                   std::uint32_t bits) {
    __m128i w = _mm_load_si128(reinterpret_cast<const __m128i*>(words));
#if defined(MGDT_HAVE_EIGHT_ROWS)
    w = _mm_maskz_compress_epi32(static_cast<__mmask8>(bits), w);
#else
    const __m128i pick = _mm_load_si128(reinterpret_cast<const __m128i*>(chosen_picks[bits]));
    w = _mm_castps_si128(_mm_permutevar_ps(_mm_castsi128_ps(w), pick));
#endif
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to), w);
    return static_cast<unsigned>(__builtin_popcount(bits));
}

// outer_face in the first three places.
alignas(16) constexpr std::int32_t outer_picks[4][4] = {
    {1, 3, 2, 0}, {0, 2, 3, 1}, {0, 3, 1, 2}, {0, 1, 2, 3}};

// Writes the vertices of the tetrahedron of q and the facet that a tetrahedron outside is reached
// through, and returns where those of the facet are.
MGDT_ALWAYS_INLINE const VertexId* write_vertices(const Tetrahedron& outside, FacetCode code,
                                                  VertexId q, Tetrahedron& out) {
    const __m128 v = _mm_load_ps(reinterpret_cast<const float*>(outside.v));
    const __m128i pick = _mm_load_si128(reinterpret_cast<const __m128i*>(outer_picks[code & 3]));
    // The facet goes to the upper three places.
    const __m128i facet = _mm_slli_si128(_mm_castps_si128(_mm_permutevar_ps(v, pick)), 4);
    _mm_store_si128(reinterpret_cast<__m128i*>(out.v),
                    _mm_or_si128(facet, _mm_cvtsi32_si128(static_cast<std::int32_t>(q))));
    return out.v + 1;
}

#else

// The same.
MGDT_ALWAYS_INLINE unsigned append(std::uint32_t* to, const std::uint32_t* words,
                                   std::uint32_t bits) {
    unsigned count = 0;
    for (unsigned k = 0; k < 4; ++k) {
        to[count] = words[k];
        count += bits >> k & 1;
    }
    return count;
}

MGDT_ALWAYS_INLINE const VertexId* write_vertices(const Tetrahedron& outside, FacetCode code,
                                                  VertexId q, Tetrahedron& out) {
    out.v[0] = q;
    for (unsigned k = 0; k < 3; ++k) out.v[k + 1] = outside.v[outer_face[code & 3][k]];
    return out.v + 1;
}

#endif

}  // namespace MGDT_ISA
}  // namespace mgdt
