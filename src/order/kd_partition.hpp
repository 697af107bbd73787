// SPDX-License-Identifier: MIT
// A squarish kd-tree, laid out in an array of its points.
#pragma once

#include <cstddef>
#include <cstdint>

#include "order/lattice.hpp"

namespace mgdt {

struct KdPoint {
    double x[3];  // scaled
    std::uint32_t index;
};

Buffer<KdPoint> kd_points(const PointSet& points, Allocator& allocator);

// Levels of a tree over n points: log2(n / points_per_cell), S.H. Lo (2014), section 3.2, rounded
// to the nearest integer, or down where cells are to hold points_per_cell at the least.
unsigned kd_levels(std::size_t n, double points_per_cell, bool round_down) noexcept;

// Divides points[begin..end) in place: each region is cut across the longest side of its box at
// the median point, its pivot, which ends up between the two halves. So from left to right the
// array is the sandwich of section 3.3: cell, pivot, cell, pivot, ..., cell. Calls
// leaf(begin, end) for each of the 2^levels cells from left to right, empty ones too. The order of
// points in a cell when leaf is called depends on the C++ library, and leaf must settle it.
template <class Leaf>
void kd_partition(KdPoint* points, std::size_t begin, std::size_t end, const Box& region,
                  unsigned levels, const Leaf& leaf);

namespace kd_detail {
int longest_side(const Box& region) noexcept;
void place_median(KdPoint* first, KdPoint* median, KdPoint* last, int axis) noexcept;
}  // namespace kd_detail

template <class Leaf>
void kd_partition(KdPoint* points, std::size_t begin, std::size_t end, const Box& region,
                  unsigned levels, const Leaf& leaf) {
    const std::size_t n = end - begin;
    if (levels == 0 || n == 0) {
        leaf(begin, end);
        return;
    }
    // The paper's formula gives an even number's odd half to the right, its worked example of 20
    // points (5-4-4-4, Figure 10) to the left. This follows the example.
    const std::size_t pivot = begin + n / 2;
    const int axis = kd_detail::longest_side(region);
    kd_detail::place_median(points + begin, points + pivot, points + end, axis);
    Box half = region;
    half.high[axis] = points[pivot].x[axis];
    kd_partition(points, begin, pivot, half, levels - 1, leaf);
    half = region;
    half.low[axis] = points[pivot].x[axis];
    kd_partition(points, pivot + 1, end, half, levels - 1, leaf);
}

}  // namespace mgdt
