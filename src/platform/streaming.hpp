// SPDX-License-Identifier: MIT
// Non-temporal stores, which bypass the caches, for large arrays that are written once. Without
// SSE2, the functions use plain stores.
#pragma once

#include <cstddef>
#include <cstdint>

#include "platform/compiler.hpp"

#if defined(__SSE2__)
#include <emmintrin.h>
#endif

namespace mgdt {

#if defined(__SSE2__)

// The alignment that stream_four() requires.
inline constexpr std::size_t streaming_alignment = 16;

MGDT_ALWAYS_INLINE void stream_four(std::int64_t* to, std::int64_t a, std::int64_t b,
                                    std::int64_t c, std::int64_t d) noexcept {
    _mm_stream_si128(reinterpret_cast<__m128i*>(to), _mm_set_epi64x(b, a));
    _mm_stream_si128(reinterpret_cast<__m128i*>(to + 2), _mm_set_epi64x(d, c));
}
MGDT_ALWAYS_INLINE void stream_four(std::int32_t* to, std::int32_t a, std::int32_t b,
                                    std::int32_t c, std::int32_t d) noexcept {
    _mm_stream_si128(reinterpret_cast<__m128i*>(to), _mm_set_epi32(d, c, b, a));
}
// Each thread calls this function once, after its last non-temporal store.
MGDT_ALWAYS_INLINE void finish_streaming() noexcept {
    _mm_sfence();
}

#else

inline constexpr std::size_t streaming_alignment = 1;

template <class Int>
MGDT_ALWAYS_INLINE void stream_four(Int* to, Int a, Int b, Int c, Int d) noexcept {
    to[0] = a;
    to[1] = b;
    to[2] = c;
    to[3] = d;
}
MGDT_ALWAYS_INLINE void finish_streaming() noexcept {}

#endif

}  // namespace mgdt
