// SPDX-License-Identifier: MIT
// The order schemes, one file each. They get a schedule whose order has room for every point and
// whose other fields are empty; a scheme that leaves rounds empty has a single one.
#pragma once

#include "order/schedule.hpp"

namespace mgdt {

using OrderScheme = void(Team& team, const PointSet& points, const OrderParameters& parameters,
                         Schedule& out);

OrderScheme order_auto;
OrderScheme order_input;
OrderScheme order_random;
OrderScheme order_lexicographic;
OrderScheme order_brio;
OrderScheme order_hilbert;
OrderScheme order_regular_grid;
OrderScheme order_kd_tree;
OrderScheme order_enhanced_kd_tree;
OrderScheme order_multi_grid;

}  // namespace mgdt
