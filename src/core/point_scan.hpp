// SPDX-License-Identifier: MIT
// One pass over the caller's points before anything changes. It refuses coordinates that are not
// finite, and finds the bounding box and the range of exponents.
#pragma once

#include <cstddef>

#include "mesh/scale.hpp"
#include "order/schedule.hpp"

namespace mgdt {

// Throws MGDT_ERR_NOT_FINITE if the coordinate is not finite. The message names the axis and the
// point.
void require_finite(double x, std::size_t axis, long long point);

struct PointScan {
    // Scans n points. Throws MGDT_ERR_NOT_FINITE if a coordinate is not finite; `first_index` is
    // the number of the first point in the message.
    PointScan(Team& team, std::size_t n, const double* const axis[3], std::ptrdiff_t stride,
              long long first_index);

    // The median exponent of a sample of the nonzero coordinates; 0 if there are none.
    static int typical_exponent(std::size_t n, const double* const axis[3], std::ptrdiff_t stride);
    // The points, or a subset of them, in the form that schedules take, with this scale.
    PointSet point_set(std::size_t n, const double* const axis[3], std::ptrdiff_t stride,
                       double scale) const;

    double low[3], high[3];
    // The least and the greatest magnitude of a nonzero coordinate.
    double least, greatest = 0;
    ExponentRange exponents;
};

}  // namespace mgdt
