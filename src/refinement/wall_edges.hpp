// SPDX-License-Identifier: MIT
// Walks from wall to wall in a mesh with walls, around the edges between them.
#pragma once

#include "refinement/walled_mesh.hpp"

namespace mgdt {

// The code of a wall is that of the face on the side of one of its tetrahedra, which is finite.
struct WallEdges {
    // The corners of a wall: counter-clockwise as seen from its tetrahedron.
    void corners(FacetCode wall, VertexId (&v)[3]) const noexcept {
        const Tetrahedron& t = mesh.mesh.tetrahedra[tetrahedron_of(wall)];
        for (int k = 0; k < 3; ++k) v[k] = t.v[outer_face[face_of(wall)][k]];
    }
    bool is_hull(FacetCode wall) const noexcept {
        return mesh.mesh.tetrahedra[tetrahedron_of(behind(wall))].is_ghost();
    }
    // The same wall as seen from the other side.
    FacetCode behind(FacetCode wall) const noexcept {
        return mesh.mesh.tetrahedra[tetrahedron_of(wall)].n[face_of(wall)];
    }
    // The next wall around the edge xy of a wall, on the side of the wall's tetrahedron.
    FacetCode next(FacetCode wall, VertexId x, VertexId y) const noexcept {
        for (FacetCode code = wall;;) {
            const TetId t = tetrahedron_of(code);
            const Tetrahedron& tet = mesh.mesh.tetrahedra[t];
            unsigned other = 0;
            while (other == face_of(code) || tet.v[other] == x || tet.v[other] == y) ++other;
            const FacetCode face = facet_code(t, other);
            if (mesh.is_wall(face)) return face;
            code = tet.n[other];
        }
    }
    // Calls f(wall) for each side of each wall that is a part of a facet.
    template <class F>
    void for_each_side(const F& f) const {
        for (TetId t = 0; t < mesh.mesh.tetrahedra.size(); ++t) {
            const Tetrahedron& tet = mesh.mesh.tetrahedra[t];
            if (tet.is_dead() || tet.is_ghost()) continue;
            for (unsigned k = 0; k < 4; ++k)
                if (is_of_facet(facet_code(t, k))) f(facet_code(t, k));
        }
    }
    bool is_of_facet(FacetCode face) const noexcept {
        return mesh.is_wall(face) && mesh.sides[face] != no_index;
    }
    LinkedMesh::Side side(FacetCode wall) const noexcept { return mesh.sides[wall]; }
    // The wall of the same facet on the other side of the edge xy, or no_index if the edge is a
    // segment: one that the mesh keeps, or where other walls meet.
    FacetCode across(FacetCode wall, VertexId x, VertexId y) const noexcept {
        if (mesh.edges.has(x, y)) return no_index;
        const FacetCode other = next(wall, x, y);
        if (other == wall || side(other) != side(wall) || is_hull(other) != is_hull(wall))
            return no_index;
        if (is_hull(wall)) return other;
        return next(behind(wall), x, y) == behind(other) ? other : no_index;
    }

    const WalledMesh& mesh;
};

}  // namespace mgdt
