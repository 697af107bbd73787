// SPDX-License-Identifier: MIT
// Four words of 32 bits in a register.
#pragma once

#include <immintrin.h>

#include <cstdint>

#include "kernel/island.hpp"
#include "platform/compiler.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// The positions of four elements among four words.
struct alignas(16) FourPositions {
    std::int32_t order[4];
};

struct FourWords {
    MGDT_ALWAYS_INLINE explicit FourWords(__m128i words) : lanes(words) {}
    // Four copies of a word.
    MGDT_ALWAYS_INLINE explicit FourWords(std::uint32_t word)
        : lanes(_mm_set1_epi32(static_cast<int>(word))) {}
    MGDT_ALWAYS_INLINE FourWords(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
        : lanes(_mm_setr_epi32(static_cast<int>(a), static_cast<int>(b), static_cast<int>(c),
                               static_cast<int>(d))) {}
    // Words whose sign bits are the bits of `bits`: bit k for word k.
    MGDT_ALWAYS_INLINE static FourWords with_sign_bits(std::uint32_t bits) {
        return FourWords(_mm_sllv_epi32(FourWords(bits).lanes, _mm_setr_epi32(31, 30, 29, 28)));
    }
    template <class Word>  // a word of 32 bits
    MGDT_ALWAYS_INLINE static FourWords load(const Word* aligned) {
        return FourWords(_mm_load_si128(reinterpret_cast<const __m128i*>(aligned)));
    }
    template <class Word>
    MGDT_ALWAYS_INLINE void store(Word* aligned) const {
        _mm_store_si128(reinterpret_cast<__m128i*>(aligned), lanes);
    }
    template <class Word>
    MGDT_ALWAYS_INLINE void store_anywhere(Word* to) const {
        _mm_storeu_si128(reinterpret_cast<__m128i*>(to), lanes);
    }
    template <int k>
    MGDT_ALWAYS_INLINE std::uint32_t element() const {
        return static_cast<std::uint32_t>(_mm_extract_epi32(lanes, k));
    }
    // The sign bits of the four words; bit k is that of word k.
    MGDT_ALWAYS_INLINE std::uint32_t sign_bits() const {
        return static_cast<std::uint32_t>(_mm_movemask_ps(_mm_castsi128_ps(lanes)));
    }
    // (w0, w1, w2, w3) rotated by one position is (w1, w2, w3, w0).
    template <int by>
    MGDT_ALWAYS_INLINE FourWords turned() const {
        return FourWords(_mm_shuffle_epi32(lanes, 0xE4E4 >> 2 * by & 0xFF));
    }
    // The words at four positions.
    MGDT_ALWAYS_INLINE FourWords at(const FourPositions& four) const {
        return FourWords(
            _mm_castps_si128(_mm_permutevar_ps(_mm_castsi128_ps(lanes), load(four.order).lanes)));
    }
    // (first, w0, w1, w2).
    MGDT_ALWAYS_INLINE FourWords behind(std::uint32_t first) const {
        return FourWords(_mm_or_si128(_mm_slli_si128(lanes, 4),
                                      _mm_cvtsi32_si128(static_cast<std::int32_t>(first))));
    }
    MGDT_ALWAYS_INLINE FourWords operator>>(int bits) const {
        return FourWords(_mm_srli_epi32(lanes, bits));
    }
    MGDT_ALWAYS_INLINE FourWords operator>>(std::uint32_t bits) const {
        return FourWords(_mm_srl_epi32(lanes, _mm_cvtsi32_si128(static_cast<int>(bits))));
    }
    MGDT_ALWAYS_INLINE friend FourWords operator&(FourWords a, FourWords b) {
        return FourWords(_mm_and_si128(a.lanes, b.lanes));
    }
    MGDT_ALWAYS_INLINE friend FourWords operator|(FourWords a, FourWords b) {
        return FourWords(_mm_or_si128(a.lanes, b.lanes));
    }
    MGDT_ALWAYS_INLINE friend FourWords operator^(FourWords a, FourWords b) {
        return FourWords(_mm_xor_si128(a.lanes, b.lanes));
    }
    // Sets all bits of a word where a and b are equal, elsewhere none.
    MGDT_ALWAYS_INLINE friend FourWords operator==(FourWords a, FourWords b) {
        return FourWords(_mm_cmpeq_epi32(a.lanes, b.lanes));
    }
    __m128i lanes;
};

// The number of set bits among the lowest four; the others are zero.
MGDT_ALWAYS_INLINE unsigned number_of_four(std::uint32_t bits) {
    return static_cast<unsigned>(__builtin_popcount(bits));
}

// The word of a where the sign bit of `signs` is set, elsewhere the word of b.
MGDT_ALWAYS_INLINE FourWords where(FourWords signs, FourWords a, FourWords b) {
    return FourWords(_mm_castps_si128(_mm_blendv_ps(
        _mm_castsi128_ps(b.lanes), _mm_castsi128_ps(a.lanes), _mm_castsi128_ps(signs.lanes))));
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
