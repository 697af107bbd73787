// SPDX-License-Identifier: MIT
// The order schemes: a function each, in a file of its own, and the one table that lists them. From
// the table the C interface takes numbers and names, and the program and the tests take theirs.
#pragma once

#include "order/schedule.hpp"

namespace mgdt {

// Fills a schedule. Its order has room for every point and its other fields are empty; a scheme
// that leaves the rounds empty has a single one.
using FillSchedule = void(Team& team, const PointSet& points, const OrderParameters& parameters,
                          Schedule& out);

FillSchedule order_auto;
FillSchedule order_input;
FillSchedule order_random;
FillSchedule order_lexicographic;
FillSchedule order_brio;
FillSchedule order_hilbert;
FillSchedule order_regular_grid;
FillSchedule order_kd_tree;
FillSchedule order_enhanced_kd_tree;
FillSchedule order_multi_grid;

struct OrderScheme {
    std::int32_t number;  // an MGDT_ORDER_ value
    const char* name;
    FillSchedule* fill;
    // Which of the OrderParameters change what it does.
    bool takes_points_per_cell, takes_threshold, takes_separation, takes_round_ratio, takes_seed;
};

// In the order in which they are best listed: ascending by number, the default first.
struct OrderSchemes {
    const OrderScheme *first, *last;
    const OrderScheme* begin() const noexcept { return first; }
    const OrderScheme* end() const noexcept { return last; }
};
OrderSchemes order_schemes() noexcept;

// The scheme of this number, or null.
const OrderScheme* find_order_scheme(std::int32_t number) noexcept;

}  // namespace mgdt
