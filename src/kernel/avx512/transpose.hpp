// SPDX-License-Identifier: MIT
// Eight rows of four doubles, aligned to 32 bytes, as columns of eight, of which the first three
// are wanted.
#pragma once

#include "kernel/avx2/transpose.hpp"
#include "kernel/avx512/vector.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

class Transpose8 {
  public:
    // row(k) points to row k.
    template <class Row>
    MGDT_ALWAYS_INLINE explicit Transpose8(Row row) {
        const auto two = [&](unsigned low, unsigned high) {
            return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_load_pd(row(low))),
                                      _mm256_load_pd(row(high)), 1);
        };
        // Interleaved in this order, lanes of 128 bits are pieces of columns in order.
        const __m512d r02 = two(0, 2), r13 = two(1, 3), r46 = two(4, 6), r57 = two(5, 7);
        odd_low_ = _mm512_unpacklo_pd(r02, r13);
        even_low_ = _mm512_unpackhi_pd(r02, r13);
        odd_high_ = _mm512_unpacklo_pd(r46, r57);
        even_high_ = _mm512_unpackhi_pd(r46, r57);
    }
    MGDT_ALWAYS_INLINE __m512d first() const {
        return _mm512_shuffle_f64x2(odd_low_, odd_high_, 0x88);
    }
    MGDT_ALWAYS_INLINE __m512d second() const {
        return _mm512_shuffle_f64x2(even_low_, even_high_, 0x88);
    }
    MGDT_ALWAYS_INLINE __m512d third() const {
        return _mm512_shuffle_f64x2(odd_low_, odd_high_, 0xDD);
    }

  private:
    __m512d odd_low_, odd_high_, even_low_, even_high_;
};

}  // namespace MGDT_ISLAND
}  // namespace mgdt
