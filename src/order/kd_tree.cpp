// SPDX-License-Identifier: MIT
// The order scheme of a kd-tree.
#include <algorithm>

#include "order/kd_partition.hpp"
#include "order/schemes.hpp"

namespace mgdt {

// S.H. Lo (2014), section 3: about 10 points per cell, which are inserted in the order of the
// input.
void order_kd_tree(Team& team, const PointSet& points, const OrderParameters& parameters,
                   Schedule& out) {
    const double per_cell = parameters.points_per_cell_or(10);
    Buffer<KdPoint> sorted = kd_points(team, points, out.scratch);
    out.levels = kd_levels(points.size, per_cell, false);
    kd_partition(team, sorted, box_of(points), out.levels, [&] {
        return [&](std::size_t begin, std::size_t end) {
            std::sort(sorted.data() + begin, sorted.data() + end,
                      [](const KdPoint& a, const KdPoint& b) { return a.index < b.index; });
            // The pivot after the cell, if there is one, follows the points of the cell.
            end = std::min(end + 1, points.size);
            for (std::size_t k = begin; k < end; ++k) out.order[k] = sorted[k].index;
        };
    });
}

}  // namespace mgdt
