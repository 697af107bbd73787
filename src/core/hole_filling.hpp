// SPDX-License-Identifier: MIT
// Finds the tetrahedra that fill the hole of a removed vertex. Filling the hole facet by facet
// takes time quadratic in the size of the link. A large link is therefore triangulated by itself,
// and the tetrahedra inside the hole are taken from that triangulation. If memory does not suffice,
// the removal fails, since filling facet by facet may take hours.
#pragma once

#include "core/state.hpp"

namespace mgdt {

// Finds the star and the link of vertex v. Throws std::bad_alloc.
void find_link(State& state, VertexId v);
// Whether the link that was found is triangulated by itself.
inline bool has_large_link(const State& state) noexcept {
    return state.vertex_removal.link_size() >= state.hooks.large_link;
}
// Finds the tetrahedra that fill the hole of the vertex whose link was found. Returns the number of
// tetrahedra in the triangulation of the link, or 0 if the hole was filled facet by facet. Throws
// Error and std::bad_alloc.
std::size_t fill_hole(State& state);

}  // namespace mgdt
