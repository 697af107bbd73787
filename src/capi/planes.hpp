// SPDX-License-Identifier: MIT
// The planes of a region, as the C interface receives them.
#pragma once

#include "capi/guard.hpp"

namespace mgdt {

inline std::size_t require_planes(std::int64_t n, const double* planes) {
    constexpr std::int64_t most = 1 << 30;
    const std::size_t count = require_count(n, "planes");
    if (n > most)
        fail(MGDT_ERR_TOO_LARGE, "%lld planes are more than %lld", static_cast<long long>(n),
             static_cast<long long>(most));
    if (n > 0) require_pointer(planes, "the array of planes");
    return count;
}

}  // namespace mgdt
