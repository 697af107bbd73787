// SPDX-License-Identifier: MIT
// Lists that a caller passes: points, and what has points as corners, with markers.
#pragma once

#include <algorithm>

#include "capi/guard.hpp"
#include "core/point_scan.hpp"
#include "platform/memory.hpp"

namespace mgdt {

// Indices have 32 bits, and the greatest is no index.
constexpr std::size_t most_items = 0x7FFFFFFF;

// Checks a number of items, each of which has `each` elements.
inline std::size_t require_items(std::int64_t n, std::size_t each, const char* of) {
    const std::size_t count = require_count(n, of);
    if (count > most_items / each)
        fail(MGDT_ERR_TOO_LARGE, "%zu %s are more than can be numbered", count, of);
    return count;
}

// The coordinates of n points, which are finite.
inline Buffer<double> copy_of_points(Allocator& allocator, std::int64_t n, const double* xyz,
                                     std::int32_t base) {
    const std::size_t count = require_items(n, 3, "points");
    if (count > 0) require_pointer(xyz, "xyz");
    for (std::size_t i = 0; i < 3 * count; ++i)
        require_finite(xyz[i], i % 3, static_cast<long long>(i / 3) + base);
    Buffer<double> points(allocator);
    points.resize(3 * count);
    std::copy_n(xyz, 3 * count, points.begin());
    return points;
}

// The points that items may have as corners, and the index of the first one.
struct CornerRange {
    std::size_t points;
    std::int32_t base;

    // The point with an index of the caller's, a corner of `what` number i.
    std::uint32_t at(std::int64_t index, const char* what, std::size_t i,
                     const char* verb = "has the corner") const {
        if (index < base || static_cast<std::uint64_t>(index - base) >= points)
            fail(MGDT_ERR_INVALID_ARGUMENT, "%s %lld %s %lld; there are %zu points", what,
                 static_cast<long long>(i) + base, verb, static_cast<long long>(index), points);
        return static_cast<std::uint32_t>(index - base);
    }
};

// The corners of n items, `each` of every one.
template <class Int>
Buffer<std::uint32_t> copy_of_corners(Allocator& allocator, std::size_t n, std::size_t each,
                                      const Int* corners, const CornerRange& range,
                                      const char* what) {
    Buffer<std::uint32_t> copy(allocator);
    copy.resize(each * n);
    for (std::size_t i = 0; i < copy.size(); ++i)
        copy[i] = range.at(corners[i], what, i / each, each == 1 ? "is" : "has the corner");
    return copy;
}

// The markers of n items, which are 0 if the caller passes none.
inline Buffer<std::int32_t> copy_of_markers(Allocator& allocator, std::size_t n,
                                            const std::int32_t* markers) {
    Buffer<std::int32_t> copy(allocator);
    copy.resize(n, 0);
    if (markers) std::copy_n(markers, n, copy.begin());
    return copy;
}

}  // namespace mgdt
