// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "mgdt/mgdt.h"

// All order schemes, the default first.
inline constexpr std::array<std::int32_t, 10> order_schemes = {
    MGDT_ORDER_AUTO,          MGDT_ORDER_INPUT,   MGDT_ORDER_RANDOM,
    MGDT_ORDER_LEXICOGRAPHIC, MGDT_ORDER_BRIO,    MGDT_ORDER_HILBERT,
    MGDT_ORDER_REGULAR_GRID,  MGDT_ORDER_KD_TREE, MGDT_ORDER_ENHANCED_KD_TREE,
    MGDT_ORDER_MULTI_GRID};
