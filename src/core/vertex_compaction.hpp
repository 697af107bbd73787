// SPDX-License-Identifier: MIT
// Vertices keep consecutive numbers: gaps are closed at the end of a call by the last vertices, and
// the order of vertices in records is mended where threads need it.
#pragma once

#include "core/state.hpp"
#include "parallel/team.hpp"

namespace mgdt {

// After an insertion: a gap is a vertex from `begin` on without a tetrahedron, as of a repeat, or
// of a point that a call left out. Points from `first_point` on may map to these.
void compact_vertices(State& state, Team& team, std::size_t begin,
                      std::size_t first_point) noexcept;
// After removals and moves: the vertices in `gaps`, which is sorted, are gone.
void close_gaps(State& state, Buffer<VertexId>& gaps) noexcept;
// Gives every two tetrahedra that share a facet the same guard for it, which several threads need
// (parallel/block_ownership.hpp).
void make_guards_agree(Mesh& mesh) noexcept;

}  // namespace mgdt
