// SPDX-License-Identifier: MIT
// Four rows of four doubles as columns, and the other way: for AVX2.
#pragma once

#include "kernel/vector_sphere.hpp"

#if defined(MGDT_HAVE_FOUR_ROWS)

namespace mgdt {
inline namespace MGDT_ISA {

// row(k) points to row k, aligned to 32 bytes.
struct FourRows {
    FourRows(__m256d first, __m256d second, __m256d third, __m256d fourth)
        : first(first), second(second), third(third), fourth(fourth) {}
    template <class Row>
    MGDT_ALWAYS_INLINE explicit FourRows(Row row) {
        const __m256d r0 = _mm256_load_pd(row(0)), r1 = _mm256_load_pd(row(1)),
                      r2 = _mm256_load_pd(row(2)), r3 = _mm256_load_pd(row(3));
        const __m256d odd_low = _mm256_unpacklo_pd(r0, r1), even_low = _mm256_unpackhi_pd(r0, r1);
        const __m256d odd_high = _mm256_unpacklo_pd(r2, r3), even_high = _mm256_unpackhi_pd(r2, r3);
        first = _mm256_permute2f128_pd(odd_low, odd_high, 0x20);
        second = _mm256_permute2f128_pd(even_low, even_high, 0x20);
        third = _mm256_permute2f128_pd(odd_low, odd_high, 0x31);
        fourth = _mm256_permute2f128_pd(even_low, even_high, 0x31);
    }
    // Writes the four rows whose columns these are, the k-th to row(k).
    template <class Row>
    MGDT_ALWAYS_INLINE void store_rows(Row row) const {
        const __m256d even_low = _mm256_unpacklo_pd(first, second),
                      odd_low = _mm256_unpackhi_pd(first, second),
                      even_high = _mm256_unpacklo_pd(third, fourth),
                      odd_high = _mm256_unpackhi_pd(third, fourth);
        _mm256_store_pd(row(0), _mm256_permute2f128_pd(even_low, even_high, 0x20));
        _mm256_store_pd(row(1), _mm256_permute2f128_pd(odd_low, odd_high, 0x20));
        _mm256_store_pd(row(2), _mm256_permute2f128_pd(even_low, even_high, 0x31));
        _mm256_store_pd(row(3), _mm256_permute2f128_pd(odd_low, odd_high, 0x31));
    }
    __m256d first, second, third, fourth;
};

// Points that are the first three columns, relative to others.
MGDT_ALWAYS_INLINE PointColumns<Four> relative_to(const FourRows& rows,
                                                  const PointColumns<Four>& origin) {
    return {Four::subtract(rows.first, origin.x), Four::subtract(rows.second, origin.y),
            Four::subtract(rows.third, origin.z)};
}

}  // namespace MGDT_ISA
}  // namespace mgdt

#endif
