// SPDX-License-Identifier: MIT
// Four doubles in two registers, and the results of comparing them. Code with these types reads
// like the formula for one double. All intrinsics for doubles are here and in transpose.hpp.
#pragma once

#include <arm_neon.h>

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
        const int32x4_t upper_halves =
            vuzp2q_s32(vreinterpretq_s32_f64(low), vreinterpretq_s32_f64(high));
        return vaddvq_u32(vandq_u32(vcltzq_s32(upper_halves), uint32x4_t{1, 2, 4, 8}));
    }
    float64x2_t low, high;
};

// A FourSigns whose elements have all bits set or none.
struct FourMask : FourSigns {
    MGDT_ALWAYS_INLINE FourMask(uint64x2_t l, uint64x2_t h)
        : FourSigns{vreinterpretq_f64_u64(l), vreinterpretq_f64_u64(h)} {}
    // Sets all bits of an element to its sign bit.
    MGDT_ALWAYS_INLINE explicit FourMask(FourSigns signs)
        : FourMask(vcltzq_s64(vreinterpretq_s64_f64(signs.low)),
                   vcltzq_s64(vreinterpretq_s64_f64(signs.high))) {}
    // Which of four numbers equal `number`.
    MGDT_ALWAYS_INLINE static FourMask equal(const std::uint8_t* numbers, std::uint32_t number) {
        std::uint32_t four;
        std::memcpy(&four, numbers, sizeof four);
        const uint16x8_t wide = vmovl_u8(vcreate_u8(four));
        return equal(vmovl_u16(vget_low_u16(wide)), number);
    }
    MGDT_ALWAYS_INLINE static FourMask equal(const std::uint32_t* numbers, std::uint32_t number) {
        return equal(vld1q_u32(numbers), number);
    }
    MGDT_ALWAYS_INLINE uint64x2_t low_bits() const { return vreinterpretq_u64_f64(low); }
    MGDT_ALWAYS_INLINE uint64x2_t high_bits() const { return vreinterpretq_u64_f64(high); }
    MGDT_ALWAYS_INLINE friend FourMask operator|(FourMask a, FourMask b) {
        return {vorrq_u64(a.low_bits(), b.low_bits()), vorrq_u64(a.high_bits(), b.high_bits())};
    }
    MGDT_ALWAYS_INLINE friend FourMask operator&(FourMask a, FourMask b) {
        return {vandq_u64(a.low_bits(), b.low_bits()), vandq_u64(a.high_bits(), b.high_bits())};
    }

  private:
    MGDT_ALWAYS_INLINE static FourMask equal(uint32x4_t numbers, std::uint32_t number) {
        const int32x4_t same = vreinterpretq_s32_u32(vceqq_u32(numbers, vdupq_n_u32(number)));
        return {vreinterpretq_u64_s64(vmovl_s32(vget_low_s32(same))),
                vreinterpretq_u64_s64(vmovl_high_s32(same))};
    }
};

// Four integers of 64 bits.
struct FourIntegers {
    MGDT_ALWAYS_INLINE void store(std::int64_t* to) const {
        vst1q_s64(to, low);
        vst1q_s64(to + 2, high);
    }
    MGDT_ALWAYS_INLINE friend FourIntegers operator+(FourIntegers a, FourIntegers b) {
        return {vaddq_s64(a.low, b.low), vaddq_s64(a.high, b.high)};
    }
    MGDT_ALWAYS_INLINE friend FourIntegers operator-(FourIntegers a, FourIntegers b) {
        return {vsubq_s64(a.low, b.low), vsubq_s64(a.high, b.high)};
    }
    MGDT_ALWAYS_INLINE friend FourIntegers operator<<(FourIntegers a, int bits) {
        const int64x2_t by = vdupq_n_s64(bits);
        return {vshlq_s64(a.low, by), vshlq_s64(a.high, by)};
    }
    int64x2_t low, high;
};

struct Four {
    using Mask = FourMask;

    Four() = default;
    MGDT_ALWAYS_INLINE Four(float64x2_t l, float64x2_t h) : low(l), high(h) {}
    // Four copies of x.
    MGDT_ALWAYS_INLINE Four(double x) : low(vdupq_n_f64(x)), high(low) {}
    MGDT_ALWAYS_INLINE Four(double a, double b, double c, double d)
        : low(float64x2_t{a, b}), high(float64x2_t{c, d}) {}
    MGDT_ALWAYS_INLINE static Four load(const double* from) {
        return {vld1q_f64(from), vld1q_f64(from + 2)};
    }
    MGDT_ALWAYS_INLINE void store(double* to) const {
        vst1q_f64(to, low);
        vst1q_f64(to + 2, high);
    }
    MGDT_ALWAYS_INLINE double first() const { return vgetq_lane_f64(low, 0); }
    MGDT_ALWAYS_INLINE FourSigns signs() const { return {low, high}; }
    MGDT_ALWAYS_INLINE FourIntegers as_integers() const {
        return {vreinterpretq_s64_f64(low), vreinterpretq_s64_f64(high)};
    }

    MGDT_ALWAYS_INLINE friend Four operator+(Four a, Four b) {
        return {vaddq_f64(a.low, b.low), vaddq_f64(a.high, b.high)};
    }
    MGDT_ALWAYS_INLINE friend Four operator-(Four a, Four b) {
        return {vsubq_f64(a.low, b.low), vsubq_f64(a.high, b.high)};
    }
    MGDT_ALWAYS_INLINE friend Four operator*(Four a, Four b) {
        return {vmulq_f64(a.low, b.low), vmulq_f64(a.high, b.high)};
    }
    MGDT_ALWAYS_INLINE friend Four operator/(Four a, Four b) {
        return {vdivq_f64(a.low, b.low), vdivq_f64(a.high, b.high)};
    }
    MGDT_ALWAYS_INLINE friend FourMask operator>(Four a, Four b) {
        return {vcgtq_f64(a.low, b.low), vcgtq_f64(a.high, b.high)};
    }
    MGDT_ALWAYS_INLINE friend FourMask operator==(Four a, Four b) {
        return {vceqq_f64(a.low, b.low), vceqq_f64(a.high, b.high)};
    }
    MGDT_ALWAYS_INLINE friend FourMask operator!=(Four a, Four b) {
        const auto complement = [](uint64x2_t v) {
            return vreinterpretq_u64_u32(vmvnq_u32(vreinterpretq_u32_u64(v)));
        };
        return {complement(vceqq_f64(a.low, b.low)), complement(vceqq_f64(a.high, b.high))};
    }
    float64x2_t low, high;
};

// a b + c, rounded once.
MGDT_ALWAYS_INLINE Four multiply_add(Four a, Four b, Four c) {
    return {vfmaq_f64(c.low, a.low, b.low), vfmaq_f64(c.high, a.high, b.high)};
}
// a b - c, rounded once.
MGDT_ALWAYS_INLINE Four multiply_subtract(Four a, Four b, Four c) {
    return {vfmaq_f64(vnegq_f64(c.low), a.low, b.low),
            vfmaq_f64(vnegq_f64(c.high), a.high, b.high)};
}
MGDT_ALWAYS_INLINE Four magnitude(Four a) {
    return {vabsq_f64(a.low), vabsq_f64(a.high)};
}
MGDT_ALWAYS_INLINE Four larger(Four a, Four b) {
    return {vmaxq_f64(a.low, b.low), vmaxq_f64(a.high, b.high)};
}
// Changes the sign of a where `minus` is -0.0, and leaves it unchanged where `minus` is 0.0.
MGDT_ALWAYS_INLINE Four with_sign_changed(Four a, Four minus) {
    const auto one = [](float64x2_t x, float64x2_t y) {
        return vreinterpretq_f64_u64(veorq_u64(vreinterpretq_u64_f64(x), vreinterpretq_u64_f64(y)));
    };
    return {one(a.low, minus.low), one(a.high, minus.high)};
}
// -1 or 1, with the sign of a.
MGDT_ALWAYS_INLINE Four unit_with_sign_of(Four a) {
    const uint64x2_t sign = vdupq_n_u64(std::uint64_t{1} << 63);
    const float64x2_t one = vdupq_n_f64(1.0);
    return {vbslq_f64(sign, a.low, one), vbslq_f64(sign, a.high, one)};
}
// x if the mask is set, otherwise y.
MGDT_ALWAYS_INLINE Four where(FourMask mask, Four x, Four y) {
    return {vbslq_f64(mask.low_bits(), x.low, y.low), vbslq_f64(mask.high_bits(), x.high, y.high)};
}
MGDT_ALWAYS_INLINE Four where(FourSigns signs, Four x, Four y) {
    return where(FourMask(signs), x, y);
}
// zero_where() replaces x by 0 where the mask is set, zero_elsewhere() where it is not set.
MGDT_ALWAYS_INLINE Four zero_where(FourMask mask, Four x) {
    const auto one = [](float64x2_t v, uint64x2_t m) {
        return vreinterpretq_f64_u64(vbicq_u64(vreinterpretq_u64_f64(v), m));
    };
    return {one(x.low, mask.low_bits()), one(x.high, mask.high_bits())};
}
MGDT_ALWAYS_INLINE Four zero_elsewhere(FourMask mask, Four x) {
    const auto one = [](float64x2_t v, uint64x2_t m) {
        return vreinterpretq_f64_u64(vandq_u64(vreinterpretq_u64_f64(v), m));
    };
    return {one(x.low, mask.low_bits()), one(x.high, mask.high_bits())};
}
// The double whose upper half is a rounded to nearest, for each element.
MGDT_ALWAYS_INLINE Four to_upper_half(Four a) {
    const auto one = [](float64x2_t v) {
        return vreinterpretq_f64_u64(
            vaddq_u64(vreinterpretq_u64_f64(v), vdupq_n_u64(std::uint64_t{1} << 31)));
    };
    return {one(a.low), one(a.high)};
}

// (v0, v1, v2, v3) rotated by one position is (v1, v2, v3, v0).
template <int by>
MGDT_ALWAYS_INLINE Four turned(Four v) {
    static_assert(by > 0 && by < 4);
    if constexpr (by == 1)
        return {vextq_f64(v.low, v.high, 1), vextq_f64(v.high, v.low, 1)};
    else if constexpr (by == 2)
        return {v.high, v.low};
    else
        return {vextq_f64(v.high, v.low, 1), vextq_f64(v.low, v.high, 1)};
}
template <int by>
MGDT_ALWAYS_INLINE FourMask turned(FourMask v) {
    const Four t = turned<by>(Four(v.low, v.high));
    return {vreinterpretq_u64_f64(t.low), vreinterpretq_u64_f64(t.high)};
}
// (a0, b1, c2, a3).
MGDT_ALWAYS_INLINE Four diagonal(Four a, Four b, Four c) {
    return {vcopyq_laneq_f64(a.low, 1, b.low, 1), vcopyq_laneq_f64(a.high, 0, c.high, 0)};
}

MGDT_ALWAYS_INLINE double largest_element(Four v) {
    return vmaxvq_f64(vmaxq_f64(v.low, v.high));
}
// Four copies of the least element.
MGDT_ALWAYS_INLINE Four least_everywhere(Four v) {
    return {vminvq_f64(vminq_f64(v.low, v.high))};
}
MGDT_ALWAYS_INLINE double sum_of_elements(Four v) {
    return vpaddd_f64(vaddq_f64(v.low, v.high));
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
