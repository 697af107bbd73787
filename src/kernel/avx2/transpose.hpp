// SPDX-License-Identifier: MIT
// Transposes four rows of four doubles, or of their upper halves, and the reverse.
#pragma once

#include "kernel/avx2/four_words.hpp"
#include "kernel/avx2/vector.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// The columns of four rows; row(k) points to row k, which is aligned to 32 bytes.
struct Transpose4 {
    Transpose4(Four first, Four second, Four third, Four fourth)
        : first(first), second(second), third(third), fourth(fourth) {}
    template <class Row>
    MGDT_ALWAYS_INLINE explicit Transpose4(Row row) {
        const __m256d r0 = _mm256_load_pd(row(0)), r1 = _mm256_load_pd(row(1)),
                      r2 = _mm256_load_pd(row(2)), r3 = _mm256_load_pd(row(3));
        const __m256d odd_low = _mm256_unpacklo_pd(r0, r1), even_low = _mm256_unpackhi_pd(r0, r1);
        const __m256d odd_high = _mm256_unpacklo_pd(r2, r3), even_high = _mm256_unpackhi_pd(r2, r3);
        first = Four(_mm256_permute2f128_pd(odd_low, odd_high, 0x20));
        second = Four(_mm256_permute2f128_pd(even_low, even_high, 0x20));
        third = Four(_mm256_permute2f128_pd(odd_low, odd_high, 0x31));
        fourth = Four(_mm256_permute2f128_pd(even_low, even_high, 0x31));
    }
    // The columns of four rows of upper halves, which are aligned to 16 bytes.
    template <class Row>
    MGDT_ALWAYS_INLINE static Transpose4 of_upper_halves(Row row) {
        const auto two = [&](unsigned low, unsigned high) {
            const auto load = [&](unsigned k) {
                return _mm_load_si128(reinterpret_cast<const __m128i*>(row(k)));
            };
            return _mm256_inserti128_si256(_mm256_castsi128_si256(load(low)), load(high), 1);
        };
        const __m256i even = two(0, 2), odd = two(1, 3), zero = _mm256_setzero_si256();
        const __m256i low = _mm256_unpacklo_epi32(even, odd),
                      high = _mm256_unpackhi_epi32(even, odd);
        return {Four(_mm256_castsi256_pd(_mm256_unpacklo_epi32(zero, low))),
                Four(_mm256_castsi256_pd(_mm256_unpackhi_epi32(zero, low))),
                Four(_mm256_castsi256_pd(_mm256_unpacklo_epi32(zero, high))),
                Four(_mm256_castsi256_pd(_mm256_unpackhi_epi32(zero, high)))};
    }
    // Transposes the columns back: calls store(k, row) with the upper halves of each row in
    // sequence, until store() returns false.
    template <class Store>
    MGDT_ALWAYS_INLINE void store_upper_halves(Store store) const {
        const auto pairs = [](Four low, Four high) {
            return _mm256_castps_pd(_mm256_blend_ps(_mm256_movehdup_ps(_mm256_castpd_ps(low.lanes)),
                                                    _mm256_castpd_ps(high.lanes), 0xAA));
        };
        const __m256d left = pairs(first, second), right = pairs(third, fourth);
        const __m256i even = _mm256_castpd_si256(_mm256_unpacklo_pd(left, right)),
                      odd = _mm256_castpd_si256(_mm256_unpackhi_pd(left, right));
        static_cast<void>(store(0, FourWords(_mm256_castsi256_si128(even))) &&
                          store(1, FourWords(_mm256_castsi256_si128(odd))) &&
                          store(2, FourWords(_mm256_extracti128_si256(even, 1))) &&
                          store(3, FourWords(_mm256_extracti128_si256(odd, 1))));
    }
    Four first, second, third, fourth;
};

}  // namespace MGDT_ISLAND
}  // namespace mgdt
