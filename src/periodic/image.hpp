// SPDX-License-Identifier: MIT
// Images of points of a periodic box, and their order.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "periodic/box_lattice.hpp"
#include "platform/hash.hpp"

namespace mgdt {

// The image of a point of the box: the point plus multiples of the lattice's basis.
struct Image {
    std::uint32_t point;
    std::int8_t of[4];  // three multiples and 0

    Multiples multiples() const { return {of[0], of[1], of[2]}; }
};

// The multiples are at most 127.
inline Image image_of(std::uint32_t point, const Multiples& k) {
    return {point,
            {static_cast<std::int8_t>(k[0]), static_cast<std::int8_t>(k[1]),
             static_cast<std::int8_t>(k[2]), 0}};
}

// A key that sorts images by point, and then by multiples.
inline std::uint64_t order_of(const Image& image) {
    const auto part = [&](unsigned c) {
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(image.of[c]) + 128);
    };
    return std::uint64_t{image.point} << 24 | part(0) << 16 | part(1) << 8 | part(2);
}
inline Image image_of_order(std::uint64_t order) {
    const auto multiple = [&](unsigned shift) {
        return static_cast<std::int32_t>(order >> shift & 0xFF) - 128;
    };
    return image_of(static_cast<std::uint32_t>(order >> 24),
                    {multiple(16), multiple(8), multiple(0)});
}
inline bool is_before(const Image& a, const Image& b) {
    return order_of(a) < order_of(b);
}
inline bool are_equal(const Image& a, const Image& b) {
    return a.point == b.point && std::equal(a.of, a.of + 3, b.of);
}
inline std::uint32_t hash_of(const Image& image) {
    std::uint32_t of;
    std::memcpy(&of, image.of, sizeof of);
    return hash_of_words(std::uint64_t{image.point} << 32 | of);
}

}  // namespace mgdt
