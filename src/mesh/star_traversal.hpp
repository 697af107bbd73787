// SPDX-License-Identifier: MIT
// Visits the star of a vertex, from one of its tetrahedra to the others.
#pragma once

#include <cassert>

#include "mesh/mesh.hpp"

namespace mgdt {

// For each tetrahedron in `star` and each of its facets at vertex v, calls enter() with the code of
// the facet on the neighbour's side. enter() may append the neighbour to `star`, and the traversal
// then visits the neighbour too. If enter() appends every tetrahedron that is not in `star` yet,
// all tetrahedra of v are visited.
template <class Star, class Enter>
void traverse_star(const Mesh& mesh, VertexId v, const Star& star, Enter enter) {
    for (std::size_t i = 0; i < star.size(); ++i) {
        const Tetrahedron& t = mesh.tetrahedra[star[i]];
        assert(!t.is_dead() && "a tetrahedron of the star is dead");
        assert((t.v[0] == v || t.v[1] == v || t.v[2] == v || t.v[3] == v) &&
               "a tetrahedron of the star lacks the vertex");
        for (unsigned face = 0; face < 4; ++face)
            if (t.v[face] != v) enter(t.n[face]);
    }
}

}  // namespace mgdt
