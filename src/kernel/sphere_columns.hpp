// SPDX-License-Identifier: MIT
// set_sphere() and set_normal() of circumsphere.hpp for several tetrahedra at a time, one for each
// double of a vector. R is the type of the vector, such as Four of the island avx2.
#pragma once

#include <type_traits>

#include "kernel/circumsphere.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// Points as columns of coordinates.
template <class R>
struct PointColumns {
    R x, y, z;
};

// Spheres as columns: the coordinates of w, and e.
template <class R>
struct SphereColumns {
    R x, y, z, e;
};

// Vertices relative to the base vertex, with the members of LocalVertex as columns.
template <class R>
struct LocalColumns : PointColumns<R> {
    MGDT_ALWAYS_INLINE LocalColumns(const PointColumns<R>& v, R s, R l)
        : PointColumns<R>(v), square(s), largest(l) {}
    MGDT_ALWAYS_INLINE explicit LocalColumns(const PointColumns<R>& v) : PointColumns<R>(v) {
        square = multiply_add(v.z, v.z, multiply_add(v.y, v.y, v.x * v.x));
        largest = larger(magnitude(v.x), larger(magnitude(v.y), magnitude(v.z)));
    }
    // Replaces vertices by the vertex at infinity where the mask is set, as spheres_through()
    // expects.
    MGDT_ALWAYS_INLINE LocalColumns infinite_where(typename R::Mask mask) const {
        return {{zero_where(mask, this->x), zero_where(mask, this->y), zero_where(mask, this->z)},
                where(mask, R(1.0), square),
                zero_where(mask, largest)};
    }
    R square, largest;
};

// The argument of spheres_through() if no tetrahedron is a ghost.
struct NoGhosts {};

// The spheres through the base vertex and three others. If the spheres are to be kept, they are
// rounded to upper halves, and their bounds include the rounding error. If one of the three is the
// vertex at infinity, it has coordinates of 0 and a square of 1, and the determinant is replaced by
// 1. Then the same formulas compute the normal of the ghost's facet, with twice the bound that
// set_normal() computes.
template <bool to_keep, class R, class Ghosts = NoGhosts>
MGDT_ALWAYS_INLINE SphereColumns<R> spheres_through(const LocalColumns<R>& a,
                                                    const LocalColumns<R>& b,
                                                    const LocalColumns<R>& c, Ghosts ghosts = {}) {
    constexpr bool has_ghosts = !std::is_same_v<Ghosts, NoGhosts>;
    const auto minor = [](R p, R q, R r, R s) { return multiply_subtract(p, q, r * s); };
    const auto dot = [](R p, R q, R r, R s, R t, R u) {
        return multiply_add(t, u, multiply_add(r, s, p * q));
    };
    const R bcx = minor(b.y, c.z, b.z, c.y), bcy = minor(b.z, c.x, b.x, c.z),
            bcz = minor(b.x, c.y, b.y, c.x);
    const R cax = minor(c.y, a.z, c.z, a.y), cay = minor(c.z, a.x, c.x, a.z),
            caz = minor(c.x, a.y, c.y, a.x);
    const R abx = minor(a.y, b.z, a.z, b.y), aby = minor(a.z, b.x, a.x, b.z),
            abz = minor(a.x, b.y, a.y, b.x);
    R det = dot(a.x, bcx, a.y, bcy, a.z, bcz);
    if constexpr (has_ghosts) det = where(ghosts, R(1.0), det);
    const R inverse = R(1.0) / det;
    SphereColumns<R> s;
    s.x = inverse * dot(a.square, bcx, b.square, cax, c.square, abx);
    s.y = inverse * dot(a.square, bcy, b.square, cay, c.square, aby);
    s.z = inverse * dot(a.square, bcz, b.square, caz, c.square, abz);

    const R lbc = b.largest * c.largest, lca = c.largest * a.largest, lab = a.largest * b.largest;
    const R sum = dot(a.square, lbc, b.square, lca, c.square, lab);
    const R product = R(proved_bounds.sphere_det * unit_roundoff) * (a.largest * lbc);
    const R largest = larger(magnitude(s.x), larger(magnitude(s.y), magnitude(s.z)));
    const R numerator =
        multiply_add(product, largest, R(proved_bounds.sphere_sum * unit_roundoff) * sum);
    if constexpr (to_keep) {
        s.e = multiply_add(inverse, numerator, largest * R(kept_roundoff));
        s.x = to_upper_half(s.x);
        s.y = to_upper_half(s.y);
        s.z = to_upper_half(s.z);
    } else {
        s.e = inverse * numerator;
    }
    s.e = where(det > product, s.e, R(infinity));
    if constexpr (has_ghosts) s.e = where(ghosts, R(-1.0) * s.e, s.e);
    return s;
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
