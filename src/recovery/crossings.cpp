// SPDX-License-Identifier: MIT
#include "recovery/crossings.hpp"

namespace mgdt {

int Crossings::of_edge(std::uint32_t u, std::uint32_t v) const noexcept {
    if (a_ == no_index) return 0;
    const double *const a = point(a_), *const b = point(b_), *const p = point(u),
                        *const q = point(v);
    if (c_ == no_index) {
        if ((u == a_ && v == b_) || (u == b_ && v == a_)) return found;
        if (is_corner(u) || is_corner(v) || box_.has_beside(p, q)) return 0;
        return orientation(a, b, p, q) == 0 && side_of_edge(a, b, p, q) < 0 &&
               side_of_edge(p, q, a, b) < 0;
    }
    if (is_corner(u) || is_corner(v) || box_.has_beside(p, q)) return 0;
    const double* const c = point(c_);
    const int above = orientation(a, b, c, p);
    if (above == 0 || orientation(a, b, c, q) != -above) return 0;
    const int side = orientation(p, q, a, b);
    return side != 0 && orientation(p, q, b, c) == side && orientation(p, q, c, a) == side;
}

int Crossings::of_face(std::uint32_t u, std::uint32_t v, std::uint32_t w) const noexcept {
    if (!count_faces() || box_.has_beside(point(u), point(v), point(w))) return 0;
    const int of_u = side(u, v);
    return of_u != 0 && side(v, w) == of_u && side(w, u) == of_u ? of_plane(u, v, w) : 0;
}

int Crossings::of_faces(std::uint32_t p, std::uint32_t q,
                        const Buffer<std::uint32_t>& vertices) const {
    const int of_pq = count_faces() ? side(p, q) : 0;
    int sum = 0;
    if (of_pq == 0) return sum;
    for (const std::uint32_t v : vertices)
        if (!box_.has_beside(point(p), point(q), point(v)) && side(q, v) == of_pq &&
            side(v, p) == of_pq)
            sum += of_plane(p, q, v);
    return sum;
}

int Crossings::of_plane(std::uint32_t u, std::uint32_t v, std::uint32_t w) const noexcept {
    const double *const p = point(u), *const q = point(v), *const r = point(w);
    const int at_a = orientation(p, q, r, point(a_));
    return at_a != 0 && orientation(p, q, r, point(b_)) == -at_a ? 1 : 0;
}

}  // namespace mgdt
