// SPDX-License-Identifier: MIT
// Four doubles in a register, and the results of comparing them. Code with these types reads like
// the formula for one double. All intrinsics for doubles are here and in transpose.hpp.
#pragma once

#include <immintrin.h>

#include <cstdint>
#include <cstring>

#include "kernel/island.hpp"
#include "platform/compiler.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// A truth value for each of four elements: the sign bit of a double. The other bits have no
// meaning.
struct FourSigns {
    // The truth values as bits, the first in the lowest bit.
    MGDT_ALWAYS_INLINE std::uint32_t bits() const {
        return static_cast<std::uint32_t>(_mm256_movemask_pd(lanes));
    }
    __m256d lanes;
};

// A FourSigns whose elements have all bits set or none.
struct FourMask : FourSigns {
    explicit FourMask(__m256d lanes) : FourSigns{lanes} {}
    // Sets all bits of an element to its sign bit.
    MGDT_ALWAYS_INLINE explicit FourMask(FourSigns signs)
        : FourSigns{_mm256_castsi256_pd(
              _mm256_cmpgt_epi64(_mm256_setzero_si256(), _mm256_castpd_si256(signs.lanes)))} {}
    // Which of four numbers equal `number`.
    MGDT_ALWAYS_INLINE static FourMask equal(const std::uint8_t* numbers, std::uint32_t number) {
        std::int32_t four;
        std::memcpy(&four, numbers, sizeof four);
        return equal(_mm_cvtepu8_epi32(_mm_cvtsi32_si128(four)), number);
    }
    MGDT_ALWAYS_INLINE static FourMask equal(const std::uint32_t* numbers, std::uint32_t number) {
        return equal(_mm_loadu_si128(reinterpret_cast<const __m128i*>(numbers)), number);
    }
    MGDT_ALWAYS_INLINE friend FourMask operator|(FourMask a, FourMask b) {
        return FourMask(_mm256_or_pd(a.lanes, b.lanes));
    }
    MGDT_ALWAYS_INLINE friend FourMask operator&(FourMask a, FourMask b) {
        return FourMask(_mm256_and_pd(a.lanes, b.lanes));
    }

  private:
    MGDT_ALWAYS_INLINE static FourMask equal(__m128i numbers, std::uint32_t number) {
        const __m128i same = _mm_cmpeq_epi32(numbers, _mm_set1_epi32(static_cast<int>(number)));
        return FourMask(_mm256_castsi256_pd(_mm256_cvtepi32_epi64(same)));
    }
};

// Four integers of 64 bits.
struct FourIntegers {
    MGDT_ALWAYS_INLINE void store(std::int64_t* aligned) const {
        _mm256_store_si256(reinterpret_cast<__m256i*>(aligned), lanes);
    }
    MGDT_ALWAYS_INLINE friend FourIntegers operator+(FourIntegers a, FourIntegers b) {
        return {_mm256_add_epi64(a.lanes, b.lanes)};
    }
    MGDT_ALWAYS_INLINE friend FourIntegers operator-(FourIntegers a, FourIntegers b) {
        return {_mm256_sub_epi64(a.lanes, b.lanes)};
    }
    MGDT_ALWAYS_INLINE friend FourIntegers operator<<(FourIntegers a, int bits) {
        return {_mm256_slli_epi64(a.lanes, bits)};
    }
    __m256i lanes;
};

struct Four {
    using Mask = FourMask;

    Four() = default;
    MGDT_ALWAYS_INLINE explicit Four(__m256d v) : lanes(v) {}
    // Four copies of x.
    MGDT_ALWAYS_INLINE Four(double x) : lanes(_mm256_set1_pd(x)) {}
    MGDT_ALWAYS_INLINE Four(double a, double b, double c, double d)
        : lanes(_mm256_setr_pd(a, b, c, d)) {}
    MGDT_ALWAYS_INLINE static Four load(const double* aligned) {
        return Four(_mm256_load_pd(aligned));
    }
    MGDT_ALWAYS_INLINE void store(double* aligned) const { _mm256_store_pd(aligned, lanes); }
    MGDT_ALWAYS_INLINE double first() const { return _mm256_cvtsd_f64(lanes); }
    MGDT_ALWAYS_INLINE FourSigns signs() const { return {lanes}; }
    MGDT_ALWAYS_INLINE FourIntegers as_integers() const { return {_mm256_castpd_si256(lanes)}; }

    MGDT_ALWAYS_INLINE friend Four operator+(Four a, Four b) {
        return Four(_mm256_add_pd(a.lanes, b.lanes));
    }
    MGDT_ALWAYS_INLINE friend Four operator-(Four a, Four b) {
        return Four(_mm256_sub_pd(a.lanes, b.lanes));
    }
    MGDT_ALWAYS_INLINE friend Four operator*(Four a, Four b) {
        return Four(_mm256_mul_pd(a.lanes, b.lanes));
    }
    MGDT_ALWAYS_INLINE friend Four operator/(Four a, Four b) {
        return Four(_mm256_div_pd(a.lanes, b.lanes));
    }
    MGDT_ALWAYS_INLINE friend FourMask operator>(Four a, Four b) {
        return FourMask(_mm256_cmp_pd(a.lanes, b.lanes, _CMP_GT_OQ));
    }
    MGDT_ALWAYS_INLINE friend FourMask operator==(Four a, Four b) {
        return FourMask(_mm256_cmp_pd(a.lanes, b.lanes, _CMP_EQ_OQ));
    }
    MGDT_ALWAYS_INLINE friend FourMask operator!=(Four a, Four b) {
        return FourMask(_mm256_cmp_pd(a.lanes, b.lanes, _CMP_NEQ_UQ));
    }
    __m256d lanes;
};

// a b + c, rounded once.
MGDT_ALWAYS_INLINE Four multiply_add(Four a, Four b, Four c) {
    return Four(_mm256_fmadd_pd(a.lanes, b.lanes, c.lanes));
}
// a b - c, rounded once.
MGDT_ALWAYS_INLINE Four multiply_subtract(Four a, Four b, Four c) {
    return Four(_mm256_fmsub_pd(a.lanes, b.lanes, c.lanes));
}
MGDT_ALWAYS_INLINE Four magnitude(Four a) {
    return Four(_mm256_andnot_pd(_mm256_set1_pd(-0.0), a.lanes));
}
MGDT_ALWAYS_INLINE Four larger(Four a, Four b) {
    return Four(_mm256_max_pd(a.lanes, b.lanes));
}
MGDT_ALWAYS_INLINE Four smaller(Four a, Four b) {
    return Four(_mm256_min_pd(a.lanes, b.lanes));
}
// Changes the sign of a where `minus` is -0.0, and leaves it unchanged where `minus` is 0.0.
MGDT_ALWAYS_INLINE Four with_sign_changed(Four a, Four minus) {
    return Four(_mm256_xor_pd(a.lanes, minus.lanes));
}
// -1 or 1, with the sign of a.
MGDT_ALWAYS_INLINE Four unit_with_sign_of(Four a) {
    return Four(_mm256_or_pd(_mm256_set1_pd(1.0), _mm256_and_pd(a.lanes, _mm256_set1_pd(-0.0))));
}
// x if the mask is set, otherwise y.
MGDT_ALWAYS_INLINE Four where(FourSigns mask, Four x, Four y) {
    return Four(_mm256_blendv_pd(y.lanes, x.lanes, mask.lanes));
}
// zero_where() replaces x by 0 where the mask is set, zero_elsewhere() where it is not set.
MGDT_ALWAYS_INLINE Four zero_where(FourMask mask, Four x) {
    return Four(_mm256_andnot_pd(mask.lanes, x.lanes));
}
MGDT_ALWAYS_INLINE Four zero_elsewhere(FourMask mask, Four x) {
    return Four(_mm256_and_pd(mask.lanes, x.lanes));
}
// The double whose upper half is a rounded to nearest, for each element.
MGDT_ALWAYS_INLINE Four to_upper_half(Four a) {
    return Four(_mm256_castsi256_pd(
        _mm256_add_epi64(_mm256_castpd_si256(a.lanes), _mm256_set1_epi64x(0x80000000))));
}

// (v0, v1, v2, v3) rotated by one position is (v1, v2, v3, v0).
template <int by>
MGDT_ALWAYS_INLINE Four turned(Four v) {
    constexpr int order = 0xE4E4 >> 2 * by & 0xFF;
    return Four(_mm256_permute4x64_pd(v.lanes, order));
}
template <int by>
MGDT_ALWAYS_INLINE FourMask turned(FourMask v) {
    return FourMask(turned<by>(Four(v.lanes)).lanes);
}
// (a0, b1, c2, a3).
MGDT_ALWAYS_INLINE Four diagonal(Four a, Four b, Four c) {
    return Four(_mm256_blend_pd(_mm256_blend_pd(a.lanes, b.lanes, 2), c.lanes, 4));
}

MGDT_ALWAYS_INLINE double largest_element(Four v) {
    const __m128d pair =
        _mm_max_pd(_mm256_castpd256_pd128(v.lanes), _mm256_extractf128_pd(v.lanes, 1));
    return _mm_cvtsd_f64(_mm_max_sd(pair, _mm_unpackhi_pd(pair, pair)));
}
// Four copies of the least element.
MGDT_ALWAYS_INLINE Four least_everywhere(Four v) {
    const Four pairs = smaller(v, Four(_mm256_permute_pd(v.lanes, 5)));
    return smaller(pairs, Four(_mm256_permute2f128_pd(pairs.lanes, pairs.lanes, 1)));
}
MGDT_ALWAYS_INLINE double sum_of_elements(Four v) {
    const __m128d pair =
        _mm_add_pd(_mm256_castpd256_pd128(v.lanes), _mm256_extractf128_pd(v.lanes, 1));
    return _mm_cvtsd_f64(_mm_add_sd(pair, _mm_unpackhi_pd(pair, pair)));
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
