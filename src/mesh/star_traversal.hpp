// SPDX-License-Identifier: MIT
// The star of a vertex, from one of its tetrahedra to the others.
#pragma once

#include "mesh/mesh.hpp"

namespace mgdt {

// Calls enter(facet) for each facet at vertex v of the tetrahedra in `star`, as seen from their
// neighbour across it. What `enter` adds to `star`, a list of tetrahedra of v, is visited too: if
// it adds those that are not in yet, all tetrahedra of v are.
template <class Star, class Enter>
void traverse_star(const Mesh& mesh, VertexId v, const Star& star, Enter enter) {
    for (std::size_t i = 0; i < star.size(); ++i) {
        const Tetrahedron& t = mesh.tetrahedra[star[i]];
        for (unsigned face = 0; face < 4; ++face)
            if (t.v[face] != v) enter(t.n[face]);
    }
}

}  // namespace mgdt
