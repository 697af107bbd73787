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

#include "kernel/candidate.hpp"

namespace mgdt {
inline namespace MGDT_ISA {

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
    Tetrahedron* const tetrahedra = mesh.tetrahedra.data();
    const Vertex* const vertices = mesh.vertices.data();
    const std::uint32_t inside = 2 * ++mesh.insertion + 1;
    const CandidateTest test(q);

    if (MGDT_UNLIKELY(w.boundary_capacity == 0)) w.grow_cavity(0, 64, 0, 64, 0, 64);
    // The first tetrahedron is entered through no face; face 0 stands in.
    tetrahedra[start].mark = inside;
    w.cavity.data[0] = 4 * start;
    for (unsigned i = 0; i < 4; ++i) w.candidates.data[i] = tetrahedra[start].n[i];
    const FacetCode* next = w.candidates.data;
    FacetCode* candidates_end = w.candidates.data + 4;
    FacetCode* cavity_end = w.cavity.data + 1;
    BoundaryFacet* boundary_end = w.boundary.data;

    while (next != candidates_end) {
        const std::size_t wave = static_cast<std::size_t>(candidates_end - next);
        const std::size_t candidates = static_cast<std::size_t>(candidates_end - w.candidates.data);
        const std::size_t members = static_cast<std::size_t>(cavity_end - w.cavity.data);
        const std::size_t facets = static_cast<std::size_t>(boundary_end - w.boundary.data);
        // Room for all that the wave can add.
        if (MGDT_UNLIKELY(candidates + 3 * wave > w.candidate_capacity ||
                          members + wave > w.cavity_capacity ||
                          facets + wave > w.boundary_capacity)) {
            w.grow_cavity(candidates, candidates + 3 * wave, members, members + wave, facets,
                          facets + wave);
            candidates_end = w.candidates.data + candidates;
            cavity_end = w.cavity.data + members;
            boundary_end = w.boundary.data + facets;
            next = candidates_end - wave;
        }
        const FacetCode* const wave_end = candidates_end;
        for (const FacetCode* code = next; code != wave_end; ++code)
            prefetch(&tetrahedra[*code >> 2]);

        for (; next != wave_end; ++next) {
            const FacetCode code = *next;
            Tetrahedron& t = tetrahedra[code >> 2];
            const Power s = test(t, vertices);
            std::uint32_t conflict = s.is_conflict();
            if (MGDT_UNLIKELY(!s.is_decided()))
                conflict = is_conflict_undecided(mesh, t, q, inside, w.counters);
            conflict = opaque(conflict);
            const std::uint32_t mark = t.mark;
            const std::uint32_t fresh = opaque(conflict & (mark != inside));
            t.mark = mark ^ ((mark ^ inside) & (0 - fresh));
            test.write(t, code, boundary_end, candidates_end);
            *cavity_end = code;
            boundary_end += 1 - conflict;
            cavity_end += fresh;
            candidates_end += 3 * fresh;
        }
    }
    w.cavity_size = static_cast<std::size_t>(cavity_end - w.cavity.data);
    w.boundary_size = static_cast<std::size_t>(boundary_end - w.boundary.data);
    w.counters.conflict_tests += static_cast<std::size_t>(candidates_end - w.candidates.data);
}

}  // namespace MGDT_ISA
}  // namespace mgdt
