// SPDX-License-Identifier: MIT
// Words moved four at a time: see kernel/words.hpp.
#pragma once

#include "kernel/avx2/write_vertices.hpp"
#include "kernel/avx512/vector.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

MGDT_ALWAYS_INLINE unsigned append(std::uint32_t* to, const std::uint32_t* words,
                                   std::uint32_t bits) {
    compressed(FourWords::load(words), bits).store_anywhere(to);
    return static_cast<unsigned>(__builtin_popcount(bits));
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
