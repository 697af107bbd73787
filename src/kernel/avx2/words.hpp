// SPDX-License-Identifier: MIT
// Words moved four at a time: see kernel/words.hpp.
#pragma once

#include "kernel/avx2/write_vertices.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// For each choice among four words, the places of those chosen.
alignas(16) constexpr std::int32_t chosen_picks[16][4] = {
    {},  {0},    {1},    {0, 1},    {2},    {0, 2},    {1, 2},    {0, 1, 2},
    {3}, {0, 3}, {1, 3}, {0, 1, 3}, {2, 3}, {0, 2, 3}, {1, 2, 3}, {0, 1, 2, 3}};

MGDT_ALWAYS_INLINE unsigned append(std::uint32_t* to, const std::uint32_t* words,
                                   std::uint32_t bits) {
    FourWords::load(words).at(FourWords::load(chosen_picks[bits])).store_anywhere(to);
    return static_cast<unsigned>(__builtin_popcount(bits));
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
