// SPDX-License-Identifier: MIT
// The order scheme along a Hilbert curve.
#include "order/curve_sort.hpp"
#include "order/schemes.hpp"

namespace mgdt {

void order_hilbert(Team& team, const PointSet& points, const OrderParameters&, Schedule& out) {
    const CurveOrder curve = sort_along_curve(team, points, out.scratch);
    constexpr std::size_t min_items_per_thread = 65536;
    team.split(points.size, min_items_per_thread,
               [&](std::size_t begin, std::size_t end, unsigned) {
                   for (std::size_t k = begin; k < end; ++k) out.order[k] = curve.index(k);
               });
    out.levels = curve.levels;
}

}  // namespace mgdt
