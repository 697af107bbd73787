// SPDX-License-Identifier: MIT
#include "recovery/crossings.hpp"

namespace mgdt {

int Crossings::of_edge(std::uint32_t u, std::uint32_t v) const noexcept {
    if (a_ == no_index) return 0;
    const double *const a = point(a_), *const b = point(b_), *const p = point(u),
                        *const q = point(v);
    if (c_ == no_index) {
        if ((u == a_ && v == b_) || (u == b_ && v == a_)) return found;
        if (is_corner(u) || is_corner(v)) return 0;
        return orientation(a, b, p, q) == 0 && side_of_edge(a, b, p, q) < 0 &&
               side_of_edge(p, q, a, b) < 0;
    }
    if (is_corner(u) || is_corner(v)) return 0;
    const double* const c = point(c_);
    const int above = orientation(a, b, c, p);
    if (above == 0 || orientation(a, b, c, q) != -above) return 0;
    const int side = orientation(p, q, a, b);
    return side != 0 && orientation(p, q, b, c) == side && orientation(p, q, c, a) == side;
}

int Crossings::of_face(std::uint32_t u, std::uint32_t v, std::uint32_t w) const noexcept {
    if (a_ == no_index || c_ != no_index || is_corner(u) || is_corner(v) || is_corner(w)) return 0;
    const double *const a = point(a_), *const b = point(b_), *const p = point(u),
                        *const q = point(v), *const r = point(w);
    const int side = orientation(a, b, p, q);
    if (side == 0 || orientation(a, b, q, r) != side || orientation(a, b, r, p) != side) return 0;
    const int at_a = orientation(p, q, r, a);
    return at_a != 0 && orientation(p, q, r, b) == -at_a;
}

}  // namespace mgdt
