// SPDX-License-Identifier: MIT
#include "core/first_tetrahedra.hpp"

#include <algorithm>

#include "predicates/predicates.hpp"

namespace mgdt {

// Each of the five tetrahedra is a neighbour of the other four.
void make_first_tetrahedra(State& state) {
    Mesh& mesh = state.mesh;
    // The newest vertex comes first, as if the vertices had been inserted in the order 1, 2, 3, 4.
    VertexId v[4] = {4, 3, 2, 1};
    if (orientation(mesh.point(4), mesh.point(3), mesh.point(2), mesh.point(1)) < 0)
        std::swap(v[2], v[3]);
    mesh.tetrahedra.resize(5);
    TetrahedronStore& all = mesh.tetrahedra;
    std::copy(v, v + 4, all[0].v);
    for (unsigned f = 0; f < 4; ++f) {
        // Ghost f + 1 stands on face f. (q, a, b, c) is positively oriented for q beyond the face.
        // The record is an even permutation of (vertex at infinity, a, b, c).
        const unsigned char* face = outer_face[f];
        const VertexId a = v[face[0]], b = v[face[1]], c = v[face[2]];
        const VertexId ghost[4] = {a, b > c ? b : c, b > c ? infinite_vertex : b,
                                   b > c ? c : infinite_vertex};
        std::copy(ghost, ghost + 4, all[f + 1].v);
    }
    const auto slot = [&](TetId t, VertexId of) {
        return static_cast<FacetCode>(std::find(all[t].v, all[t].v + 4, of) - all[t].v);
    };
    for (FacetCode f = 0; f < 4; ++f) {
        Tetrahedron& ghost = all[f + 1];
        for (unsigned i = 0; i < 4; ++i) {
            if (ghost.v[i] == infinite_vertex) {
                ghost.n[i] = f;
                all[0].n[f] = facet_code(f + 1, i);
            } else {
                // The neighbour opposite a finite vertex is the ghost that lacks this vertex. In
                // that ghost, the common facet is opposite v[f], which this ghost lacks.
                const TetId other = slot(0, ghost.v[i]) + 1;
                ghost.n[i] = facet_code(other, slot(other, v[f]));
            }
        }
    }
    if (mesh.tetrahedra.has_spheres()) state.set_spheres();
    mesh.ghost_count = 4;
    mesh.a_ghost = 4;
    state.walk_starts.last = 0;
    for (VertexId i = 1; i <= 4; ++i) mesh.vertex_hint[i] = 0;
    state.statistics.points_inserted += 4;
}

}  // namespace mgdt
