// SPDX-License-Identifier: MIT
// Walks from a tetrahedron to a point: the library's, and those that it could have taken instead.
// None changes the mesh. Each counts the tetrahedra that it visits, the first and the last too, and
// the predicates that it asks: powers of the point, and orientations.
#pragma once

#include "kernel/walk.hpp"
#include "platform/random.hpp"

namespace bench {

using mgdt::infinite_vertex;
using mgdt::Mesh;
using mgdt::Query;
using mgdt::TetId;
using mgdt::Tetrahedron;

// Where a walk starts, and of how many tetrahedra's powers it is the least; 0 if none was asked.
struct Start {
    TetId tetrahedron;
    unsigned sampled;
};

struct Path {
    TetId end;
    std::size_t steps, tests;
};

enum Goal { conflict, base };  // the first tetrahedron in conflict, or the one that has the point

inline bool is_in_conflict(const Mesh& mesh, TetId t, const Query& q) {
    const mgdt::Power s = mgdt::power(mgdt::KeptSpheres(mesh), t, q);
    return s.is_decided() ? s.is_conflict() : is_conflict_exact(mesh, mesh.tetrahedra[t], q.point);
}

// The side of a face on which q is: positive where the vertex opposite is.
inline int side(const Mesh& mesh, const Tetrahedron& t, unsigned face, const double* q) {
    const double* p[4];
    for (unsigned i = 0; i < 4; ++i) p[i] = mesh.point(t.v[i]);
    p[face] = q;
    return mgdt::orientation(p[0], p[1], p[2], p[3]);
}

// Whether the closed tetrahedron contains q, or q is strictly beyond the ghost's facet.
inline bool contains(const Mesh& mesh, const Tetrahedron& t, const double* q) {
    if (t.is_ghost()) return side(mesh, t, static_cast<unsigned>(t.infinite_slot()), q) > 0;
    for (unsigned face = 0; face < 4; ++face)
        if (side(mesh, t, face, q) < 0) return false;
    return true;
}

// Walks from afar have no ghost at hand.
inline TetId no_ghost() {
    return mgdt::no_tetrahedron;
}

// The library's walk to the first conflict.
inline Path power_to_conflict(Mesh& mesh, Start from, const Query& q) {
    mgdt::Counters counters;
    mgdt::WalkStart here = mgdt::start_at(mgdt::KeptSpheres(mesh), from.tetrahedron, q, counters);
    if (from.sampled > 0) counters.walk_tests = from.sampled;
    const mgdt::WalkResult found =
        mgdt::walk(mgdt::SerialAccess<mgdt::KeptSpheres>{mesh}, mesh, here, q, counters, no_ghost);
    const std::uint32_t faces = found.start.faces;
    TetId end = found.start.tetrahedron;
    if (faces != 0) end = mesh.tetrahedra[end].n[mgdt::lowest_bit(faces)] >> 2;
    return {end, counters.walk_steps, counters.walk_tests + counters.exact_calls};
}

// The same descent as far as it goes: as the library locates points.
inline Path power_to_base(const Mesh& mesh, Start from, const Query& q) {
    Path path = {0, 1, from.sampled > 0 ? from.sampled : 1};
    if (mesh.tetrahedra[from.tetrahedron].is_ghost()) ++path.steps;
    mgdt::LocationWalk walk = {{q.x, q.y, q.z}, from.tetrahedron, 0, 0, false, false, 0};
    for (mgdt::locate_begin<mgdt::KeptSpheres>(mesh, walk);
         mgdt::locate_step<mgdt::KeptSpheres>(mesh, walk); path.tests += 4)
        ++path.steps;
    path.tests += 4;
    // It is a local minimum, and the tetrahedron itself unless q is off the hull or by rounding.
    mgdt::Counters counters;
    path.end = mgdt::walk_exact(
        mesh, walk.tetrahedron, q.point, counters, [](const Tetrahedron&) { return true; },
        [&](mgdt::VertexId v, double*) { return mesh.point(v); });
    path.steps += counters.walk_steps - 1;
    if (!walk.is_certain) path.tests += counters.exact_calls;
    return path;
}

// How a visibility walk chooses among the faces that have q on their far side.
enum Choice { in_order, at_random, farthest };  // the last: the most negative volume coordinate

// Six times the volume of t with q in the place of a vertex, rounded.
inline double volume(const Mesh& mesh, const Tetrahedron& t, unsigned face, const double* q) {
    double e[3][3];
    for (unsigned i = 1; i < 4; ++i) {
        const double* const p = mesh.point(t.v[(face + i) & 3]);
        for (unsigned k = 0; k < 3; ++k) e[i - 1][k] = p[k] - q[k];
    }
    const double det = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                       e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                       e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
    return det < 0 ? -det : det;
}

// The visibility walk: through a face that separates q from the vertex opposite. The face that it
// came through is remembered and not tested again.
inline Path by_orientation(const Mesh& mesh, Start from, const Query& q, Goal goal, Choice choice,
                           mgdt::Random& random) {
    Path path = {from.tetrahedron, 0, from.sampled};
    for (unsigned entered = 4;;) {
        const Tetrahedron& t = mesh.tetrahedra[path.end];
        ++path.steps;
        if (goal == conflict) {
            ++path.tests;
            if (is_in_conflict(mesh, path.end, q)) return path;
        }
        unsigned through = 4;
        if (t.is_ghost()) {
            const auto slot = static_cast<unsigned>(t.infinite_slot());
            path.tests += slot != entered;
            if (slot != entered && side(mesh, t, slot, q.point) <= 0) through = slot;
        } else {
            const unsigned first = choice == at_random ? random.below(4) : 0;
            double most = -1;
            for (unsigned i = 0; i < 4; ++i) {
                const unsigned face = (first + i) & 3;
                if (face == entered) continue;
                ++path.tests;
                if (side(mesh, t, face, q.point) >= 0) continue;
                const double depth = choice == farthest ? volume(mesh, t, face, q.point) : 0;
                if (depth > most) {
                    most = depth;
                    through = face;
                }
                if (choice != farthest) break;
            }
        }
        if (through == 4) return path;
        const mgdt::FacetCode code = t.n[through];
        path.end = code >> 2;
        entered = code & 3;
    }
}

}  // namespace bench
