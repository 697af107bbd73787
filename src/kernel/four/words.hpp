// SPDX-License-Identifier: MIT
// Words moved four at a time: see kernel/words.hpp.
#pragma once

#include "kernel/four/write_vertices.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// For each selection of some of four words, the positions of the selected words.
constexpr FourPositions chosen_positions[16] = {
    {0, 0, 0, 0}, {0, 0, 0, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}, {2, 0, 0, 0}, {0, 2, 0, 0},
    {1, 2, 0, 0}, {0, 1, 2, 0}, {3, 0, 0, 0}, {0, 3, 0, 0}, {1, 3, 0, 0}, {0, 1, 3, 0},
    {2, 3, 0, 0}, {0, 2, 3, 0}, {1, 2, 3, 0}, {0, 1, 2, 3}};

MGDT_ALWAYS_INLINE unsigned append(std::uint32_t* to, const std::uint32_t* words,
                                   std::uint32_t bits) {
    FourWords::load(words).at(chosen_positions[bits]).store_anywhere(to);
    return number_of_four(bits);
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
