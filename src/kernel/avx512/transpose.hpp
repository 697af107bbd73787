// SPDX-License-Identifier: MIT
// Transposes eight rows of four doubles, or of their upper halves, to columns of eight, and the
// reverse.
#pragma once

#include "kernel/avx512/vector.hpp"
#include "kernel/sphere_columns.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// The first three columns of eight rows. row(k) points to row k, which is aligned to 32 bytes.
template <class Row>
MGDT_ALWAYS_INLINE PointColumns<Eight> first_columns(Row row) {
    const auto two = [&](unsigned low, unsigned high) {
        return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_load_pd(row(low))),
                                  _mm256_load_pd(row(high)), 1);
    };
    // If rows are interleaved in this order, lanes of 128 bits are consecutive pieces of columns.
    const __m512d r02 = two(0, 2), r13 = two(1, 3), r46 = two(4, 6), r57 = two(5, 7);
    const __m512d odd_low = _mm512_unpacklo_pd(r02, r13), even_low = _mm512_unpackhi_pd(r02, r13),
                  odd_high = _mm512_unpacklo_pd(r46, r57), even_high = _mm512_unpackhi_pd(r46, r57);
    return {Eight(_mm512_shuffle_f64x2(odd_low, odd_high, 0x88)),
            Eight(_mm512_shuffle_f64x2(even_low, even_high, 0x88)),
            Eight(_mm512_shuffle_f64x2(odd_low, odd_high, 0xDD))};
}

// Calls store(k, sphere) with the upper halves of w and e of each sphere in sequence, until store()
// returns false.
template <class Store>
MGDT_ALWAYS_INLINE void store_upper_halves(const SphereColumns<Eight>& s, Store store) {
    const auto pairs = [](Eight low, Eight high) {
        return _mm512_castps_pd(_mm512_mask_movehdup_ps(_mm512_castpd_ps(high.lanes), 0x5555,
                                                        _mm512_castpd_ps(low.lanes)));
    };
    const __m512d left = pairs(s.x, s.y), right = pairs(s.z, s.e);
    // Each lane of 128 bits has the upper halves of one sphere.
    const __m512i even = _mm512_castpd_si512(_mm512_unpacklo_pd(left, right)),
                  odd = _mm512_castpd_si512(_mm512_unpackhi_pd(left, right));
    static_cast<void>(store(0, FourWords(_mm512_castsi512_si128(even))) &&
                      store(1, FourWords(_mm512_castsi512_si128(odd))) &&
                      store(2, FourWords(_mm512_extracti32x4_epi32(even, 1))) &&
                      store(3, FourWords(_mm512_extracti32x4_epi32(odd, 1))) &&
                      store(4, FourWords(_mm512_extracti32x4_epi32(even, 2))) &&
                      store(5, FourWords(_mm512_extracti32x4_epi32(odd, 2))) &&
                      store(6, FourWords(_mm512_extracti32x4_epi32(even, 3))) &&
                      store(7, FourWords(_mm512_extracti32x4_epi32(odd, 3))));
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
