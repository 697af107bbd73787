// SPDX-License-Identifier: MIT
// The records of a star while it is built, and the coordinates of its vertices.
#pragma once

#include <cassert>

#include "kernel/workspace.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

using SphereStore = TetrahedronView<TetrahedronAndSphere>;

// Stores the coordinates of the cavity's vertices relative to q, by local number.
inline void set_coordinates(Workspace& w, const Vertex* vertices, VertexId q, std::uint32_t count) {
    assert(count <= w.ids.buffer.capacity() && "more vertices than there is room for");
    const double* const base = vertices[q].x;
    for (std::uint32_t i = 0; i < count; ++i) {
        const double* const x = vertices[w.ids.data[i]].x;
        w.x.data[i] = x[0] - base[0];
        w.y.data[i] = x[1] - base[1];
        w.z.data[i] = x[2] - base[2];
    }
}

// Calls link(i, t) for the new tetrahedron t of each facet i. NoLinks is a `link` that does
// nothing.
template <class Tetrahedra, class Link>
MGDT_ALWAYS_INLINE void link_each(const Tetrahedra tetrahedra, const Workspace& w, Link link) {
    for (std::size_t i = 0; i < w.boundary_size; ++i) link(i, tetrahedra.of_first(w.slots.data[i]));
}
struct NoLinks {
    MGDT_ALWAYS_INLINE void operator()(std::size_t, Tetrahedron&) const {}
};

}  // namespace MGDT_ISLAND
}  // namespace mgdt
