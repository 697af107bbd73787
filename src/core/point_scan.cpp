// SPDX-License-Identifier: MIT
#include "core/point_scan.hpp"

#include <cstdint>
#include <cstring>

#include "platform/error.hpp"

namespace mgdt {
namespace {

// On the bits, so that no compiler flag of a caller's build can reason it away.
bool is_finite(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return (bits & 0x7FF0000000000000u) != 0x7FF0000000000000u;
}

double magnitude_or(double x, double if_zero) {
    const double magnitude = std::fabs(x);
    return magnitude == 0 ? if_zero : magnitude;
}

}  // namespace

PointScan::PointScan(std::size_t n, const double* const axis[3], std::ptrdiff_t stride,
                     long long first_index) {
    constexpr double largest = 1.7976931348623157e308;
    double least = largest, greatest = 0;
    for (int k = 0; k < 3; ++k) {
        double lo = largest, hi = -largest;
        const double* p = axis[k];
        for (std::size_t i = 0; i < n; ++i) {
            const double x = p[static_cast<std::ptrdiff_t>(i) * stride];
            if (!is_finite(x))
                fail(MGDT_ERR_NOT_FINITE, "coordinate %c of point %lld is %s", "xyz"[k],
                     first_index + static_cast<long long>(i), x != x ? "NaN" : "infinite");
            lo = x < lo ? x : lo;
            hi = x > hi ? x : hi;
            const double small = magnitude_or(x, largest);
            least = small < least ? small : least;
        }
        low[k] = lo;
        high[k] = hi;
        greatest = std::fmax(greatest, std::fmax(std::fabs(lo), std::fabs(hi)));
    }
    if (greatest > 0) {
        exponents.add(greatest);
        exponents.add(least);
    }
}

}  // namespace mgdt
