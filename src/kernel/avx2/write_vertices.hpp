// SPDX-License-Identifier: MIT
// The vertices of a new tetrahedron: see kernel/words.hpp.
#pragma once

#include <immintrin.h>

#include "kernel/island.hpp"
#include "mesh/tetrahedron.hpp"
#include "platform/compiler.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// outer_face in the first three places.
alignas(16) constexpr std::int32_t outer_picks[4][4] = {
    {1, 3, 2, 0}, {0, 2, 3, 1}, {0, 3, 1, 2}, {0, 1, 2, 3}};

MGDT_ALWAYS_INLINE const VertexId* write_vertices(const Tetrahedron& outside, FacetCode code,
                                                  VertexId q, Tetrahedron& out) {
    const __m128 v = _mm_load_ps(reinterpret_cast<const float*>(outside.v));
    const __m128i pick =
        _mm_load_si128(reinterpret_cast<const __m128i*>(outer_picks[face_of(code)]));
    // The facet goes to the upper three places.
    const __m128i facet = _mm_slli_si128(_mm_castps_si128(_mm_permutevar_ps(v, pick)), 4);
    _mm_store_si128(reinterpret_cast<__m128i*>(out.v),
                    _mm_or_si128(facet, _mm_cvtsi32_si128(static_cast<std::int32_t>(q))));
    return out.v + 1;
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
