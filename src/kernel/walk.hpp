// SPDX-License-Identifier: MIT
// The walk: from a tetrahedron near q to one in conflict with q.
//
// For two neighbours, the power of q with respect to the far one minus that with respect to the
// near one is an affine function of q, zero on the shared facet and negative beyond it. So
// descending the power is a visibility walk without orientation tests. It cannot cycle: each step
// takes a smaller power, and a tetrahedron has one computed power (all are computed in one way
// after the first step). The walk stops at the first conflict, where the cavity begins; the
// tetrahedron that contains q is never looked for. Where rounding leaves a local minimum without
// conflict, an exact visibility walk takes over.
#pragma once

#include "kernel/cavity.hpp"
#include "kernel/kernel.hpp"
#include "kernel/rough_walk.hpp"
#include "kernel/workspace.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

struct WalkResult {
    // Where the cavity begins. If there is a duplicate, the tetrahedron that has this vertex.
    // no_tetrahedron if the walk came to a tetrahedron that this thread may not enter.
    CavityStart start;
    VertexId duplicate;  // the vertex at q's place, or infinite_vertex
};

inline constexpr WalkResult no_way = {{no_tetrahedron, 0}, infinite_vertex};

// The exact walk. It ends in the closed tetrahedron that contains q, or in a ghost whose facet q is
// strictly beyond. Returns no_tetrahedron if this thread may not enter the next tetrahedron. Each
// step begins its tests with another face. point_of(v, room) returns the coordinates of a vertex,
// which it may compute into `room`.
template <class TryOwn, class PointOf>
TetId walk_exact(const Mesh& mesh, TetId t, const double* q, Counters& counters, TryOwn try_own,
                 PointOf point_of) {
    unsigned from = 4;  // the face that the walk came through; q is not beyond it
    for (unsigned turn = 0;; ++turn) {
        const Tetrahedron& tet = mesh.tetrahedra[t];
        ++counters.walk_steps;
        double room[4][3];
        const double* p[4];
        for (unsigned i = 0; i < 4; ++i) p[i] = point_of(tet.v[i], room[i]);
        // Positive if q and the vertex opposite the face are on the same side of it.
        const auto side = [&](unsigned face) {
            const double* corner[4] = {p[0], p[1], p[2], p[3]};
            corner[face] = q;
            ++counters.exact_calls;
            return orientation(corner[0], corner[1], corner[2], corner[3]);
        };
        unsigned through = 4;
        if (tet.is_ghost()) {
            const unsigned slot = static_cast<unsigned>(tet.infinite_slot());
            if (side(slot) <= 0) through = slot;
        } else {
            for (unsigned i = 0; i < 4 && through == 4; ++i) {
                const unsigned face = (i + turn) & 3;
                if (face != from && side(face) < 0) through = face;
            }
        }
        if (through == 4) return t;
        t = tetrahedron_of(tet.n[through]);
        from = face_of(tet.n[through]);
        if (!try_own(mesh.tetrahedra[t])) return no_tetrahedron;
    }
}

// If all points are on one sphere, all powers of a further point of this sphere are 0. The
// tetrahedra inside are long and thin, and a walk through them visits hundreds. A walk over the
// hull is short: each step goes to the neighbouring ghost for which q is highest above the plane of
// its facet. The walk ends at a ghost that is certainly in conflict. Returns no_tetrahedron if no
// such ghost is found, as for q inside the hull.
template <class Access>
inline TetId walk_hull(Access access, const Mesh& mesh, TetId ghost, const Query& q,
                       Counters& counters) {
    const typename Access::SphereSource spheres(mesh);
    const auto tetrahedra = spheres.tetrahedra;
    struct View {
        Power power;
        double height;  // the height of q above the plane of the facet
    };
    const auto look = [&](TetId t) {
        const Sphere s = spheres.sphere(t);
        const Power p = power(s, mesh.point(tetrahedra[t].v[0]), q);
        return View{p, -p.value * reciprocal(std::sqrt(s.w[0] * s.w[0] + s.w[1] * s.w[1] +
                                                       s.w[2] * s.w[2]))};
    };
    const View first = look(ghost);
    if (first.power.is_conflict()) return ghost;
    // The loop ends, because each ghost has one height and each step takes a greater height.
    for (double highest = first.height;;) {
        const Tetrahedron& here = tetrahedra[ghost];
        const unsigned slot = static_cast<unsigned>(here.infinite_slot());
        TetId next = no_tetrahedron;
        ++counters.walk_steps;
        for (unsigned i = 0; i < 4; ++i) {
            if (i == slot) continue;
            const TetId t = tetrahedron_of(here.n[i]);
            const View there = look(t);
            ++counters.walk_tests;
            if (there.power.is_conflict())
                return access.try_own(tetrahedra[t]) ? t : no_tetrahedron;
            if (!(there.height > highest)) continue;
            highest = there.height;
            next = t;
        }
        if (next == no_tetrahedron || !access.try_own(tetrahedra[next])) return no_tetrahedron;
        ghost = next;
    }
}

struct WalkStart {
    TetId tetrahedron;
    Power power;
};

template <class Spheres>
WalkStart start_at(const Spheres& from, TetId t, const Query& q, Counters& counters) {
    ++counters.walk_tests;
    return {t, power(from, t, q)};
}

// A ghost of the star built last, if it has one.
inline TetId ghost_of_star(const Mesh& mesh, const Workspace& w) {
    for (std::size_t i = 0; i < w.slot_count; ++i) {
        const TetId t = tetrahedron_of(w.slots.data[i]);
        if (mesh.tetrahedra[t].is_ghost()) return t;
    }
    return no_tetrahedron;
}

// A start in the star built last: the tetrahedron of least power among four that are spread over
// the star. The four share their base vertex and are still in the cache. A start on the right side
// of the star saves a step or more.
template <class Spheres>
WalkStart start_in_star(const Spheres& from, const Workspace& w, const Query& q,
                        Counters& counters) {
    constexpr std::size_t sample = 4;
    FacetCode codes[sample];
    for (std::size_t i = 0; i < sample; ++i) codes[i] = w.slots.data[i * w.slot_count / sample];
    const FourPowers powers(from, from.tetrahedra.four(codes), q);
    counters.walk_tests += sample;
    const unsigned best = powers.least_finite(infinity) & 3;  // the first if all are ghosts
    return {tetrahedron_of(codes[best]), powers[best]};
}

// A long walk samples random tetrahedra of the mesh, one for each step that it has taken. If the
// least of their powers is less than the current power, the walk continues at that tetrahedron. So
// a walk along a chain or fan of n tetrahedra takes about sqrt(n) steps.
template <class Spheres>
MGDT_NOT_INLINE void jump(const Mesh& mesh, WalkStart& here, const Query& q, std::size_t tries,
                          Counters& counters) {
    const Spheres spheres(mesh);
    const auto tetrahedra = spheres.tetrahedra;
    const TetId start = here.tetrahedron;
    std::uint64_t random = start;
    counters.walk_tests += tries;
    for (std::size_t i = 0; i < tries; i += 4) {
        FacetCode codes[4];
        for (FacetCode& code : codes) {
            random = random * 0x5851F42D4C957F2Du + 0x14057B7EF767814Fu;
            const auto t = static_cast<TetId>((random >> 32) * mesh.tetrahedra.size() >> 32);
            code = first_facet(tetrahedra[t].is_dead() ? start : t);
        }
        const FourPowers powers(spheres, tetrahedra.four(codes), q);
        const unsigned best = powers.least_finite(here.power.value);
        if (best < 4) here = {tetrahedron_of(codes[best]), powers[best]};
    }
}

// A walk jumps after this number of steps, and again whenever its number of steps has doubled.
constexpr std::uint64_t long_walk = 64;

// Walks from `here` to a tetrahedron in conflict with q. a_ghost() returns a ghost near the start,
// or no_tetrahedron. If may_jump is false, the walk goes step by step, however long it becomes.
template <class Access, class Ghost>
inline WalkResult walk(Access access, const Mesh& mesh, WalkStart here, const Query& q,
                       Counters& counters, Ghost a_ghost, bool may_jump = false) {
    const typename Access::SphereSource spheres(mesh);
    const auto tetrahedra = spheres.tetrahedra;
    ++counters.walk_steps;
    if (here.power.is_conflict()) return {{here.tetrahedron, 0}, infinite_vertex};
    std::uint64_t steps = 0, next_jump = may_jump ? long_walk : 0;
    for (;;) {
        const Tetrahedron& t = tetrahedra[here.tetrahedron];
        if (MGDT_UNLIKELY(!here.power.is_decided())) {
            const VertexId same = vertex_at(mesh, t, q.point);
            if (same != infinite_vertex) return {{here.tetrahedron, 0}, same};
            ++counters.exact_calls;
            if (is_conflict_near_tie(mesh, t, q)) return {{here.tetrahedron, 0}, infinite_vertex};
        }
        const FourPowers powers(spheres, tetrahedra.four(t.n), q);
        const std::uint32_t decided = powers.decided();
        const std::uint32_t conflict = powers.negative() & decided;
        counters.walk_tests += 4;
        ++counters.walk_steps;
        // If the signs of t and its four neighbours are certain, t is not in conflict, and the
        // cavity begins with all neighbours that are. Otherwise the cavity begins with one
        // neighbour in conflict, and its growth tests t and the other neighbours.
        if (conflict != 0) {
            if (MGDT_UNLIKELY(decided != 0xF || !here.power.is_decided()))
                return {{tetrahedron_of(t.n[lowest_bit(conflict)]), 0}, infinite_vertex};
            return {{here.tetrahedron, conflict}, infinite_vertex};
        }
        // A ghost's value cannot be compared with the power of a sphere. So the walk enters a ghost
        // only if that is certainly in conflict, and leaves a ghost through any finite neighbour.
        const unsigned next = powers.least_finite(t.is_ghost() ? infinity : here.power.value);
        if (next == 4) break;
        here = {tetrahedron_of(t.n[next]), powers[next]};
        if (MGDT_UNLIKELY(!access.try_own(tetrahedra[here.tetrahedron]))) return no_way;
        if constexpr (Access::is_alone) {
            if (MGDT_UNLIKELY(++steps == next_jump)) {
                jump<typename Access::SphereSource>(mesh, here, q, static_cast<std::size_t>(steps),
                                                    counters);
                if (here.power.is_conflict()) return {{here.tetrahedron, 0}, infinite_vertex};
                next_jump *= 2;
            }
        }
    }
    const TetId ghost = a_ghost();
    if (ghost != no_tetrahedron && access.try_own(tetrahedra[ghost])) {
        const TetId found = walk_hull(access, mesh, ghost, q, counters);
        if (found != no_tetrahedron) return {{found, 0}, infinite_vertex};
    }
    const auto try_own = [&](const Tetrahedron& t) { return access.try_own(t); };
    const TetId t =
        walk_exact(mesh, walk_roughly(mesh, here.tetrahedron, q.point, counters, try_own), q.point,
                   counters, try_own, [&](VertexId v, double*) { return mesh.point(v); });
    if (t == no_tetrahedron) return no_way;
    return {{t, 0}, vertex_at(mesh, mesh.tetrahedra[t], q.point)};
}

// Moves a location to the neighbour of least power, if that is less than the current power. Returns
// false if there is no such neighbour. In this case the tetrahedron contains q if the comparisons
// are certain, since the difference of two neighbours' powers changes sign on their facet. If
// may_end_outside is set, a location also ends at a ghost that is certainly in conflict, because q
// is beyond its hull facet.
template <class Spheres>
bool locate_step(const Mesh& mesh, LocationWalk& w) {
    const Spheres spheres(mesh);
    const auto tetrahedra = spheres.tetrahedra;
    const FacetCode* const n = tetrahedra[w.tetrahedron].n;
    const FourPowers powers(spheres, tetrahedra.four(n), Query(w.q));
    const std::uint32_t outside = powers.ghosts() & powers.negative() & powers.decided();
    if (MGDT_UNLIKELY(outside != 0) && w.may_end_outside) {
        w.tetrahedron = tetrahedron_of(n[lowest_bit(outside)]);
        w.is_certain = true;
        return false;
    }
    const unsigned next = powers.least_finite(w.value);
    if (next == 4) {
        // No finite neighbour has a smaller power. The tetrahedron certainly contains q if all four
        // values exceed the current one by more than the errors. A ghost's value is compared with 0
        // instead.
        w.is_certain = powers.above({w.value, w.error}) == 0xF;
        return false;
    }
    const Power there = powers[next];
    w.tetrahedron = tetrahedron_of(n[next]);
    w.value = there.value;
    w.error = there.error;
    for (const FacetCode code : tetrahedra[w.tetrahedron].n) tetrahedra.prefetch_of(code);
    return true;
}

template <class Spheres>
void locate_jump(const Mesh& mesh, LocationWalk& w, std::size_t tries) {
    Counters unused;
    WalkStart here = {w.tetrahedron, {w.value, w.error}};
    jump<Spheres>(mesh, here, Query(w.q), tries, unused);
    w.tetrahedron = here.tetrahedron;
    w.value = here.power.value;
    w.error = here.power.error;
}

template <class Spheres>
void locate_begin(const Mesh& mesh, LocationWalk& w) {
    const Tetrahedron& t = mesh.tetrahedra[w.tetrahedron];
    if (t.is_ghost()) w.tetrahedron = tetrahedron_of(t.n[t.infinite_slot()]);
    const Power here = power(Spheres(mesh), w.tetrahedron, Query(w.q));
    w.value = here.value;
    w.error = here.error;
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
