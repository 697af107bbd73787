// SPDX-License-Identifier: MIT
// Helpers that lean on the compiler, and what the processor can do.
#pragma once

#include <cstdint>

#if defined(__GNUC__)
#define MGDT_ALWAYS_INLINE inline __attribute__((always_inline))
#define MGDT_NOT_INLINE __attribute__((noinline))
#define MGDT_LIKELY(condition) __builtin_expect(!!(condition), 1)
#define MGDT_UNLIKELY(condition) __builtin_expect(!!(condition), 0)
#define MGDT_MAY_DIVIDE_BY_ZERO __attribute__((no_sanitize("float-divide-by-zero")))
#else
#define MGDT_ALWAYS_INLINE inline
#define MGDT_NOT_INLINE
#define MGDT_LIKELY(condition) (condition)
#define MGDT_UNLIKELY(condition) (condition)
#define MGDT_MAY_DIVIDE_BY_ZERO
#endif

namespace mgdt {

MGDT_ALWAYS_INLINE void prefetch(const void* p) {
#if defined(__GNUC__)
    __builtin_prefetch(p);
#else
    static_cast<void>(p);
#endif
}

// Number of the lowest bit of x that is set, which some bit must be.
MGDT_ALWAYS_INLINE unsigned lowest_bit(std::uint64_t x) noexcept {
#if defined(__GNUC__)
    return static_cast<unsigned>(__builtin_ctzll(x));
#else
    unsigned i = 0;
    while (!(x >> i & 1)) ++i;
    return i;
#endif
}

// How many bits x has up to its highest that is set.
MGDT_ALWAYS_INLINE unsigned bit_width(std::uint64_t x) noexcept {
#if defined(__GNUC__)
    return x ? 64 - static_cast<unsigned>(__builtin_clzll(x)) : 0;
#else
    unsigned bits = 0;
    for (; x; x >>= 1) ++bits;
    return bits;
#endif
}

struct CpuFeatures {
    bool avx2 = false;    // and FMA, BMI 1 and 2, LZCNT, POPCNT
    bool avx512 = false;  // F, VL, DQ, BW, and all of avx2
};

// Asked of the processor itself: Valgrind, which has no AVX-512, hides it there. The compiler's
// own __builtin_cpu_supports would do the same, but runs code when the library is loaded.
CpuFeatures cpu_features() noexcept;

}  // namespace mgdt
