// SPDX-License-Identifier: MIT
// Keeps the numbers of vertices consecutive: at the end of a call the last vertices move into the
// gaps. Also restores the order of the vertices in records that several threads need.
#pragma once

#include "core/state.hpp"
#include "parallel/team.hpp"

namespace mgdt {

// Closes the gaps after an insertion. A gap is a vertex from `begin` on without a tetrahedron: a
// repeat, or a point that the call left out. Only points from `first_point` on map to vertices from
// `begin` on.
void compact_vertices(State& state, Team& team, std::size_t begin,
                      std::size_t first_point) noexcept;
// Closes the gaps after removals and moves. `gaps` lists the removed vertices; the function sorts
// this list.
void close_gaps(State& state, Buffer<VertexId>& gaps) noexcept;
// Sorts the vertices of records so that two tetrahedra that share a facet have the same guard for
// the facet. Insertion by several threads needs this (parallel/block_ownership.hpp).
void make_guards_agree(Mesh& mesh) noexcept;

}  // namespace mgdt
