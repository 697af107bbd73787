// SPDX-License-Identifier: MIT
#include "solid/divided_segment.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "solid/rounding_grid.hpp"

namespace mgdt {

DividedSegment::DividedSegment(const double* a, const double* b) noexcept {
    // The number of binary digits behind the point that coordinate i may have: that of a double of
    // the magnitude of the larger end.
    int digits[3], zeros[3];
    for (int i = 0; i < 3; ++i) {
        origin_[i] = static_cast<std::int64_t>(a[i]);
        step_[i] = static_cast<std::int64_t>(b[i]) - origin_[i];
        const double largest = std::max(std::fabs(a[i]), std::fabs(b[i]));
        constexpr int significant_bits = 53;
        digits[i] = RoundingGrid::digits;
        if (largest > 0)
            digits[i] = std::min(digits[i], significant_bits - 1 - std::ilogb(largest));
        zeros[i] = 0;
        if (step_[i] == 0) continue;
        while ((step_[i] >> zeros[i] & 1) == 0) ++zeros[i];
        room_ = std::min(room_, digits[i] + zeros[i]);
    }
    assert(room_ > 0 && "the ends are not on the grid");
    for (int i = 0; i < 3; ++i) {
        shift_[i] = step_[i] == 0 ? 0 : std::max(0, room_ - zeros[i]);
        // Multiplications are used because shifts of negative numbers are undefined in C++17.
        origin_[i] *= std::int64_t{1} << shift_[i];
        step_[i] = step_[i] / (std::int64_t{1} << (room_ - shift_[i]));
    }
}

void DividedSegment::point(std::uint32_t k, double* x) const noexcept {
    for (int i = 0; i < 3; ++i)
        x[i] = std::ldexp(static_cast<double>(origin_[i] + k * step_[i]), -shift_[i]);
}

}  // namespace mgdt
