// SPDX-License-Identifier: MIT
// Words moved one by one: see kernel/words.hpp.
#pragma once

#include "kernel/island.hpp"
#include "mesh/tetrahedron.hpp"
#include "platform/compiler.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

MGDT_ALWAYS_INLINE unsigned append(std::uint32_t* to, const std::uint32_t* words,
                                   std::uint32_t bits) {
    unsigned count = 0;
    for (unsigned k = 0; k < 4; ++k) {
        to[count] = words[k];
        count += bits >> k & 1;
    }
    return count;
}

MGDT_ALWAYS_INLINE const VertexId* write_vertices(const Tetrahedron& outside, FacetCode code,
                                                  VertexId q, Tetrahedron& out) {
    out.v[0] = q;
    for (unsigned k = 0; k < 3; ++k) out.v[k + 1] = outside.v[outer_face[face_of(code)][k]];
    return out.v + 1;
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
