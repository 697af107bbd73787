// SPDX-License-Identifier: MIT
// The tetrahedra around an edge, in cyclic order. Their circumcentres are the corners of a Voronoi
// face.
#pragma once

#include "mesh/mesh.hpp"

namespace mgdt {

// A tetrahedron at the edge from a to b. With its vertices in slots k and l, (a, b, k, l) is
// positively oriented, so the way from k to l turns counter-clockwise about the direction from a to
// b.
struct RingStep {
    TetId t;
    unsigned k, l;

    // The tetrahedron `t` at the edge from its vertex in slot i to that in slot j.
    static RingStep first(TetId t, unsigned i, unsigned j) noexcept {
        // Slots k and l for which (i, j, k, l) is an even permutation of (0, 1, 2, 3).
        static constexpr unsigned char others[4][4][2] = {{{0, 0}, {2, 3}, {3, 1}, {1, 2}},
                                                          {{3, 2}, {0, 0}, {0, 3}, {2, 0}},
                                                          {{1, 3}, {3, 0}, {0, 0}, {0, 1}},
                                                          {{2, 1}, {0, 2}, {1, 0}, {0, 0}}};
        return {t, others[i][j][0], others[i][j][1]};
    }
    // The next tetrahedron, across the face that contains the edge and vertex l.
    RingStep next(const Mesh& mesh) const noexcept {
        const Tetrahedron& here = mesh.tetrahedra[t];
        const VertexId shared = here.v[l];
        const TetId beyond = tetrahedron_of(here.n[k]);
        const unsigned apex = face_of(here.n[k]);
        const VertexId(&v)[4] = mesh.tetrahedra[beyond].v;
        const unsigned at =
            (v[1] == shared ? 1u : 0u) | (v[2] == shared ? 2u : 0u) | (v[3] == shared ? 3u : 0u);
        return {beyond, at, apex};
    }
};

}  // namespace mgdt
