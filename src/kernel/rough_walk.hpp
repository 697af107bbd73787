// SPDX-License-Identifier: MIT
// The rough walk: a visibility walk by orientations in plain doubles, without error bounds. It
// covers the distance where powers do not show the way: among tetrahedra of one sphere, and where
// coordinates are outside the normal range. Its result is only a better start for the exact walk,
// which confirms a right result in one step.
#pragma once

#include "kernel/island.hpp"
#include "kernel/workspace.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// Divides the differences of each axis by the largest one, because their products could overflow. A
// positive factor per axis does not change the sign of an orientation.
inline void divide_by_largest(double d[4][3]) {
    for (unsigned k = 0; k < 3; ++k) {
        double largest = 0;
        for (unsigned i = 0; i < 4; ++i) {
            const double size = std::fabs(d[i][k]);
            largest = size > largest ? size : largest;
        }
        if (largest == 0) continue;
        for (unsigned i = 0; i < 4; ++i) d[i][k] /= largest;
    }
}

// The faces of a finite tetrahedron that q is beyond, as a bit mask. d has its vertices relative to
// q.
inline std::uint32_t faces_between(const double d[4][3]) {
    const auto cross = [](const double* a, const double* b, double* c) {
        c[0] = a[1] * b[2] - a[2] * b[1];
        c[1] = a[2] * b[0] - a[0] * b[2];
        c[2] = a[0] * b[1] - a[1] * b[0];
    };
    const auto dot = [](const double* a, const double* b) {
        return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    };
    double first[3], last[3];
    cross(d[0], d[1], first);
    cross(d[2], d[3], last);
    return static_cast<std::uint32_t>(dot(d[1], last) < 0) |
           static_cast<std::uint32_t>(dot(d[0], last) > 0) << 1 |
           static_cast<std::uint32_t>(dot(d[3], first) < 0) << 2 |
           static_cast<std::uint32_t>(dot(d[2], first) > 0) << 3;
}

// Walks from a tetrahedron to one that seems to contain q, or to a ghost that q seems to be beyond,
// or as far as tetrahedra may be entered. With rounding errors a walk may cycle; it ends when it
// returns to a tetrahedron.
template <class TryOwn>
MGDT_NOT_INLINE TetId walk_roughly(const Mesh& mesh, TetId t, const double* q, Counters& counters,
                                   TryOwn try_own) {
    // If some coordinates are extreme, all are halved, so that differences of huge coordinates do
    // not overflow.
    const double factor = mesh.has_extremes ? 0.5 : 1;
    unsigned from = 4;              // the face that the walk came through
    TetId before = no_tetrahedron;  // the tetrahedron at the last step that is a power of two
    for (std::uint64_t step = 0;; ++step) {
        if (t == before) return t;
        if ((step & (step - 1)) == 0) before = t;
        const Tetrahedron& here = mesh.tetrahedra[t];
        FacetCode next;
        if (here.is_ghost()) {
            if (step > 0) return t;
            next = here.n[here.infinite_slot()];
        } else {
            double d[4][3];
            for (unsigned i = 0; i < 4; ++i)
                for (unsigned k = 0; k < 3; ++k)
                    d[i][k] = mesh.point(here.v[i])[k] * factor - q[k] * factor;
            if (MGDT_UNLIKELY(mesh.has_extremes)) divide_by_largest(d);
            std::uint32_t faces = faces_between(d);
            if (from < 4) faces &= ~(1u << from);
            if (faces == 0) return t;
            next = here.n[lowest_bit(faces)];
        }
        if (!try_own(mesh.tetrahedra[tetrahedron_of(next)])) return t;
        ++counters.walk_steps;
        t = tetrahedron_of(next);
        from = face_of(next);
    }
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
