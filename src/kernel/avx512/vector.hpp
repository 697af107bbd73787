// SPDX-License-Identifier: MIT
// Eight doubles in a register, with the functions of Four.
#pragma once

#include "kernel/avx2/vector.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

struct Eight {
    using Vector = __m512d;
    using Mask = __mmask8;
    MGDT_ALWAYS_INLINE static Mask either(Mask a, Mask b) { return static_cast<Mask>(a | b); }
    MGDT_ALWAYS_INLINE static Vector where(Mask mask, Vector x, Vector y) {
        return _mm512_mask_blend_pd(mask, y, x);
    }
    MGDT_ALWAYS_INLINE static Vector zero_where(Mask mask, Vector x) {
        return _mm512_maskz_mov_pd(static_cast<Mask>(~mask), x);
    }
    MGDT_ALWAYS_INLINE static Mask equal(const std::uint8_t* numbers, std::uint32_t number) {
        return static_cast<Mask>(
            _mm_cmpeq_epi8_mask(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(numbers)),
                                _mm_set1_epi8(static_cast<char>(number))));
    }
    MGDT_ALWAYS_INLINE static Mask equal(const std::uint32_t* numbers, std::uint32_t number) {
        return _mm256_cmpeq_epi32_mask(
            _mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers)),
            _mm256_set1_epi32(static_cast<int>(number)));
    }
    MGDT_ALWAYS_INLINE static Vector all(double x) { return _mm512_set1_pd(x); }
    MGDT_ALWAYS_INLINE static Vector multiply(Vector a, Vector b) { return _mm512_mul_pd(a, b); }
    MGDT_ALWAYS_INLINE static Vector divide(Vector a, Vector b) { return _mm512_div_pd(a, b); }
    MGDT_ALWAYS_INLINE static Vector multiply_add(Vector a, Vector b, Vector c) {
        return _mm512_fmadd_pd(a, b, c);
    }
    MGDT_ALWAYS_INLINE static Vector multiply_subtract(Vector a, Vector b, Vector c) {
        return _mm512_fmsub_pd(a, b, c);
    }
    MGDT_ALWAYS_INLINE static Vector magnitude(Vector a) { return _mm512_abs_pd(a); }
    MGDT_ALWAYS_INLINE static Vector larger(Vector a, Vector b) { return _mm512_max_pd(a, b); }
    MGDT_ALWAYS_INLINE static Mask above(Vector a, Vector b) {
        return _mm512_cmp_pd_mask(a, b, _CMP_GT_OQ);
    }
    MGDT_ALWAYS_INLINE static Vector to_upper_half(Vector a) {
        return _mm512_castsi512_pd(
            _mm512_add_epi64(_mm512_castpd_si512(a), _mm512_set1_epi64(0x80000000)));
    }
};

}  // namespace MGDT_ISLAND
}  // namespace mgdt
