// SPDX-License-Identifier: MIT
// One pass over the caller's points before anything changes: refuses what is not finite and
// takes their bounding box and range of exponents.
#pragma once

#include <cstddef>

#include "mesh/scale.hpp"
#include "order/schedule.hpp"

namespace mgdt {

// Throws MGDT_ERR_NOT_FINITE for a coordinate of the point that the message is to name.
void require_finite(double x, std::size_t axis, long long point);

struct PointScan {
    // Throws MGDT_ERR_NOT_FINITE; `first_index` numbers the first point in the message.
    PointScan(Team& team, std::size_t n, const double* const axis[3], std::ptrdiff_t stride,
              long long first_index);

    // The median exponent of a sample of the coordinates that are not 0; 0 where there are none.
    static int typical_exponent(std::size_t n, const double* const axis[3], std::ptrdiff_t stride);
    // Those points, or some of them, for a schedule, multiplied by `scale`.
    PointSet point_set(std::size_t n, const double* const axis[3], std::ptrdiff_t stride,
                       double scale) const;

    double low[3], high[3];
    // Magnitudes, of coordinates that are not 0.
    double least, greatest = 0;
    ExponentRange exponents;
};

}  // namespace mgdt
