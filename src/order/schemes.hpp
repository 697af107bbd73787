// SPDX-License-Identifier: MIT
// The order schemes. Each is a function in a file of its own, and one table lists them all. The C
// interface takes numbers and names from the table, and the program and the tests ask the C
// interface.
#pragma once

#include "order/schedule.hpp"

namespace mgdt {

// Fills a schedule, whose `order` has one element per point and whose other fields are empty. If a
// scheme leaves `rounds` empty, there is a single round.
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
    // The parameters that the scheme depends on.
    bool takes_points_per_cell, takes_threshold, takes_separation, takes_round_ratio, takes_seed;
};

// All schemes, by ascending number, which is the order in which they are listed. The default comes
// first.
struct OrderSchemes {
    const OrderScheme *first, *last;
    const OrderScheme* begin() const noexcept { return first; }
    const OrderScheme* end() const noexcept { return last; }
};
OrderSchemes order_schemes() noexcept;

// The scheme with this number, or null.
const OrderScheme* find_order_scheme(std::int32_t number) noexcept;

}  // namespace mgdt
