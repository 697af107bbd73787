// SPDX-License-Identifier: MIT
// The counts of the C interface, for calls that are inside the handle.
#pragma once

#include <cstdint>

#include "core/triangulation.hpp"

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
    // Euler: V - E + F - T = 1 for a ball, with 2 F = 4 T + H.
    if (tetrahedron_count(t) == 0) return 0;
    return vertex_count(t) + tetrahedron_count(t) + hull_facet_count(t) / 2 - 1;
}

}  // namespace mgdt
