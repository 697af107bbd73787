// SPDX-License-Identifier: MIT
#include "order/schemes.hpp"

namespace mgdt {

// Multi-grid as it is by default, whatever the parameters: what measures best (docs/paper.md).
void order_auto(Team& team, const PointSet& points, const OrderParameters& parameters,
                Schedule& out) {
    OrderParameters by_default;
    by_default.seed = parameters.seed;
    order_multi_grid(team, points, by_default, out);
}

}  // namespace mgdt
