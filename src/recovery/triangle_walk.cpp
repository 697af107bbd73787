// SPDX-License-Identifier: MIT
#include "recovery/triangle_walk.hpp"

#include <algorithm>

#include "platform/error.hpp"
#include "platform/take_out_repeats.hpp"
#include "predicates/predicates.hpp"
#include "recovery/crossings.hpp"

namespace mgdt {

TriangleWalk::Result TriangleWalk::run(const std::uint32_t (&v)[3]) {
    edges_.clear();
    tetrahedra_.clear();
    stamps_.grow(mesh_.tetrahedra.size());
    stamps_.resize(mesh_.tetrahedra.size(), 0u);
    ++walk_;
    const Result begun = begin(v);
    if (begun != Result::crosses) return begun;
    const Crossings crossings = Crossings::of_triangle(mesh_, v);
    for (std::size_t i = 0; i < tetrahedra_.size(); ++i) {
        const FlipMesh::Tetrahedron t = mesh_.tetrahedra[tetrahedra_[i]];
        for (unsigned k = 0; k < 4; ++k)
            if (is_inside(v, t.v[k])) {
                vertex_ = t.v[k];
                return Result::meets;
            }
        for (unsigned k = 0; k < 4; ++k)
            for (unsigned l = k + 1; l < 4; ++l) {
                if (crossings.of_edge(t.v[k], t.v[l]) == 0) continue;
                edges_.push_back({std::min(t.v[k], t.v[l]), std::max(t.v[k], t.v[l])});
                for (unsigned m = 0; m < 4; ++m)
                    if (m != k && m != l && t.n[m] != no_index) enter(t.n[m] / 4);
            }
    }
    take_out_repeats(edges_);
    return Result::crosses;
}

void TriangleWalk::enter(std::uint32_t t) {
    if (stamps_[t] == walk_) return;
    stamps_[t] = walk_;
    tetrahedra_.push_back(t);
}

// Whether a vertex that is no corner is on the triangle.
bool TriangleWalk::is_inside(const std::uint32_t (&v)[3], std::uint32_t w) const noexcept {
    if (w == v[0] || w == v[1] || w == v[2]) return false;
    const double *const a = mesh_.point(v[0]), *const b = mesh_.point(v[1]),
                        *const c = mesh_.point(v[2]), *const p = mesh_.point(w);
    return orientation(a, b, c, p) == 0 && side_of_edge(a, b, c, p) >= 0 &&
           side_of_edge(b, c, a, p) >= 0 && side_of_edge(c, a, b, p) >= 0;
}

// Enters the tetrahedron at the edge from v[0] to v[1] that the triangle meets.
TriangleWalk::Result TriangleWalk::begin(const std::uint32_t (&v)[3]) {
    const double *const a = mesh_.point(v[0]), *const b = mesh_.point(v[1]),
                        *const c = mesh_.point(v[2]);
    const std::uint32_t first = mesh_.tetrahedron_towards(v[0], v[1]);
    if (first == no_tetrahedron || !mesh_.tetrahedra[first].has(v[1]))
        fail(MGDT_ERR_INTERNAL, "a side of a facet is no edge");
    std::uint32_t t = first;
    do {
        const FlipMesh::Tetrahedron& tet = mesh_.tetrahedra[t];
        unsigned k = 0;
        while (tet.v[k] == v[0] || tet.v[k] == v[1]) ++k;
        unsigned l = k + 1;
        while (tet.v[l] == v[0] || tet.v[l] == v[1]) ++l;
        // (v0, v1, r, s) is positive.
        if (orientation(a, b, mesh_.point(tet.v[k]), mesh_.point(tet.v[l])) < 0) std::swap(k, l);
        const int at_r = orientation(a, b, mesh_.point(tet.v[k]), c),
                  at_s = orientation(a, b, c, mesh_.point(tet.v[l]));
        if (at_r == 0 && at_s > 0) {
            face_ = 4 * t + l;
            vertex_ = tet.v[k];
            return vertex_ == v[2] ? Result::is_face : Result::meets;
        }
        if (at_r > 0 && at_s > 0) {
            enter(t);
            return Result::crosses;
        }
        if (tet.n[k] == no_index) break;
        t = tet.n[k] / 4;
    } while (t != first);
    fail(MGDT_ERR_INTERNAL, "a facet leaves the mesh");
}

}  // namespace mgdt
