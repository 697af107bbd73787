// SPDX-License-Identifier: MIT
// The walk: from a tetrahedron near q to one in conflict with q.
//
// Powers of q with respect to the circumspheres of two tetrahedra that share a facet differ by an
// affine function that vanishes on the facet and is negative on the far side, so descending the
// power is a visibility walk without orientation tests. It cannot cycle, since each computed
// power is a fixed number, and it stops at the first conflict: the cavity grows from there, and
// the tetrahedron that contains q is never looked for. Where rounding leaves a local minimum
// without conflict, an exact visibility walk takes over.
#pragma once

#include "kernel/circumsphere.hpp"
#include "kernel/workspace.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
inline namespace MGDT_ISA {

struct WalkResult {
    TetId tetrahedron;   // in conflict with q, or has the vertex
    VertexId duplicate;  // the vertex at q's place, or infinite_vertex
};

// The exact walk. It ends in the closed tetrahedron that contains q, or in a ghost whose facet q
// is strictly beyond. point_of(v, room) gives a vertex's coordinates, in `room` if need be.
template <class PointOf>
TetId walk_exact(const Mesh& mesh, TetId t, const double* q, Counters& counters, PointOf point_of) {
    for (unsigned turn = 0;; ++turn) {
        const Tetrahedron& tet = mesh.tetrahedra[t];
        ++counters.walk_steps;
        double room[4][3];
        const double* p[4];
        for (unsigned i = 0; i < 4; ++i) p[i] = point_of(tet.v[i], room[i]);
        // Side of q with respect to a face: positive where the vertex opposite is.
        const auto side = [&](unsigned face) {
            const double* corner[4] = {p[0], p[1], p[2], p[3]};
            corner[face] = q;
            ++counters.exact_calls;
            return orientation(corner[0], corner[1], corner[2], corner[3]);
        };
        TetId next = no_tetrahedron;
        if (tet.is_ghost()) {
            const unsigned slot = static_cast<unsigned>(tet.infinite_slot());
            if (side(slot) <= 0) next = tet.n[slot] >> 2;
        } else {
            for (unsigned i = 0; i < 4 && next == no_tetrahedron; ++i) {
                const unsigned face = (i + turn) & 3;
                if (side(face) < 0) next = tet.n[face] >> 2;
            }
        }
        if (next == no_tetrahedron) return t;
        t = next;
    }
}

inline TetId walk_exact(const Mesh& mesh, TetId t, const double* q, Counters& counters) {
    return walk_exact(mesh, t, q, counters, [&](VertexId v, double*) { return mesh.point(v); });
}

// A better start than any tetrahedron of the star built last: that of least power among a few
// spread over it. They share their base vertex and are still in the cache, and the right side of
// the star saves a step or more.
inline TetId choose_in_star(const Mesh& mesh, const Workspace& w, const Query& q,
                            Counters& counters) {
    constexpr std::size_t sample = 4;
    const std::size_t size = w.slot_count, stride = size / sample + 1;
    TetId best = w.slots.data[0];
    double least = infinity;
    for (std::size_t i = 0; i < size; i += stride) {
        const Tetrahedron& t = mesh.tetrahedra[w.slots.data[i]];
        const double value = power(t, mesh.vertices.data(), q).value;
        ++counters.walk_tests;
        if (!t.is_ghost() && value < least) {
            least = value;
            best = w.slots.data[i];
        }
    }
    return best;
}

inline WalkResult walk(const Mesh& mesh, TetId start, const Query& q, Counters& counters) {
    const Tetrahedron* tetrahedra = mesh.tetrahedra.data();
    const Vertex* vertices = mesh.vertices.data();
    TetId t = start;
    TetId previous = no_tetrahedron;
    Power here = power(tetrahedra[t], vertices, q);
    ++counters.walk_tests;
    for (;;) {
        ++counters.walk_steps;
        const Tetrahedron& tet = tetrahedra[t];
        if (here.is_conflict()) return {t, infinite_vertex};
        if (!here.is_decided()) {
            const VertexId same = vertex_at(mesh, tet, q.point);
            if (same != infinite_vertex) return {t, same};
            ++counters.exact_calls;
            if (is_conflict_exact(mesh, tet, q.point)) return {t, infinite_vertex};
        }
        // A ghost is entered only when it is certainly in conflict: its value is no power that
        // compares with those of spheres.
        double least = tet.is_ghost() ? infinity : here.value;
        TetId next = no_tetrahedron;
        for (const FacetCode code : tet.n) {
            const TetId m = code >> 2;
            if (m == previous) continue;
            const Power there = power(tetrahedra[m], vertices, q);
            ++counters.walk_tests;
            if (tetrahedra[m].is_ghost() ? there.is_conflict() : there.value < least) {
                next = m;
                here = there;
                if (tetrahedra[m].is_ghost()) break;
                least = there.value;
            }
        }
        if (next == no_tetrahedron) break;
        previous = t;
        t = next;
    }
    t = walk_exact(mesh, t, q.point, counters);
    return {t, vertex_at(mesh, mesh.tetrahedra[t], q.point)};
}

}  // namespace MGDT_ISA
}  // namespace mgdt
