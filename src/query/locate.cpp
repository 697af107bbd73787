// SPDX-License-Identifier: MIT
#include "query/locate.hpp"

#include "kernel/walk.hpp"
#include "mesh/scale.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {

bool Locator::scale_exactly(const double* q, double* to) const {
    for (int k = 0; k < 3; ++k) {
        if (mesh.scale != 0 && !scales_exactly(q[k], mesh.scale)) return false;
        to[k] = mesh.scale == 0 ? q[k] : scaled(q[k], mesh.scale);
    }
    return true;
}

void Locator::unscaled(VertexId v, double* to) const {
    for (int k = 0; k < 3; ++k) to[k] = scaled(mesh.vertices[v].x[k], -mesh.scale);
}

TetId Locator::locate(const double* q, TetId& hint) const {
    if (mesh.live_count() == 0) return no_tetrahedron;
    LocationWalk walk;
    if (begin(q, hint, walk))
        while (kernel.locate_step(mesh, walk)) {
        }
    return end(q, walk, hint);
}

bool Locator::begin(const double* q, TetId hint, LocationWalk& walk) const {
    walk.is_certain = false;
    walk.tetrahedron = hint;
    if (!scale_exactly(q, walk.q)) {
        if (hint == no_tetrahedron) walk.tetrahedron = mesh.live_from(0);
        return false;
    }
    if (hint == no_tetrahedron)
        walk.tetrahedron = start_of_walk(mesh, tree, no_tetrahedron, walk.q);
    kernel.locate_begin(mesh, walk);
    return true;
}

TetId Locator::end(const double* q, const LocationWalk& walk, TetId& hint) const {
    hint = walk.tetrahedron;
    if (walk.is_certain) return hint;
    Counters unused;
    const auto anywhere = [](const Tetrahedron&) { return true; };
    double p[3];
    if (scale_exactly(q, p))
        hint = walk_exact(mesh, hint, p, unused, anywhere,
                          [&](VertexId v, double*) { return mesh.point(v); });
    else  // it has no exact scaled place: walk on the caller's coordinates
        hint = walk_exact(mesh, hint, q, unused, anywhere, [&](VertexId v, double* room) {
            unscaled(v, room);
            return static_cast<const double*>(room);
        });
    return mesh.tetrahedra[hint].is_ghost() ? no_tetrahedron : hint;
}

void Locator::weights(TetId t, const double* q, double w[4]) const {
    // Volumes of the tetrahedra in which q replaces a vertex, relative to a base near q so that
    // large offsets cancel first. Halves keep differences of huge coordinates finite.
    double d[4][3];
    for (int i = 0; i < 4; ++i) {
        double p[3];
        unscaled(mesh.tetrahedra[t].v[i], p);
        for (int k = 0; k < 3; ++k) d[i][k] = p[k] * 0.5 - q[k] * 0.5;
    }
    double largest = 0;
    for (const auto& row : d) largest = std::fmax(largest, max_magnitude(row[0], row[1], row[2]));
    if (largest > 0) {
        int exponent;
        std::frexp(largest, &exponent);
        for (auto& row : d)
            for (double& x : row) x = scaled(x, -exponent);
    }
    const auto volume = [&](int a, int b, int c) {
        return d[a][0] * (d[b][1] * d[c][2] - d[b][2] * d[c][1]) +
               d[a][1] * (d[b][2] * d[c][0] - d[b][0] * d[c][2]) +
               d[a][2] * (d[b][0] * d[c][1] - d[b][1] * d[c][0]);
    };
    w[0] = volume(1, 2, 3);
    w[1] = volume(0, 3, 2);
    w[2] = volume(0, 1, 3);
    w[3] = volume(0, 2, 1);
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
        if (!(w[i] > 0)) w[i] = 0;  // q is in the closed tetrahedron: negatives are rounding
        sum += w[i];
    }
    if (sum > 0) {
        for (int i = 0; i < 4; ++i) w[i] /= sum;
    } else {
        // Too flat for its volume to be a double: the nearest vertex.
        int nearest = 0;
        double least = infinity;
        for (int i = 0; i < 4; ++i) {
            const double square = d[i][0] * d[i][0] + d[i][1] * d[i][1] + d[i][2] * d[i][2];
            if (square < least) {
                least = square;
                nearest = i;
            }
        }
        w[nearest] = 1;
    }
}

}  // namespace mgdt
