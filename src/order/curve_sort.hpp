// SPDX-License-Identifier: MIT
// Sorts points along a Hilbert curve whose resolution adapts to the density of the points.
#pragma once

#include "order/schedule.hpp"

namespace mgdt {

// The points of a set in the order of the curve. The low bits of word k are the index of the k-th
// point.
struct CurveOrder {
    Buffer<std::uint64_t> words;
    unsigned index_bits;
    unsigned levels;  // the depth of nested curves; 1 if no cell is crowded

    std::uint64_t index_mask() const noexcept { return (std::uint64_t{1} << index_bits) - 1; }
    std::uint32_t index(std::size_t k) const noexcept {
        return static_cast<std::uint32_t>(words[k] & index_mask());
    }
    // A rough measure of the distance along the curve between the i-th and the k-th point: about
    // log8 of the difference of their keys, so 1 more for each coarser level of cells. The value
    // means nothing if a nested curve begins or ends between the two points.
    unsigned levels_apart(std::size_t i, std::size_t k) const noexcept {
        const std::uint64_t a = words[i] >> index_bits, b = words[k] >> index_bits;
        return bit_width(a < b ? b - a : a - b) / 3;
    }
};

// Sorts the points along the curve. In a cell of the finest level, up to `crowd` points keep their
// order; more points are sorted by a nested curve.
CurveOrder sort_along_curve(Team& team, const PointSet& points, Allocator& allocator,
                            std::size_t crowd = 8);

}  // namespace mgdt
