// SPDX-License-Identifier: MIT
// Attributes and hints for the compiler, and operations that processors have instructions for.
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

// The position of the lowest bit that is set in x. x is not 0.
MGDT_ALWAYS_INLINE unsigned lowest_bit(std::uint64_t x) noexcept {
#if defined(__GNUC__)
    return static_cast<unsigned>(__builtin_ctzll(x));
#else
    unsigned i = 0;
    while (!(x >> i & 1)) ++i;
    return i;
#endif
}

// The position of the highest bit that is set in x, plus 1; 0 for 0.
MGDT_ALWAYS_INLINE unsigned bit_width(std::uint64_t x) noexcept {
#if defined(__GNUC__)
    return x ? 64 - static_cast<unsigned>(__builtin_clzll(x)) : 0;
#else
    unsigned bits = 0;
    for (; x; x >>= 1) ++bits;
    return bits;
#endif
}

// Hides the value from the optimiser, which might turn branchless code back into a branch.
MGDT_ALWAYS_INLINE std::uint32_t hide_from_optimizer(std::uint32_t x) {
#if defined(__GNUC__)
    __asm__("" : "+r"(x));
#endif
    return x;
}

}  // namespace mgdt
