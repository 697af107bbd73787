// SPDX-License-Identifier: MIT
// The order scheme that inserts points in the order in which the caller gives them.
#include "order/schemes.hpp"

namespace mgdt {

void order_input(Team&, const PointSet& points, const OrderParameters&, Schedule& out) {
    for (std::size_t i = 0; i < points.size; ++i) out.order[i] = static_cast<std::uint32_t>(i);
}

}  // namespace mgdt
