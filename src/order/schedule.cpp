// SPDX-License-Identifier: MIT
#include "order/schedule.hpp"

#include "mgdt/mgdt.h"
#include "order/schemes.hpp"

namespace mgdt {
namespace {

struct Entry {
    std::int32_t scheme;
    OrderScheme* fill;
};

constexpr Entry entries[] = {
    {MGDT_ORDER_AUTO, order_auto},
    {MGDT_ORDER_INPUT, order_input},
    {MGDT_ORDER_RANDOM, order_random},
    {MGDT_ORDER_LEXICOGRAPHIC, order_lexicographic},
    {MGDT_ORDER_BRIO, order_brio},
    {MGDT_ORDER_HILBERT, order_hilbert},
    {MGDT_ORDER_REGULAR_GRID, order_regular_grid},
    {MGDT_ORDER_KD_TREE, order_kd_tree},
    {MGDT_ORDER_ENHANCED_KD_TREE, order_enhanced_kd_tree},
    {MGDT_ORDER_MULTI_GRID, order_multi_grid},
};

// The C API refuses unknown schemes, so what is not in the table is never asked for.
OrderScheme* find(std::int32_t scheme) noexcept {
    for (const Entry& entry : entries) {
        if (entry.scheme == scheme) return entry.fill;
    }
    return entries[0].fill;
}

}  // namespace

void make_schedule(Team& team, const PointSet& points, std::int32_t scheme,
                   const OrderParameters& parameters, Schedule& out) {
    out.rounds.clear();
    out.hints.clear();
    out.levels = 0;
    out.order.resize(points.size);
    find(scheme)(team, points, parameters, out);
    if (out.rounds.empty()) out.rounds.push_back(0);
}

}  // namespace mgdt
