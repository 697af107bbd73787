// SPDX-License-Identifier: MIT
#include "order/schedule.hpp"

#include "order/schemes.hpp"

namespace mgdt {

void make_schedule(Team& team, const PointSet& points, std::int32_t scheme,
                   const OrderParameters& parameters, Schedule& out) {
    out.rounds.clear();
    out.hints.clear();
    out.levels = 0;
    out.order.resize(points.size);
    // The scheme exists, since the C interface refuses unknown numbers.
    find_order_scheme(scheme)->fill(team, points, parameters, out);
    if (out.rounds.empty()) out.rounds.push_back(0);
}

}  // namespace mgdt
