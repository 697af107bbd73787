// SPDX-License-Identifier: MIT
// The cavity: all tetrahedra in conflict with q, grown from one of them, and its boundary.
//
// One array holds the candidates, each a tetrahedron and the face it is reached through. Testing
// one costs a load of its line and of its base vertex and no unpredictable branch: the outcome
// moves the ends of the arrays by 0 or 1, and only the rare undecided sign branches. A
// tetrahedron outside may be tested through several faces; each is a facet of the boundary.
// Candidates go in waves, whose lines are fetched before the first is needed.
//
// Marks: 2 k + 1 says in the cavity of insertion k, 2 k says decided exactly not to be in it.
// The mesh is otherwise unchanged, so that an insertion can be given up until the star is built.
#pragma once

#include "kernel/workspace.hpp"

namespace mgdt {

inline void prefetch(const void* p) {
#if defined(__GNUC__)
    __builtin_prefetch(p);
#else
    static_cast<void>(p);
#endif
}

// Decides a candidate whose power does not.
inline bool is_conflict_undecided(const Mesh& mesh, Tetrahedron& t, const Query& q,
                                  std::uint32_t inside, Counters& counters) {
    if (t.mark == inside) return true;
    if (t.mark == inside - 1) return false;
    ++counters.exact_calls;
    const bool conflict = is_conflict_exact(mesh, t, q.point);
    if (!conflict) t.mark = inside - 1;
    return conflict;
}

inline void dig_cavity(Mesh& mesh, Workspace& w, TetId start, const Query& q) {
    Tetrahedron* tetrahedra = mesh.tetrahedra.data();
    const Vertex* vertices = mesh.vertices.data();
    const std::uint32_t inside = 2 * ++mesh.insertion + 1;

    w.candidates.grow(64);
    w.cavity.grow(64);
    w.boundary.grow(64);
    // The first tetrahedron is entered through no face; face 0 stands in, its neighbour is a
    // candidate like the others.
    tetrahedra[start].mark = inside;
    w.cavity[0] = 4 * start;
    for (unsigned i = 0; i < 4; ++i) w.candidates[i] = tetrahedra[start].n[i];
    std::size_t cavity_end = 1, boundary_end = 0, begin = 0, end = 4;

    while (begin < end) {
        const std::size_t wave = end - begin;
        // Room for all that the wave can add; the loop below stores past the ends it keeps.
        w.candidates.resize(end);
        w.candidates.grow(end + 3 * wave + 1);
        w.cavity.resize(cavity_end);
        w.cavity.grow(cavity_end + wave + 1);
        w.boundary.resize(boundary_end);
        w.boundary.grow(boundary_end + wave + 1);
        FacetCode* const candidates = w.candidates.data();
        FacetCode* const cavity = w.cavity.data();
        BoundaryFacet* const boundary = w.boundary.data();
        for (std::size_t i = begin; i < begin + wave; ++i)
            prefetch(&tetrahedra[candidates[i] >> 2]);

        for (const std::size_t stop = begin + wave; begin < stop; ++begin) {
            const FacetCode code = candidates[begin];
            const unsigned face = code & 3;
            Tetrahedron& t = tetrahedra[code >> 2];
            const Power s = power(t, vertices, q);
            bool conflict = s.is_conflict();
            if (__builtin_expect(!s.is_decided(), 0))
                conflict = is_conflict_undecided(mesh, t, q, inside, w.counters);
            const bool fresh = conflict & (t.mark != inside);
            t.mark = fresh ? inside : t.mark;

            const unsigned char* order = outer_face[face];
            boundary[boundary_end] = {{t.v[order[0]], t.v[order[1]], t.v[order[2]]}, code};
            boundary_end += !conflict;
            cavity[cavity_end] = code;
            cavity_end += fresh;
            candidates[end] = t.n[order[0]];
            candidates[end + 1] = t.n[order[1]];
            candidates[end + 2] = t.n[order[2]];
            end += fresh ? 3 : 0;
        }
    }
    w.cavity.resize(cavity_end);
    w.boundary.resize(boundary_end);
    w.counters.conflict_tests += end;
}

}  // namespace mgdt
