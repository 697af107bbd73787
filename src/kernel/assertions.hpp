// SPDX-License-Identifier: MIT
// Assertions about the replacement of a cavity by its star. In builds without assertions
// (b_ndebug=true) these functions do nothing.
#pragma once

#include <cassert>

#include "kernel/island.hpp"
#include "kernel/workspace.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

#if defined(NDEBUG)

template <class Access>
MGDT_ALWAYS_INLINE void assert_cavity_is_sound(Access, const Mesh&, const Workspace&) {}
MGDT_ALWAYS_INLINE void assert_star_is_sound(const Mesh&, const Workspace&, VertexId) {}

#else

// Asserts, before the mesh changes, that each member of the cavity is alive and owned by the
// thread.
template <class Access>
void assert_cavity_is_sound(Access access, const Mesh& mesh, const Workspace& w) {
    for (std::size_t i = 0; i < w.cavity_size; ++i) {
        const Tetrahedron& t = mesh.tetrahedra[tetrahedron_of(w.cavity.data[i])];
        assert(!t.is_dead() && "a member of the cavity is dead");
        assert(access.owns(t) && "a member of the cavity is not owned");
    }
}

// Asserts, after the mesh has changed, that the first vertex of each new tetrahedron is the newest,
// that neighbours refer to each other, that finite tetrahedra are positively oriented, and that the
// vertex at infinity is the third or the fourth of a ghost.
inline void assert_star_is_sound(const Mesh& mesh, const Workspace& w, VertexId q) {
    for (std::size_t i = 0; i < w.slot_count; ++i) {
        const TetId id = tetrahedron_of(w.slots.data[i]);
        const Tetrahedron& t = mesh.tetrahedra[id];
        assert(t.v[0] == q && "the newest vertex is not first");
        for (unsigned face = 0; face < 4; ++face) {
            const Tetrahedron& other = mesh.tetrahedra[tetrahedron_of(t.n[face])];
            assert(other.n[face_of(t.n[face])] == facet_code(id, face) &&
                   "a neighbour does not return the adjacency");
        }
        assert(t.v[1] != infinite_vertex && "the vertex at infinity is second");
        assert((t.is_ghost() || orientation(mesh.point(t.v[0]), mesh.point(t.v[1]),
                                            mesh.point(t.v[2]), mesh.point(t.v[3])) > 0) &&
               "a new tetrahedron is not positively oriented");
    }
}

#endif

}  // namespace MGDT_ISLAND
}  // namespace mgdt
