// SPDX-License-Identifier: MIT
#include "domain/rounding_grid.hpp"

#include <cmath>

namespace mgdt {

RoundingGrid::RoundingGrid(double largest) noexcept
    : exponent_(largest > 0 ? std::ilogb(largest) + 1 - bits : 0) {}

double RoundingGrid::round(double x) const noexcept {
    return std::nearbyint(scaled(x)) + 0.0;
}

double RoundingGrid::scaled(double x) const noexcept {
    return std::ldexp(x, -exponent_);
}

double RoundingGrid::unround(double x) const noexcept {
    return std::ldexp(x, exponent_);
}

}  // namespace mgdt
