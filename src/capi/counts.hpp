// SPDX-License-Identifier: MIT
// The counts of the C interface, for calls that have entered the handle.
#pragma once

#include <algorithm>
#include <cstdint>

#include "capi/triangulation_handle.hpp"

namespace mgdt {

inline std::int64_t point_count(const Triangulation& t) {
    return static_cast<std::int64_t>(t.point_map().size());
}
inline std::int64_t vertex_count(const Triangulation& t) {
    return static_cast<std::int64_t>(t.vertex_count());
}
inline std::int64_t tetrahedron_count(const Triangulation& t) {
    return static_cast<std::int64_t>(t.mesh().finite_count());
}
inline std::int64_t hull_facet_count(const Triangulation& t) {
    return static_cast<std::int64_t>(t.mesh().ghost_count);
}
inline std::int64_t edge_count(const Triangulation& t) {
    // Euler's formula: V - E + F - T = 1 for a ball, and 2 F = 4 T + H.
    if (tetrahedron_count(t) == 0) return 0;
    return vertex_count(t) + tetrahedron_count(t) + hull_facet_count(t) / 2 - 1;
}

// Checks the array of an export whose number of rows is known in advance, and calls write(base) to
// fill it.
template <class Int, class Write>
void give_rows(const mgdt_triangulation* t, std::size_t width, std::size_t rows, int64_t capacity,
               Int* v, Int* count, Write write) {
    const auto points = static_cast<std::uint64_t>(point_count(t->object));
    require_range<Int>(std::max<std::uint64_t>(points, rows + 1), t);
    *count = static_cast<Int>(rows);
    if (rows > 0) require_pointer(v, "the output array");
    require_capacity(capacity, width * rows, "the output array");
    write(static_cast<Int>(t->object.settings().index_base));
}

}  // namespace mgdt
