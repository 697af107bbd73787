// SPDX-License-Identifier: MIT
#include "recovery/crossing_walk.hpp"

#include <algorithm>

#include "platform/error.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {

// How u and v turn around the segment: positive if they appear counter-clockwise from b.
int CrossingWalk::turn(std::uint32_t u, std::uint32_t v) const noexcept {
    return orientation(mesh_.point(a_), mesh_.point(b_), mesh_.point(u), mesh_.point(v));
}

CrossingWalk::Step CrossingWalk::cross_edge(std::uint32_t t, std::uint32_t u, std::uint32_t v) {
    crossings_.push_back({t, {u, v, no_index}});
    return Step::goes_on;
}

// The corners are in the order in which each turns to the next.
CrossingWalk::Step CrossingWalk::cross_face(std::uint32_t t, std::uint32_t u, std::uint32_t v,
                                            std::uint32_t w) {
    crossings_.push_back({t, {u, v, w}});
    return Step::goes_on;
}

CrossingWalk::Step CrossingWalk::meet(std::uint32_t v) {
    vertex_ = v;
    return v == b_ ? Step::ends : Step::meets;
}

CrossingWalk::Result CrossingWalk::run(std::uint32_t a, std::uint32_t b) {
    a_ = a;
    b_ = b;
    crossings_.clear();
    const std::uint32_t start = mesh_.tetrahedron_towards(a, b);
    if (start == no_tetrahedron) fail(MGDT_ERR_INTERNAL, "a segment leaves no tetrahedron");
    if (mesh_.tetrahedra[start].has(b)) return Result::is_edge;
    Step step = leave_start(start);
    while (step == Step::goes_on) {
        const Crossing from = crossings_.back();
        step = from.is_edge() ? leave_edge(from) : leave_face(from);
    }
    return step == Step::ends ? Result::crosses : Result::meets;
}

// Leaves the tetrahedron of a in which the segment begins.
CrossingWalk::Step CrossingWalk::leave_start(std::uint32_t t) {
    const FlipMesh::Tetrahedron& tet = mesh_.tetrahedra[t];
    const unsigned char* const f = outer_face[tet.position(a_)];
    // (a, v0, v1, v2) is positive.
    const std::uint32_t v[3] = {tet.v[f[0]], tet.v[f[2]], tet.v[f[1]]};
    int turns[3];
    for (int k = 0; k < 3; ++k) turns[k] = turn(v[k], v[(k + 1) % 3]);
    for (int k = 0; k < 3; ++k)
        if (turns[k] == 0 && turns[(k + 1) % 3] == 0) return meet(v[(k + 1) % 3]);
    for (int k = 0; k < 3; ++k)
        if (turns[k] == 0) return cross_edge(t, v[k], v[(k + 1) % 3]);
    return cross_face(t, v[0], v[1], v[2]);
}

CrossingWalk::Step CrossingWalk::leave_face(const Crossing& from) {
    const FlipMesh::Tetrahedron& tet = mesh_.tetrahedra[from.tetrahedron];
    const std::uint32_t* const v = from.v;
    unsigned at = 0;
    while (std::find(v, v + 3, tet.v[at]) != v + 3) ++at;
    const std::uint32_t code = tet.n[at];
    if (code == no_index) fail(MGDT_ERR_INTERNAL, "a segment leaves the mesh");
    const std::uint32_t t = code / 4, d = mesh_.apex(code);
    if (d == b_) return meet(d);
    const int turns[3] = {turn(d, v[0]), turn(d, v[1]), turn(d, v[2])};
    // Seen along the segment, d is beside the point where the segment crosses the face. The segment
    // leaves through the tetrahedron's face at d and at the opposite side of that face.
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        if (turns[k] < 0 || turns[next] > 0) continue;
        if (turns[k] == 0 && turns[next] == 0) return meet(d);
        if (turns[k] == 0) return cross_edge(t, d, v[k]);
        if (turns[next] == 0) return cross_edge(t, d, v[next]);
        return cross_face(t, d, v[k], v[next]);
    }
    fail(MGDT_ERR_INTERNAL, "a segment leaves no side of a face");
}

CrossingWalk::Step CrossingWalk::leave_edge(const Crossing& from) {
    const std::uint32_t u = from.v[0], v = from.v[1];
    const double *const pu = mesh_.point(u), *const pv = mesh_.point(v),
                        *const pb = mesh_.point(b_);
    std::uint32_t t = from.tetrahedron, behind = no_index;
    do {
        const FlipMesh::Tetrahedron& tet = mesh_.tetrahedra[t];
        unsigned k = 0;
        while (tet.v[k] == u || tet.v[k] == v) ++k;
        unsigned l = k + 1;
        while (tet.v[l] == u || tet.v[l] == v) ++l;
        // (u, v, r, s) is positive.
        if (orientation(pu, pv, mesh_.point(tet.v[k]), mesh_.point(tet.v[l])) < 0) std::swap(k, l);
        const std::uint32_t r = tet.v[k], s = tet.v[l];
        const int at_r = orientation(pu, pv, mesh_.point(r), pb),
                  at_s = orientation(pu, pv, pb, mesh_.point(s));
        if (at_r == 0 && at_s > 0) {
            // The segment runs in the face (u, v, r).
            if (r == b_) return meet(r);
            const int side = side_of_edge(mesh_.point(a_), pb, pu, mesh_.point(r));
            if (side == 0) return meet(r);
            return cross_edge(t, side > 0 ? v : u, r);
        }
        if (at_r > 0 && at_s > 0) {
            const int across = turn(r, s), beside = turn(u, r);
            if (across == 0) return cross_edge(t, r, s);
            const std::uint32_t end = across == beside ? u : v;
            return across > 0 ? cross_face(t, end, r, s) : cross_face(t, end, s, r);
        }
        behind = tet.n[k];
        if (behind == no_index) break;
        t = behind / 4;
    } while (t != from.tetrahedron);
    fail(MGDT_ERR_INTERNAL, "a segment does not go on beyond an edge");
}

// About where a segment crosses a face or an edge.
void find_crossing(const FlipMesh& mesh, std::uint32_t a, std::uint32_t b, const Crossing& c,
                   double (&x)[3]) noexcept {
    const double *const pa = mesh.point(a), *const pb = mesh.point(b),
                        *const p = mesh.point(c.v[0]), *const q = mesh.point(c.v[1]);
    double d[3], e[3], f[3], n[3];
    for (int k = 0; k < 3; ++k) {
        d[k] = pb[k] - pa[k];
        e[k] = q[k] - p[k];
    }
    for (int k = 0; k < 3; ++k) {
        const int l = (k + 1) % 3, m = (k + 2) % 3;
        n[k] = d[l] * e[m] - d[m] * e[l];
    }
    if (c.is_edge()) {
        // The normal of the plane through the edge that is perpendicular to n.
        for (int k = 0; k < 3; ++k) {
            const int l = (k + 1) % 3, m = (k + 2) % 3;
            f[k] = e[l] * n[m] - e[m] * n[l];
        }
    } else {
        double g[3];
        for (int k = 0; k < 3; ++k) g[k] = mesh.point(c.v[2])[k] - p[k];
        for (int k = 0; k < 3; ++k) {
            const int l = (k + 1) % 3, m = (k + 2) % 3;
            f[k] = e[l] * g[m] - e[m] * g[l];
        }
    }
    double along = 0, to = 0;
    for (int k = 0; k < 3; ++k) {
        along += d[k] * f[k];
        to += (p[k] - pa[k]) * f[k];
    }
    const double t = along != 0 ? std::min(std::max(to / along, 0.0), 1.0) : 0.5;
    for (int k = 0; k < 3; ++k) x[k] = pa[k] + t * d[k];
}

}  // namespace mgdt
