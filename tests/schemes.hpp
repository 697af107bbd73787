// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "mgdt/mgdt.h"

// All order schemes that the library knows, the default first.
inline const std::vector<std::int32_t> order_schemes = [] {
    std::vector<std::int32_t> all;
    for (std::int32_t number = 0; number < 1000; ++number)
        if (mgdt_order_scheme_name(number)) all.push_back(number);
    return all;
}();
