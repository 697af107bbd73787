// SPDX-License-Identifier: MIT
#include "order/curve_sort.hpp"
#include "order/deal.hpp"
#include "order/schemes.hpp"

namespace mgdt {

// Along a Hilbert curve, in rounds of one point in sixteen.
void order_auto(Team& team, const PointSet& points, const OrderParameters& parameters,
                Schedule& out) {
    const CurveOrder curve = sort_along_curve(team, points, out.order.allocator());
    out.levels = curve.levels;
    deal_rounds(
        team, parameters.seed, [&](std::size_t k) { return curve.index(k); }, out);
}

}  // namespace mgdt
