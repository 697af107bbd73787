// SPDX-License-Identifier: MIT
// Hashes of a few words, for NumberTable.
#pragma once

#include <cstdint>
#include <cstring>

namespace mgdt {

// Adds a word to a hash of 64 bits.
constexpr std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) noexcept {
    hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
    return hash ^ hash >> 29;
}

// A hash of integers in their order.
template <class... Word>
constexpr std::uint32_t hash_of_words(Word... words) noexcept {
    std::uint64_t h = 0;
    ((h = mixed(h, static_cast<std::uint64_t>(words))), ...);
    return static_cast<std::uint32_t>(h ^ h >> 32);
}

// A hash of three coordinates. The coordinates 0 and -0 have the same hash.
inline std::uint32_t hash_of_coordinates(const double* x) noexcept {
    std::uint64_t bits[3];
    for (int k = 0; k < 3; ++k) {
        const double one_zero = x[k] + 0.0;
        std::memcpy(&bits[k], &one_zero, sizeof bits[k]);
    }
    return hash_of_words(bits[0], bits[1], bits[2]);
}

}  // namespace mgdt
