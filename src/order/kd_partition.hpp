// SPDX-License-Identifier: MIT
// A squarish kd-tree, stored as an array of its points.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>

#include "order/cell_numbers.hpp"
#include "parallel/team.hpp"
#include "platform/atomic.hpp"

namespace mgdt {

struct KdPoint {
    double x[3];  // scaled
    std::uint32_t index;
};

Buffer<KdPoint> kd_points(Team& team, const PointSet& points, Allocator& allocator);

// The number of levels of a tree over n points: log2(n / points_per_cell), S.H. Lo (2014), section
// 3.2. The result is rounded down if `round_down`, so that cells have about points_per_cell points
// or more, and otherwise rounded to the nearest integer.
unsigned kd_levels(std::size_t n, double points_per_cell, bool round_down) noexcept;

// Divides points in place: each region is cut across the longest side of its box at the median
// point, the pivot, which is then between the two halves. So the array becomes the sandwich of
// section 3.3: cell, pivot, cell, pivot, ..., cell. Each thread makes a function leaf =
// make_leaf(). leaf(begin, end) is called for each cell, including empty cells, in any order. The
// order of points within a cell depends on the C++ library, so leaf() has to sort them.
template <class MakeLeaf>
void kd_partition(Team& team, Buffer<KdPoint>& points, const Box& box, unsigned levels,
                  const MakeLeaf& make_leaf);

namespace kd_detail {

struct Region {
    std::size_t begin, end;
    Box box;
};

struct Halves {
    Region left, right;
};
// Cuts a region that is not empty. Returns the parts on both sides of the pivot.
Halves cut(KdPoint* points, const Region& region) noexcept;

template <class Leaf>
void partition(KdPoint* points, const Region& region, unsigned levels, Leaf& leaf) {
    if (levels == 0 || region.begin == region.end) {
        leaf(region.begin, region.end);
        return;
    }
    const Halves halves = cut(points, region);
    partition(points, halves.left, levels - 1, leaf);
    partition(points, halves.right, levels - 1, leaf);
}

}  // namespace kd_detail

template <class MakeLeaf>
void kd_partition(Team& team, Buffer<KdPoint>& points, const Box& box, unsigned levels,
                  const MakeLeaf& make_leaf) {
    using kd_detail::Region;
    constexpr std::size_t min_items_per_thread = 32768;
    const unsigned members = team.members_for(points.size(), min_items_per_thread);
    // The team divides the first levels, until there are several regions per thread. Then each
    // thread divides regions alone.
    Buffer<Region> regions(points.allocator(), 1), next(points.allocator());
    regions[0] = {0, points.size(), box};
    for (; levels > 0 && members > 1 && regions.size() < std::size_t{4} * members; --levels) {
        next.resize(2 * regions.size());
        team.split(regions.size(), 1, [&](std::size_t begin, std::size_t end, unsigned) {
            for (std::size_t r = begin; r < end; ++r) {
                const kd_detail::Halves halves = kd_detail::cut(points.data(), regions[r]);
                next[2 * r] = halves.left;
                next[2 * r + 1] = halves.right;
            }
        });
        std::swap(regions, next);
    }
    Atomic<std::size_t> taken{0};
    team.run(members, [&](unsigned) {
        auto leaf = make_leaf();
        for (std::size_t r; (r = taken++) < regions.size();)
            kd_detail::partition(points.data(), regions[r], levels, leaf);
    });
}

}  // namespace mgdt
