// SPDX-License-Identifier: MIT
#include "core/point_scan.hpp"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <mutex>

#include "platform/compiler.hpp"
#include "platform/error.hpp"

namespace mgdt {
namespace {

// Tests the bits: under -ffast-math a compiler may assume that isfinite() is true.
bool is_finite(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return (bits & 0x7FF0000000000000u) != 0x7FF0000000000000u;
}

constexpr double largest = 1.7976931348623157e308;

// Minima and maxima of a stream of coordinates in which every third belongs to the same axis.
// Several independent accumulators hide the latency of the operations.
struct Extremes {
    static constexpr std::size_t width = 6;
    double low[width], high[width];
    double least[width];   // the least nonzero magnitude
    double poison[width];  // NaN once a coordinate was not finite

    Extremes() {
        for (std::size_t j = 0; j < width; ++j) {
            low[j] = least[j] = largest;
            high[j] = -largest;
            poison[j] = 0;
        }
    }
    MGDT_ALWAYS_INLINE void add(const double* x) {
        for (std::size_t j = 0; j < width; ++j) {
            // With the operands in this order, each comparison compiles to one instruction.
            low[j] = low[j] < x[j] ? low[j] : x[j];
            high[j] = high[j] > x[j] ? high[j] : x[j];
            const double magnitude = std::fabs(x[j]);
            if (magnitude != 0) least[j] = least[j] < magnitude ? least[j] : magnitude;
            poison[j] += x[j] - x[j];
        }
    }
    void add(const Extremes& other) {
        for (std::size_t j = 0; j < width; ++j) {
            low[j] = std::min(low[j], other.low[j]);
            high[j] = std::max(high[j], other.high[j]);
            least[j] = std::min(least[j], other.least[j]);
            poison[j] += other.poison[j];
        }
    }
};

}  // namespace

void require_finite(double x, std::size_t axis, long long point) {
    if (!is_finite(x))
        fail(MGDT_ERR_NOT_FINITE, "coordinate %c of point %lld is %s", "xyz"[axis], point,
             x != x ? "NaN" : "infinite");
}

PointScan::PointScan(Team& team, std::size_t n, const double* const axis[3], std::ptrdiff_t stride,
                     long long first_index) {
    const auto coordinate = [&](std::size_t i, std::size_t k) {
        return axis[k][static_cast<std::ptrdiff_t>(i) * stride];
    };
    const bool is_packed = n > 0 && stride == 3 && axis[1] == axis[0] + 1 && axis[2] == axis[0] + 2;
    Extremes extremes;
    std::mutex mutex;
    team.split(n, 65536, [&](std::size_t begin, std::size_t end, unsigned) {
        // Two points per iteration.
        Extremes part;
        for (std::size_t i = begin; i < end; i += 2) {
            double x[Extremes::width];
            const double* source = x;
            if (is_packed && i + 1 < end)
                source = axis[0] + 3 * i;
            else
                for (std::size_t j = 0; j < Extremes::width; ++j)
                    x[j] = coordinate(i + 1 < end ? i + j / 3 : i, j % 3);
            part.add(source);
        }
        const std::lock_guard<std::mutex> lock(mutex);
        extremes.add(part);
    });
    double poison = 0;
    least = largest;
    for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(extremes.low[k], extremes.low[k + 3]);
        high[k] = std::max(extremes.high[k], extremes.high[k + 3]);
        greatest = std::max({greatest, std::fabs(low[k]), std::fabs(high[k])});
        least = std::min({least, extremes.least[k], extremes.least[k + 3]});
        poison += extremes.poison[k] + extremes.poison[k + 3];
    }
    if (!is_finite(poison)) {
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                require_finite(coordinate(i, k), k, first_index + static_cast<long long>(i));
    }
    if (n > 0 && greatest > 0) {
        exponents.add(greatest);
        exponents.add(least);
    }
}

int PointScan::typical_exponent(std::size_t n, const double* const axis[3], std::ptrdiff_t stride) {
    constexpr std::size_t sample = 85;
    int exponents[3 * sample];
    std::size_t size = 0;
    const std::size_t count = std::min(n, sample);
    for (std::size_t j = 0; j < count; ++j) {
        const auto i = static_cast<std::ptrdiff_t>(n / count * j + n % count * j / count);
        for (int k = 0; k < 3; ++k) {
            const double x = axis[k][i * stride];
            if (x != 0) exponents[size++] = std::ilogb(x);
        }
    }
    if (size == 0) return 0;
    std::nth_element(exponents, exponents + size / 2, exponents + size);
    return exponents[size / 2];
}

PointSet PointScan::point_set(std::size_t n, const double* const axis[3], std::ptrdiff_t stride,
                              double scale) const {
    PointSet points;
    points.size = n;
    points.stride = stride;
    points.scale = scale;
    for (int k = 0; k < 3; ++k) {
        points.axis[k] = axis[k];
        points.low[k] = low[k] * scale;
        points.high[k] = high[k] * scale;
    }
    return points;
}

}  // namespace mgdt
