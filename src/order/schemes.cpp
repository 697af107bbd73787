// SPDX-License-Identifier: MIT
#include "order/schemes.hpp"

#include <iterator>

#include "mgdt/mgdt.h"

namespace mgdt {
namespace {

// The last five columns say whether the scheme depends on: points per cell, threshold, separation,
// round ratio, seed.
constexpr OrderScheme table[] = {
    {MGDT_ORDER_AUTO, "auto", order_auto, false, false, false, false, true},
    {MGDT_ORDER_INPUT, "input", order_input, false, false, false, false, false},
    {MGDT_ORDER_RANDOM, "random", order_random, false, false, false, false, true},
    {MGDT_ORDER_LEXICOGRAPHIC, "lexicographic", order_lexicographic, false, false, false, false,
     false},
    {MGDT_ORDER_BRIO, "brio", order_brio, false, false, false, true, true},
    {MGDT_ORDER_HILBERT, "hilbert", order_hilbert, false, false, false, false, false},
    {MGDT_ORDER_REGULAR_GRID, "regular-grid", order_regular_grid, true, false, true, true, true},
    {MGDT_ORDER_KD_TREE, "kd-tree", order_kd_tree, true, false, false, false, false},
    {MGDT_ORDER_ENHANCED_KD_TREE, "enhanced-kd-tree", order_enhanced_kd_tree, true, false, false,
     false, false},
    {MGDT_ORDER_MULTI_GRID, "multi-grid", order_multi_grid, true, true, true, true, true},
};

}  // namespace

OrderSchemes order_schemes() noexcept {
    return {std::begin(table), std::end(table)};
}

const OrderScheme* find_order_scheme(std::int32_t number) noexcept {
    for (const OrderScheme& scheme : table)
        if (scheme.number == number) return &scheme;
    return nullptr;
}

}  // namespace mgdt
