// SPDX-License-Identifier: MIT
// Words moved four at a time: see kernel/words.hpp.
#pragma once

#include "kernel/avx2/write_vertices.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

MGDT_ALWAYS_INLINE unsigned append(std::uint32_t* to, const std::uint32_t* words,
                                   std::uint32_t bits) {
    const __m128i w = _mm_load_si128(reinterpret_cast<const __m128i*>(words));
    _mm_storeu_si128(reinterpret_cast<__m128i*>(to),
                     _mm_maskz_compress_epi32(static_cast<__mmask8>(bits), w));
    return static_cast<unsigned>(__builtin_popcount(bits));
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
