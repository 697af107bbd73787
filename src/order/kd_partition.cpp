// SPDX-License-Identifier: MIT
#include "order/kd_partition.hpp"

#include <algorithm>

namespace mgdt {

Buffer<KdPoint> kd_points(Team& team, const PointSet& points, Allocator& allocator) {
    constexpr std::size_t min_items_per_thread = 65536;
    Buffer<KdPoint> copy(allocator, points.size);
    team.split(points.size, min_items_per_thread,
               [&](std::size_t begin, std::size_t end, unsigned) {
                   for (std::size_t i = begin; i < end; ++i) {
                       for (int k = 0; k < 3; ++k) copy[i].x[k] = points.coordinate(i, k);
                       copy[i].index = static_cast<std::uint32_t>(i);
                   }
               });
    return copy;
}

unsigned kd_levels(std::size_t n, double points_per_cell, bool round_down) noexcept {
    // The loop rounds log2(cells) down if `turn` is 2, and to nearest if `turn` is sqrt(2).
    const double turn = round_down ? 2 : 1.4142135623730951;
    double cells = static_cast<double>(n) / points_per_cell;
    unsigned levels = 0;
    for (; cells >= turn; cells /= 2) ++levels;
    return levels;
}

namespace kd_detail {
namespace {

int longest_side(const Box& region) noexcept {
    int longest = 0;
    double most = -1;
    for (int k = 0; k < 3; ++k) {
        const double half = region.high[k] * 0.5 - region.low[k] * 0.5;  // cannot overflow
        if (half > most) {
            most = half;
            longest = k;
        }
    }
    return longest;
}

void put_median(KdPoint* first, KdPoint* median, KdPoint* last, int axis) noexcept {
    // Ties are broken by index, so the halves do not depend on the implementation of nth_element.
    std::nth_element(first, median, last, [axis](const KdPoint& a, const KdPoint& b) {
        if (a.x[axis] != b.x[axis]) return a.x[axis] < b.x[axis];
        return a.index < b.index;
    });
}

}  // namespace

Halves cut(KdPoint* points, const Region& region) noexcept {
    // If the two halves cannot be equal, the formula of S.H. Lo (2014) gives the extra point to the
    // right half, but the worked example with 20 points (5-4-4-4, Figure 10) gives it to the left
    // half. This code follows the example.
    const std::size_t pivot = region.begin + (region.end - region.begin) / 2;
    const int axis = longest_side(region.box);
    put_median(points + region.begin, points + pivot, points + region.end, axis);
    Halves halves = {region, region};
    halves.left.end = pivot;
    halves.right.begin = pivot + 1;
    halves.left.box.high[axis] = halves.right.box.low[axis] = points[pivot].x[axis];
    return halves;
}

}  // namespace kd_detail
}  // namespace mgdt
