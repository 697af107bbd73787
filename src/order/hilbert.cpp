// SPDX-License-Identifier: MIT
#include "order/curve_sort.hpp"
#include "order/schemes.hpp"

namespace mgdt {

void order_hilbert(Team& team, const PointSet& points, const OrderParameters&, Schedule& out) {
    const CurveOrder curve = sort_along_curve(team, points, out.order.allocator());
    for (std::size_t k = 0; k < points.size; ++k) out.order[k] = curve.index(k);
    out.levels = curve.levels;
}

}  // namespace mgdt
