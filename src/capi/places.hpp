// SPDX-License-Identifier: MIT
// Checks of the points of a query.
#pragma once

#include <cstdint>

#include "capi/triangulation_handle.hpp"
#include "core/point_scan.hpp"
#include "query/locate.hpp"

namespace mgdt {

inline Locator locator(const mgdt_triangulation* t) {
    return {t->object.mesh(), t->object.calls(), t->object.location_tree()};
}

inline std::size_t require_places(std::int64_t n) {
    if (n > PTRDIFF_MAX / static_cast<std::ptrdiff_t>(4 * sizeof(double)))
        fail(MGDT_ERR_INVALID_ARGUMENT, "%lld points are more than memory can hold",
             static_cast<long long>(n));
    return require_count(n);
}

// Checks the number of fields of `rows` numbers each.
inline std::size_t require_fields(std::int64_t fields, std::size_t rows) {
    const std::size_t count = require_count(fields, "fields");
    if (count != 0 && rows > PTRDIFF_MAX / (3 * sizeof(double)) / count)
        fail(MGDT_ERR_TOO_LARGE, "%lld fields of %zu points are more than memory can hold",
             static_cast<long long>(fields), rows);
    return count;
}

// The places of a query. Throws if a coordinate is not finite.
inline PointSet finite_places(Team& team, std::size_t n, const double* xyz,
                              std::int32_t index_base) {
    const double* const axis[3] = {xyz, xyz + 1, xyz + 2};
    return PointScan(team, n, axis, 3, index_base).point_set(n, axis, 3, 1);
}

}  // namespace mgdt
