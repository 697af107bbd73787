// SPDX-License-Identifier: MIT
// What fills the hole of a vertex that is removed. The kernel finds it facet by facet, in time
// quadratic in the size of the link. A large link is triangulated by itself, and the tetrahedra
// inside the hole are taken from there; if memory lacks for that the removal fails, since the other
// way may take hours.
#pragma once

#include "core/state.hpp"

namespace mgdt {

// Finds the star and the link of vertex v. Throws std::bad_alloc.
void find_link(State& state, VertexId v);
// Whether the link that was found is triangulated by itself.
inline bool has_large_link(const State& state) noexcept {
    return state.vertex_removal.link_size() >= state.hooks.large_link;
}
// Finds what fills the hole of the vertex whose link was found. Returns the number of tetrahedra in
// the triangulation of the link, 0 if there was none. Throws Error and std::bad_alloc.
std::size_t fill_hole(State& state);

}  // namespace mgdt
