// SPDX-License-Identifier: MIT
// The default order scheme.
#include "order/schemes.hpp"

namespace mgdt {

// The multi-grid scheme with its default parameters; only the seed is taken from `parameters`. This
// scheme performs best in measurements (docs/paper.md).
void order_auto(Team& team, const PointSet& points, const OrderParameters& parameters,
                Schedule& out) {
    OrderParameters by_default;
    by_default.seed = parameters.seed;
    order_multi_grid(team, points, by_default, out);
}

}  // namespace mgdt
