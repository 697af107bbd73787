// SPDX-License-Identifier: MIT
// Sorts points along a Hilbert curve that is as fine as the points are close.
#pragma once

#include "order/schedule.hpp"

namespace mgdt {

// The points of a set along the curve. Word k holds the index of the k-th one in its low bits.
struct CurveOrder {
    Buffer<std::uint64_t> words;
    unsigned index_bits;
    unsigned levels;  // how deep curves lie within cells of curves, 1 if no cell is crowded

    std::uint64_t index_mask() const noexcept { return (std::uint64_t{1} << index_bits) - 1; }
    std::uint32_t index(std::size_t k) const noexcept {
        return static_cast<std::uint32_t>(words[k] & index_mask());
    }
    // How far the i-th point is from the k-th along the curve, roughly: levels of the smallest of
    // its cells that is as long. Any number where a curve inside a cell begins or ends between.
    unsigned levels_apart(std::size_t i, std::size_t k) const noexcept {
        const std::uint64_t a = words[i] >> index_bits, b = words[k] >> index_bits;
        return bit_width(a < b ? b - a : a - b) / 3;
    }
};

// Up to `crowd` points in a finest cell stay as they are.
CurveOrder sort_along_curve(Team& team, const PointSet& points, Allocator& allocator,
                            std::size_t crowd = 8);

}  // namespace mgdt
