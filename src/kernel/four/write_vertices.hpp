// SPDX-License-Identifier: MIT
// The vertices of a new tetrahedron: see kernel/words.hpp.
#pragma once

#include "kernel/four.hpp"
#include "mesh/tetrahedron.hpp"
#include "platform/compiler.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// The first three positions are those of outer_face; the fourth one is not used.
constexpr FourPositions outer_positions[4] = {
    {1, 3, 2, 0}, {0, 2, 3, 1}, {0, 3, 1, 2}, {0, 1, 2, 3}};

MGDT_ALWAYS_INLINE const VertexId* write_vertices(const Tetrahedron& outside, FacetCode code,
                                                  VertexId q, Tetrahedron& out) {
    FourWords::load(outside.v).at(outer_positions[face_of(code)]).behind(q).store(out.v);
    return out.v + 1;
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
