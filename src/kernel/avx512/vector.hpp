// SPDX-License-Identifier: MIT
// Eight doubles in a register, with the functions of Four. All AVX-512 intrinsics for doubles are
// here and in transpose.hpp.
#pragma once

#include "kernel/avx2/four_words.hpp"
#include "kernel/avx2/vector.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// A truth value for each of eight elements.
struct EightMask {
    explicit EightMask(__mmask8 lanes) : lanes(lanes) {}
    // Which of eight numbers equal `number`.
    MGDT_ALWAYS_INLINE static EightMask equal(const std::uint8_t* numbers, std::uint32_t number) {
        return EightMask(static_cast<__mmask8>(
            _mm_cmpeq_epi8_mask(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(numbers)),
                                _mm_set1_epi8(static_cast<char>(number)))));
    }
    MGDT_ALWAYS_INLINE static EightMask equal(const std::uint32_t* numbers, std::uint32_t number) {
        return EightMask(
            _mm256_cmpeq_epi32_mask(_mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers)),
                                    _mm256_set1_epi32(static_cast<int>(number))));
    }
    MGDT_ALWAYS_INLINE friend EightMask operator|(EightMask a, EightMask b) {
        return EightMask(static_cast<__mmask8>(a.lanes | b.lanes));
    }
    __mmask8 lanes;
};

// The numbers of eight elements to select.
struct EightNumbers {
    MGDT_ALWAYS_INLINE explicit EightNumbers(const std::uint8_t* numbers)
        : lanes(_mm512_cvtepu8_epi64(_mm_loadl_epi64(reinterpret_cast<const __m128i*>(numbers)))) {}
    // Which of the numbers have this bit set.
    MGDT_ALWAYS_INLINE EightMask have(unsigned bit) const {
        return EightMask(_mm512_test_epi64_mask(lanes, _mm512_set1_epi64(bit)));
    }
    __m512i lanes;
};

struct Eight {
    using Mask = EightMask;

    Eight() = default;
    MGDT_ALWAYS_INLINE explicit Eight(__m512d v) : lanes(v) {}
    // Eight copies of x.
    MGDT_ALWAYS_INLINE Eight(double x) : lanes(_mm512_set1_pd(x)) {}
    // from[numbers[k]] for each k.
    MGDT_ALWAYS_INLINE static Eight gather(const double* from, const std::uint32_t* numbers) {
        const __m256i i = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(numbers));
        return Eight(_mm512_i32gather_pd(i, from, 8));
    }

    MGDT_ALWAYS_INLINE friend Eight operator-(Eight a, Eight b) {
        return Eight(_mm512_sub_pd(a.lanes, b.lanes));
    }
    MGDT_ALWAYS_INLINE friend Eight operator*(Eight a, Eight b) {
        return Eight(_mm512_mul_pd(a.lanes, b.lanes));
    }
    MGDT_ALWAYS_INLINE friend Eight operator/(Eight a, Eight b) {
        return Eight(_mm512_div_pd(a.lanes, b.lanes));
    }
    MGDT_ALWAYS_INLINE friend EightMask operator>(Eight a, Eight b) {
        return EightMask(_mm512_cmp_pd_mask(a.lanes, b.lanes, _CMP_GT_OQ));
    }
    __m512d lanes;
};

MGDT_ALWAYS_INLINE Eight multiply_add(Eight a, Eight b, Eight c) {
    return Eight(_mm512_fmadd_pd(a.lanes, b.lanes, c.lanes));
}
MGDT_ALWAYS_INLINE Eight multiply_subtract(Eight a, Eight b, Eight c) {
    return Eight(_mm512_fmsub_pd(a.lanes, b.lanes, c.lanes));
}
MGDT_ALWAYS_INLINE Eight magnitude(Eight a) {
    return Eight(_mm512_abs_pd(a.lanes));
}
MGDT_ALWAYS_INLINE Eight larger(Eight a, Eight b) {
    return Eight(_mm512_max_pd(a.lanes, b.lanes));
}
MGDT_ALWAYS_INLINE Eight where(EightMask mask, Eight x, Eight y) {
    return Eight(_mm512_mask_blend_pd(mask.lanes, y.lanes, x.lanes));
}
MGDT_ALWAYS_INLINE Eight zero_where(EightMask mask, Eight x) {
    return Eight(_mm512_maskz_mov_pd(static_cast<__mmask8>(~mask.lanes), x.lanes));
}
MGDT_ALWAYS_INLINE Eight to_upper_half(Eight a) {
    return Eight(_mm512_castsi512_pd(
        _mm512_add_epi64(_mm512_castpd_si512(a.lanes), _mm512_set1_epi64(0x80000000))));
}
// Selects elements by number, modulo 16, from the eight of a followed by the eight of b.
MGDT_ALWAYS_INLINE Eight elements(EightNumbers numbers, Eight a, Eight b) {
    return Eight(_mm512_permutex2var_pd(a.lanes, numbers.lanes, b.lanes));
}

// The words whose bits are set, moved to the front and followed by zeros.
MGDT_ALWAYS_INLINE FourWords compressed(FourWords words, std::uint32_t bits) {
    return FourWords(_mm_maskz_compress_epi32(static_cast<__mmask8>(bits), words.lanes));
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
