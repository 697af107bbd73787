// SPDX-License-Identifier: MIT
// Conflicts near ties: see kernel/ties.hpp.
#pragma once

#include "kernel/circumsphere.hpp"
#include "predicates/stages.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

inline int perturbed_doubles(const Tetrahedron& t, const Vertex* vertices, const Query& q) {
    return exact::perturbed_doubles(vertices[t.v[0]].x, vertices[t.v[1]].x, vertices[t.v[2]].x,
                                    vertices[t.v[3]].x, q.point);
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
