// SPDX-License-Identifier: MIT
// Four words of 32 bits in a register.
#pragma once

#include <arm_neon.h>

#include <cstdint>

#include "kernel/island.hpp"
#include "platform/compiler.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// The positions of four elements among four words, as positions of their bytes.
struct alignas(16) FourPositions {
    constexpr FourPositions(unsigned a, unsigned b, unsigned c, unsigned d) : bytes() {
        const unsigned words[4] = {a, b, c, d};
        for (unsigned i = 0; i < 16; ++i)
            bytes[i] = static_cast<std::uint8_t>(4 * words[i / 4] + i % 4);
    }
    std::uint8_t bytes[16];
};

struct FourWords {
    MGDT_ALWAYS_INLINE explicit FourWords(uint32x4_t words) : lanes(words) {}
    // Four copies of a word.
    MGDT_ALWAYS_INLINE explicit FourWords(std::uint32_t word) : lanes(vdupq_n_u32(word)) {}
    MGDT_ALWAYS_INLINE FourWords(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d)
        : lanes(uint32x4_t{a, b, c, d}) {}
    // Words whose sign bits are the bits of `bits`: bit k for word k.
    MGDT_ALWAYS_INLINE static FourWords with_sign_bits(std::uint32_t bits) {
        return FourWords(vshlq_u32(vdupq_n_u32(bits), int32x4_t{31, 30, 29, 28}));
    }
    template <class Word>  // a word of 32 bits
    MGDT_ALWAYS_INLINE static FourWords load(const Word* aligned) {
        return FourWords(vld1q_u32(reinterpret_cast<const std::uint32_t*>(aligned)));
    }
    template <class Word>
    MGDT_ALWAYS_INLINE void store(Word* aligned) const {
        vst1q_u32(reinterpret_cast<std::uint32_t*>(aligned), lanes);
    }
    template <class Word>
    MGDT_ALWAYS_INLINE void store_anywhere(Word* to) const {
        store(to);
    }
    template <int k>
    MGDT_ALWAYS_INLINE std::uint32_t element() const {
        return vgetq_lane_u32(lanes, k);
    }
    // The sign bits of the four words; bit k is that of word k.
    MGDT_ALWAYS_INLINE std::uint32_t sign_bits() const {
        const uint32x4_t is_negative = vcltzq_s32(vreinterpretq_s32_u32(lanes));
        return vaddvq_u32(vandq_u32(is_negative, uint32x4_t{1, 2, 4, 8}));
    }
    // (w0, w1, w2, w3) rotated by one position is (w1, w2, w3, w0).
    template <int by>
    MGDT_ALWAYS_INLINE FourWords turned() const {
        return FourWords(vextq_u32(lanes, lanes, by));
    }
    // The words at four positions.
    MGDT_ALWAYS_INLINE FourWords at(const FourPositions& four) const {
        return FourWords(
            vreinterpretq_u32_u8(vqtbl1q_u8(vreinterpretq_u8_u32(lanes), vld1q_u8(four.bytes))));
    }
    // (first, w0, w1, w2).
    MGDT_ALWAYS_INLINE FourWords behind(std::uint32_t first) const {
        return FourWords(vextq_u32(vdupq_n_u32(first), lanes, 3));
    }
    MGDT_ALWAYS_INLINE FourWords operator>>(int bits) const {
        return FourWords(vshlq_u32(lanes, vdupq_n_s32(-bits)));
    }
    MGDT_ALWAYS_INLINE FourWords operator>>(std::uint32_t bits) const {
        return *this >> static_cast<int>(bits);
    }
    MGDT_ALWAYS_INLINE friend FourWords operator&(FourWords a, FourWords b) {
        return FourWords(vandq_u32(a.lanes, b.lanes));
    }
    MGDT_ALWAYS_INLINE friend FourWords operator|(FourWords a, FourWords b) {
        return FourWords(vorrq_u32(a.lanes, b.lanes));
    }
    MGDT_ALWAYS_INLINE friend FourWords operator^(FourWords a, FourWords b) {
        return FourWords(veorq_u32(a.lanes, b.lanes));
    }
    // Sets all bits of a word where a and b are equal, elsewhere none.
    MGDT_ALWAYS_INLINE friend FourWords operator==(FourWords a, FourWords b) {
        return FourWords(vceqq_u32(a.lanes, b.lanes));
    }
    uint32x4_t lanes;
};

// The number of set bits among the lowest four. The function uses neither a table in memory nor the
// vector registers, in which the processor counts bits.
MGDT_ALWAYS_INLINE unsigned number_of_four(std::uint32_t bits) {
    return static_cast<unsigned>(0x4332322132212110u >> 4 * bits & 15);
}

// The word of a where the sign bit of `signs` is set, elsewhere the word of b.
MGDT_ALWAYS_INLINE FourWords where(FourWords signs, FourWords a, FourWords b) {
    return FourWords(vbslq_u32(vcltzq_s32(vreinterpretq_s32_u32(signs.lanes)), a.lanes, b.lanes));
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
