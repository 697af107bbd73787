// SPDX-License-Identifier: MIT
#include "solid/rounding_grid.hpp"

#include <algorithm>
#include <cmath>

namespace mgdt {
namespace {

double largest_magnitude(const Buffer<double>& coordinates) noexcept {
    double largest = 0;
    for (const double x : coordinates) largest = std::max(largest, std::fabs(x));
    return largest;
}

}  // namespace

RoundingGrid::RoundingGrid(const Buffer<double>& coordinates, int bits) noexcept
    : RoundingGrid(largest_magnitude(coordinates), bits) {}

// Multiples of the step are at least the least double, 2^-1074.
RoundingGrid::RoundingGrid(double largest, int bits) noexcept
    : bits_(bits),
      exponent_(largest > 0 && bits != no_rounding
                    ? std::max(std::ilogb(largest) + 1 - bits, -1074 + digits)
                    : 0) {}

double RoundingGrid::round(double x) const noexcept {
    if (bits_ == no_rounding) return x + 0.0;
    // The largest multiple is below 2^bits, because 2^bits steps may be 2^1024, which is no double.
    const double most = std::ldexp(1, bits_) - 1;
    const double rounded = std::nearbyint(scaled(x));
    return std::min(std::max(rounded, -most), most) + 0.0;
}

double RoundingGrid::scaled(double x) const noexcept {
    return std::ldexp(x, -exponent_);
}

bool RoundingGrid::scale_place(const double (&x)[3], double (&result)[3]) const noexcept {
    const double far = bits_ == no_rounding ? HUGE_VAL : std::ldexp(1, bits_ + 4);
    bool is_near = true;
    for (int k = 0; k < 3; ++k) {
        result[k] = scaled(x[k]);
        is_near = is_near && std::fabs(result[k]) < far;
    }
    return is_near;
}

double RoundingGrid::unround(double x) const noexcept {
    return std::ldexp(x, exponent_);
}

}  // namespace mgdt
