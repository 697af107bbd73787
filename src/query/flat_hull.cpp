// SPDX-License-Identifier: MIT
#include "query/flat_hull.hpp"

#include <algorithm>

#include "predicates/predicates.hpp"

namespace mgdt {

FlatHull::FlatHull(const Mesh& mesh, Allocator& allocator) : mesh_(mesh), memory_(allocator) {
    for (VertexId v = 1; v < mesh.vertices.size(); ++v) {
        const double* const p = mesh.point(v);
        if (dimension_ < 0) {
            dimension_ = 0;
            span_[0] = ends_[0] = ends_[1] = p;
            continue;
        }
        if (compare_lexicographic(p, ends_[0]) < 0) ends_[0] = p;
        if (compare_lexicographic(p, ends_[1]) > 0) ends_[1] = p;
        if (dimension_ == 0) {
            dimension_ = 1;
            span_[1] = p;
        } else if (dimension_ == 1 && !collinear(span_[0], span_[1], p)) {
            dimension_ = 2;
            span_[2] = p;
        }
    }
    if (dimension_ == 2)
        while (turn(span_[0], span_[1], span_[2]) == 0) ++axis_;
}

int FlatHull::turn(const double* p, const double* q, const double* r) {
    const int i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
    memory_.release(0);
    const auto difference = [&](const double* from, const double* to, int k) {
        return memory_.number(to[k]) - memory_.number(from[k]);
    };
    return (difference(p, q, i) * difference(p, r, j) - difference(p, q, j) * difference(p, r, i))
        .sign();
}

bool FlatHull::is_between(const double* p, const double* q, const double* r) const {
    // Along a line, points are in lexicographic order.
    return compare_lexicographic(p, q) * compare_lexicographic(q, r) >= 0;
}

bool FlatHull::contains(const double* q) {
    if (dimension_ < 0) return false;
    if (dimension_ == 0) return std::equal(q, q + 3, span_[0]);
    if (dimension_ == 1)
        return collinear(span_[0], span_[1], q) && is_between(ends_[0], q, ends_[1]);
    if (orientation(span_[0], span_[1], span_[2], q) != 0) return false;
    // As seen from q, all vertices so far lie in the angle from `right` to `left`, which is less
    // than 180 degrees. If a vertex leaves no such angle, q is in the hull.
    const double *right = nullptr, *left = nullptr;
    for (VertexId v = 1; v < mesh_.vertices.size(); ++v) {
        const double* const p = mesh_.point(v);
        if (std::equal(q, q + 3, p)) return true;
        if (!right) {
            right = left = p;
            continue;
        }
        const int from_right = turn(q, right, p), to_left = turn(q, p, left);
        if ((from_right == 0 && is_between(right, q, p)) ||
            (to_left == 0 && is_between(left, q, p)))
            return true;
        if (from_right >= 0 && to_left >= 0) continue;
        // p is to the right of `right` and to the left of `left`, so the three vertices surround q.
        if (from_right < 0 && to_left < 0) return true;
        (from_right < 0 ? right : left) = p;
    }
    return false;
}

}  // namespace mgdt
