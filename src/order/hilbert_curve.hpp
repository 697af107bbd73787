// SPDX-License-Identifier: MIT
// The three-dimensional Hilbert curve, three levels at a time from a table.
#pragma once

#include <cstdint>

namespace mgdt {

// The curve in a cube consists of 8 copies of itself in the octants; each copy begins next to where
// the previous one ends. The state of a copy is its orientation: the corner where it enters the
// cube (e, 0..7) and the axis along which it leaves (d, 0..2); state = 3 e + d. The rule for the
// children is Hamilton's, "Compact Hilbert indices" (Dalhousie CS-2006-07), sections 2.1-2.3:
// octants in Gray-code order, entry points and directions by the lemmas 2.8 and 2.11.
class HilbertCurve {
  public:
    static constexpr unsigned levels_per_step = 3;
    static constexpr unsigned first_state = 0;

    constexpr HilbertCurve() noexcept : step_() {
        std::uint8_t digit[states][8] = {}, next[states][8] = {};
        for (unsigned s = 0; s < states; ++s) {
            for (unsigned octant = 0; octant < 8; ++octant) {
                digit[s][octant] = static_cast<std::uint8_t>(position(s, octant));
                next[s][octant] = static_cast<std::uint8_t>(child(s, digit[s][octant]));
            }
        }
        for (unsigned s = 0; s < states; ++s) {
            for (unsigned cell = 0; cell < 512; ++cell) {
                const unsigned x = cell >> 6, y = cell >> 3, z = cell;
                unsigned state = s, digits = 0;
                for (unsigned level = levels_per_step; level-- > 0;) {
                    const unsigned octant =
                        (x >> level & 1) | (y >> level & 1) << 1 | (z >> level & 1) << 2;
                    digits = digits << 3 | digit[state][octant];
                    state = next[state][octant];
                }
                step_[s << 9 | cell] = static_cast<std::uint16_t>(state << 9 | digits);
            }
        }
    }

    // The position along the curve of the cell (x, y, z), with 2^(3 steps) cells along each axis.
    // `state` is the state of the whole cube on entry and the state of the cell on return.
    std::uint64_t key(std::uint32_t x, std::uint32_t y, std::uint32_t z, unsigned steps,
                      unsigned& state) const noexcept {
        std::uint64_t key = 0;
        unsigned s = state << 9;
        for (unsigned shift = 3 * steps; shift > 0;) {
            shift -= 3;
            const unsigned entry =
                step_[s | ((x >> shift) & 7) << 6 | ((y >> shift) & 7) << 3 | ((z >> shift) & 7)];
            key = key << 9 | (entry & 511);
            s = entry & ~511u;
        }
        state = s >> 9;
        return key;
    }

  private:
    static constexpr unsigned states = 24;

    static constexpr unsigned rotate_left(unsigned b, unsigned by) noexcept {
        by %= 3;
        return ((b << by) | (b >> (3 - by))) & 7;
    }
    static constexpr unsigned gray(unsigned i) noexcept { return i ^ (i >> 1); }
    static constexpr unsigned trailing_ones(unsigned i) noexcept {
        unsigned n = 0;
        for (; i & 1; i >>= 1) ++n;
        return n;
    }
    // The position of an octant on the curve of a state: the cube is rotated so that the curve
    // enters at corner 0 and leaves along the last axis; then the inverse Gray code gives the
    // position.
    static constexpr unsigned position(unsigned state, unsigned octant) noexcept {
        const unsigned b = rotate_left(octant ^ (state / 3), 3 - (state % 3 + 1) % 3);
        return b ^ (b >> 1) ^ (b >> 2);
    }
    static constexpr unsigned child(unsigned state, unsigned digit) noexcept {
        const unsigned entry = digit == 0 ? 0 : gray((digit - 1) & ~1u);
        unsigned direction = 0;
        if (digit > 0) direction = trailing_ones(digit % 2 ? digit : digit - 1) % 3;
        const unsigned e = (state / 3) ^ rotate_left(entry, state % 3 + 1);
        const unsigned d = (state % 3 + direction + 1) % 3;
        return 3 * e + d;
    }

    // state << 9 | x << 6 | y << 3 | z, three bits each -> child's state << 9 | three digits.
    std::uint16_t step_[states << 9];
};

inline constexpr HilbertCurve hilbert_curve{};

}  // namespace mgdt
