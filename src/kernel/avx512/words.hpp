// SPDX-License-Identifier: MIT
// Words moved four at a time: see kernel/words.hpp.
#pragma once

#include "kernel/avx512/vector.hpp"
#include "kernel/four/write_vertices.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

MGDT_ALWAYS_INLINE unsigned append(std::uint32_t* to, const std::uint32_t* words,
                                   std::uint32_t bits) {
    compressed(FourWords::load(words), bits).store_anywhere(to);
    return number_of_four(bits);
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
