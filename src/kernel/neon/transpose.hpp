// SPDX-License-Identifier: MIT
// Transposes four rows of four doubles, or of their upper halves, and the reverse.
#pragma once

#include "kernel/neon/four_words.hpp"
#include "kernel/neon/vector.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// The columns of four rows; row(k) points to row k.
struct Transpose4 {
    Transpose4(Four first, Four second, Four third, Four fourth)
        : first(first), second(second), third(third), fourth(fourth) {}
    template <class Row>
    MGDT_ALWAYS_INLINE explicit Transpose4(Row row) {
        const Four r0 = Four::load(row(0)), r1 = Four::load(row(1)), r2 = Four::load(row(2)),
                   r3 = Four::load(row(3));
        first = {vtrn1q_f64(r0.low, r1.low), vtrn1q_f64(r2.low, r3.low)};
        second = {vtrn2q_f64(r0.low, r1.low), vtrn2q_f64(r2.low, r3.low)};
        third = {vtrn1q_f64(r0.high, r1.high), vtrn1q_f64(r2.high, r3.high)};
        fourth = {vtrn2q_f64(r0.high, r1.high), vtrn2q_f64(r2.high, r3.high)};
    }
    // The columns of four rows of upper halves.
    template <class Row>
    MGDT_ALWAYS_INLINE static Transpose4 of_upper_halves(Row row) {
        const auto load = [&](unsigned k) { return FourWords::load(row(k)).lanes; };
        const uint32x4_t r0 = load(0), r1 = load(1), r2 = load(2), r3 = load(3),
                         zero = vdupq_n_u32(0);
        const uint32x4_t low_left = vzip1q_u32(r0, r1), low_right = vzip2q_u32(r0, r1),
                         high_left = vzip1q_u32(r2, r3), high_right = vzip2q_u32(r2, r3);
        const auto one = [&](uint32x4_t low, uint32x4_t high) {
            return Four(vreinterpretq_f64_u32(vzip1q_u32(zero, low)),
                        vreinterpretq_f64_u32(vzip1q_u32(zero, high)));
        };
        const auto other = [&](uint32x4_t low, uint32x4_t high) {
            return Four(vreinterpretq_f64_u32(vzip2q_u32(zero, low)),
                        vreinterpretq_f64_u32(vzip2q_u32(zero, high)));
        };
        return {one(low_left, high_left), other(low_left, high_left), one(low_right, high_right),
                other(low_right, high_right)};
    }
    // Transposes the columns back: calls store(k, row) with the upper halves of each row in
    // sequence, until store() returns false.
    template <class Store>
    MGDT_ALWAYS_INLINE void store_upper_halves(Store store) const {
        const auto pairs = [](float64x2_t left, float64x2_t right) {
            return vreinterpretq_u64_u32(
                vtrn2q_u32(vreinterpretq_u32_f64(left), vreinterpretq_u32_f64(right)));
        };
        const uint64x2_t low_left = pairs(first.low, second.low),
                         low_right = pairs(third.low, fourth.low),
                         high_left = pairs(first.high, second.high),
                         high_right = pairs(third.high, fourth.high);
        const auto row = [](uint64x2_t words) { return FourWords(vreinterpretq_u32_u64(words)); };
        static_cast<void>(store(0, row(vzip1q_u64(low_left, low_right))) &&
                          store(1, row(vzip2q_u64(low_left, low_right))) &&
                          store(2, row(vzip1q_u64(high_left, high_right))) &&
                          store(3, row(vzip2q_u64(high_left, high_right))));
    }
    Four first, second, third, fourth;
};

}  // namespace MGDT_ISLAND
}  // namespace mgdt
