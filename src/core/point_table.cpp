// SPDX-License-Identifier: MIT
#include "core/point_table.hpp"

#include <algorithm>

#include "platform/error.hpp"

namespace mgdt {

void PointTable::clear() noexcept {
    map.clear();
    equals.forget();
    held.clear();
    basis.clear();
    exponents = ExponentRange();
    exponents_are_wide = false;
}

void PointTable::require_in(const Buffer<std::uint32_t>& points, const char* what,
                            std::int32_t index_base) const {
    const auto named = [&](std::uint32_t i) { return static_cast<long long>(i) + index_base; };
    Buffer<std::uint32_t> sorted(map.allocator());
    sorted.reserve(points.size());
    for (const std::uint32_t i : points) {
        if (i >= map.size())
            fail(MGDT_ERR_INVALID_ARGUMENT,
                 "there is no point %lld: %zu were given, counted from %d", named(i), map.size(),
                 static_cast<int>(index_base));
        if (map[i] == infinite_vertex)
            fail(MGDT_ERR_INVALID_ARGUMENT, "point %lld is not in the triangulation", named(i));
        sorted.push_back(i);
    }
    std::sort(sorted.begin(), sorted.end());
    const std::uint32_t* const twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end())
        fail(MGDT_ERR_INVALID_ARGUMENT, "point %lld is to be %s twice", named(*twice), what);
}

}  // namespace mgdt
