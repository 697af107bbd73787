// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "mgdt/mgdt.h"

// All order schemes that the library knows, the default first.
inline const std::vector<std::int32_t> order_schemes = [] {
    std::vector<std::int32_t> all;
    std::int32_t number = 0;
    for (std::int32_t i = 0; mgdt_order_scheme_at(i, &number) == MGDT_OK; ++i)
        all.push_back(number);
    return all;
}();
