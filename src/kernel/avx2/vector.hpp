// SPDX-License-Identifier: MIT
// Four doubles in a register.
#pragma once

#include <immintrin.h>

#include <cstdint>
#include <cstring>

#include "kernel/island.hpp"
#include "platform/compiler.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

struct Four {
    using Vector = __m256d;
    using Mask = __m256d;  // all bits of an element or none
    MGDT_ALWAYS_INLINE static Mask either(Mask a, Mask b) { return _mm256_or_pd(a, b); }
    MGDT_ALWAYS_INLINE static Vector where(Mask mask, Vector x, Vector y) {
        return _mm256_blendv_pd(y, x, mask);
    }
    MGDT_ALWAYS_INLINE static Vector zero_where(Mask mask, Vector x) {
        return _mm256_andnot_pd(mask, x);
    }
    // Which of so many numbers equal one.
    MGDT_ALWAYS_INLINE static Mask equal(const std::uint8_t* numbers, std::uint32_t number) {
        std::int32_t four;
        std::memcpy(&four, numbers, sizeof four);
        return equal(_mm_cvtepu8_epi32(_mm_cvtsi32_si128(four)), number);
    }
    MGDT_ALWAYS_INLINE static Mask equal(const std::uint32_t* numbers, std::uint32_t number) {
        return equal(_mm_loadu_si128(reinterpret_cast<const __m128i*>(numbers)), number);
    }
    MGDT_ALWAYS_INLINE static Vector all(double x) { return _mm256_set1_pd(x); }
    MGDT_ALWAYS_INLINE static Vector subtract(Vector a, Vector b) { return _mm256_sub_pd(a, b); }
    MGDT_ALWAYS_INLINE static Vector multiply(Vector a, Vector b) { return _mm256_mul_pd(a, b); }
    MGDT_ALWAYS_INLINE static Vector divide(Vector a, Vector b) { return _mm256_div_pd(a, b); }
    // a * b + c, a * b - c
    MGDT_ALWAYS_INLINE static Vector multiply_add(Vector a, Vector b, Vector c) {
        return _mm256_fmadd_pd(a, b, c);
    }
    MGDT_ALWAYS_INLINE static Vector multiply_subtract(Vector a, Vector b, Vector c) {
        return _mm256_fmsub_pd(a, b, c);
    }
    MGDT_ALWAYS_INLINE static Vector magnitude(Vector a) {
        return _mm256_andnot_pd(_mm256_set1_pd(-0.0), a);
    }
    MGDT_ALWAYS_INLINE static Vector larger(Vector a, Vector b) { return _mm256_max_pd(a, b); }
    MGDT_ALWAYS_INLINE static Mask above(Vector a, Vector b) {
        return _mm256_cmp_pd(a, b, _CMP_GT_OQ);
    }
    // Numbers whose upper halves are these rounded to nearest.
    MGDT_ALWAYS_INLINE static Vector to_upper_half(Vector a) {
        return _mm256_castsi256_pd(
            _mm256_add_epi64(_mm256_castpd_si256(a), _mm256_set1_epi64x(0x80000000)));
    }

  private:
    MGDT_ALWAYS_INLINE static Mask equal(__m128i numbers, std::uint32_t number) {
        const __m128i same = _mm_cmpeq_epi32(numbers, _mm_set1_epi32(static_cast<int>(number)));
        return _mm256_castsi256_pd(_mm256_cvtepi32_epi64(same));
    }
};

}  // namespace MGDT_ISLAND
}  // namespace mgdt
