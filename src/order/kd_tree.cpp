// SPDX-License-Identifier: MIT
#include <algorithm>

#include "order/kd_partition.hpp"
#include "order/schemes.hpp"

namespace mgdt {

// S.H. Lo (2014), section 3: about 10 points a cell, which go in in the order of the input.
void order_kd_tree(Team&, const PointSet& points, const OrderParameters& parameters,
                   Schedule& out) {
    const double per_cell = parameters.points_per_cell_or(10);
    Buffer<KdPoint> sorted = kd_points(points, out.order.allocator());
    out.levels = kd_levels(points.size, per_cell, false);
    const auto by_index = [&](std::size_t begin, std::size_t end) {
        std::sort(sorted.data() + begin, sorted.data() + end,
                  [](const KdPoint& a, const KdPoint& b) { return a.index < b.index; });
    };
    kd_partition(sorted.data(), 0, points.size, box_of(points), out.levels, by_index);
    for (std::size_t k = 0; k < points.size; ++k) out.order[k] = sorted[k].index;
}

}  // namespace mgdt
