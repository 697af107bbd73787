// SPDX-License-Identifier: MIT
// The range of coordinates in which the filters are proved, since nothing in them overflows or
// loses digits by underflow. See docs/theory.md.
#pragma once

#include <cmath>

#include "platform/compiler.hpp"

namespace mgdt {

MGDT_ALWAYS_INLINE bool in_normal_range(double x) {
    const double magnitude = std::fabs(x);
    return magnitude == 0 || (magnitude >= 0x1p-150 && magnitude <= 0x1p150);
}
MGDT_ALWAYS_INLINE bool in_normal_range(const double* x) {
    return in_normal_range(x[0]) && in_normal_range(x[1]) && in_normal_range(x[2]);
}

}  // namespace mgdt
