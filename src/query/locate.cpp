// SPDX-License-Identifier: MIT
#include "query/locate.hpp"

#include <algorithm>

#include "kernel/walk.hpp"
#include "mesh/scale.hpp"
#include "predicates/barycentric.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {

bool Locator::scale_exactly(const double* q, double* to) const {
    bool is_exact = true;
    for (int k = 0; k < 3; ++k) {
        is_exact = is_exact && (mesh.scale == 0 || scales_exactly(q[k], mesh.scale));
        to[k] = scaled(q[k], mesh.scale);
    }
    return is_exact;
}

TetId Locator::tetrahedron_of(VertexId v) const {
    TetId hint = mesh.live_from(mesh.vertex_hint[v]);
    const VertexId* const corners = mesh.tetrahedra[hint].v;
    if (std::find(corners, corners + 4, v) != corners + 4) return hint;
    double q[3];
    unscaled(v, q);
    return locate(q, hint);
}

void Locator::unscaled(VertexId v, double* to) const {
    for (int k = 0; k < 3; ++k) to[k] = scaled(mesh.vertices[v].x[k], -mesh.scale);
}

TetId Locator::locate(const double* q, TetId& hint, bool may_end_outside) const {
    if (mesh.live_count() == 0) return no_tetrahedron;
    LocationWalk walk;
    walk.may_end_outside = may_end_outside;
    if (begin(q, hint, walk))
        while (step(walk)) {
        }
    return end(q, walk, hint);
}

bool Locator::begin(const double* q, TetId hint, LocationWalk& walk) const {
    walk.is_certain = false;
    walk.steps_taken = 0;
    walk.tetrahedron = hint;
    const bool is_exact = scale_exactly(q, walk.q);
    if (hint == no_tetrahedron)
        walk.tetrahedron = start_of_walk(mesh, tree, no_tetrahedron, walk.q);
    if (!is_exact) return false;
    kernel.locate_begin(mesh, walk);
    return true;
}

TetId Locator::end(const double* q, const LocationWalk& walk, TetId& hint) const {
    hint = walk.tetrahedron;
    if (walk.is_certain) return mesh.tetrahedra[hint].is_ghost() ? no_tetrahedron : hint;
    Counters unused;
    const auto anywhere = [](const Tetrahedron&) { return true; };
    double p[3];
    const bool is_exact = scale_exactly(q, p);
    hint = walk_roughly(mesh, hint, p, unused, anywhere);
    if (is_exact)
        hint = walk_exact(mesh, hint, p, unused, anywhere,
                          [&](VertexId v, double*) { return mesh.point(v); });
    else  // q has no exact coordinates in the mesh's scale: walk on the caller's coordinates
        hint = walk_exact(mesh, hint, q, unused, anywhere, [&](VertexId v, double* room) {
            unscaled(v, room);
            return static_cast<const double*>(room);
        });
    return mesh.tetrahedra[hint].is_ghost() ? no_tetrahedron : hint;
}

void Locator::weights(TetId t, const double* q, double (&w)[4]) const {
    const VertexId* const v = mesh.tetrahedra[t].v;
    double to[3];
    if (scale_exactly(q, to)) {
        barycentric_weights(
            {mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3])}, to, w);
        return;
    }
    double room[4][3];
    for (int i = 0; i < 4; ++i) unscaled(v[i], room[i]);
    barycentric_weights({room[0], room[1], room[2], room[3]}, q, w);
}

}  // namespace mgdt
