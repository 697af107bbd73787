// SPDX-License-Identifier: MIT
#include "domain/missing_segment.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/star_traversal.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

bool is_corner_of(const Mesh& mesh, TetId t, VertexId v) {
    if (t >= mesh.tetrahedra.size() || mesh.tetrahedra[t].is_dead()) return false;
    const VertexId* const corners = mesh.tetrahedra[t].v;
    return std::find(corners, corners + 4, v) != corners + 4;
}

}  // namespace

MissingSegment::MissingSegment(const Triangulation& triangulation, Allocator& allocator)
    : triangulation_(triangulation),
      mesh_(triangulation.mesh()),
      where_{mesh_, triangulation.calls(), nullptr},
      star_(allocator),
      around_(allocator) {}

bool MissingSegment::find(std::uint32_t point_a, std::uint32_t point_b, TetId at_a) {
    const VertexId a = triangulation_.point_map()[point_a], b = triangulation_.point_map()[point_b];
    star_.clear();
    star_.push(is_corner_of(mesh_, at_a, a) ? at_a : where_.tetrahedron_of(a));
    bool is_edge = false;
    traverse_star(mesh_, a, star_, [&](FacetCode facet) {
        const Tetrahedron& t = mesh_.tetrahedra[tetrahedron_of(facet)];
        for (const VertexId v : t.v) is_edge = is_edge || v == b;
        if (!is_edge) star_.push(tetrahedron_of(facet));
    });
    if (is_edge) return false;
    const double *const pa = vertex(a), *const pb = vertex(b);
    around_.clear();
    for (std::size_t i = 0; i < star_.size(); ++i) {
        const Tetrahedron& t = mesh_.tetrahedra[star_[i]];
        if (t.is_ghost()) continue;
        for (unsigned face = 0; face < 4; ++face)
            if (t.v[face] == a && meets(t, face, pa, pb)) around_.push(star_[i]);
    }
    reference_ = no_index;
    least_cosine_ = 0;
    for (std::size_t i = 0; i < around_.size(); ++i) {
        const Tetrahedron& t = mesh_.tetrahedra[around_[i]];
        for (unsigned face = 0; face < 4; ++face) {
            consider(t.v[face], a, b);
            const TetId next = tetrahedron_of(t.n[face]);
            if (!mesh_.tetrahedra[next].is_ghost() && meets(t, face, pa, pb)) around_.push(next);
        }
    }
    assert(reference_ != no_index && "a missing segment meets no tetrahedra");
    return true;
}

// Whether the segment meets a face or its boundary in a point other than the ends of the segment.
// If the segment runs in the plane of the face, the answer is no: the segment then meets edges of
// this face that are edges of other faces as well.
bool MissingSegment::meets(const Tetrahedron& t, unsigned face, const double* a,
                           const double* b) const {
    const unsigned char* const f = outer_face[face];
    const double *const p = vertex(t.v[f[0]]), *const q = vertex(t.v[f[1]]),
                        *const r = vertex(t.v[f[2]]);
    const int at_a = orientation(p, q, r, a), at_b = orientation(p, q, r, b);
    if (at_a * at_b >= 0) return false;
    const int pq = orientation(a, b, p, q), qr = orientation(a, b, q, r),
              rp = orientation(a, b, r, p);
    return (pq >= 0 && qr >= 0 && rp >= 0) || (pq <= 0 && qr <= 0 && rp <= 0);
}

void MissingSegment::consider(VertexId v, VertexId a, VertexId b) {
    if (v == a || v == b) return;
    const double *const p = vertex(v), *const pa = vertex(a), *const pb = vertex(b);
    double dot = 0, to_a = 0, to_b = 0;
    for (int k = 0; k < 3; ++k) {
        const double da = pa[k] - p[k], db = pb[k] - p[k];
        dot += da * db;
        to_a += da * da;
        to_b += db * db;
    }
    const double cosine = dot / std::sqrt(to_a * to_b);
    const std::uint32_t point = mesh_.vertices[v].index;
    if (reference_ == no_index || cosine < least_cosine_ ||
        (cosine == least_cosine_ && point < reference_)) {
        reference_ = point;
        least_cosine_ = cosine;
    }
}

}  // namespace mgdt
