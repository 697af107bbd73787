// SPDX-License-Identifier: MIT
// set_sphere() and set_normal() of circumsphere.hpp for as many tetrahedra at a time as a vector
// has doubles. R is the vector's class, as Four of the island avx2.
#pragma once

#include <type_traits>

#include "kernel/circumsphere.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// Points as columns of coordinates.
template <class R>
struct PointColumns {
    typename R::Vector x, y, z;
};

// w and e of spheres as columns.
template <class R>
struct SphereColumns {
    typename R::Vector x, y, z, e;
};

// Vertices relative to the base vertex, with what LocalVertex has.
template <class R>
struct LocalColumns : PointColumns<R> {
    using Vector = typename R::Vector;
    MGDT_ALWAYS_INLINE LocalColumns(const PointColumns<R>& v, Vector s, Vector l)
        : PointColumns<R>(v), square(s), largest(l) {}
    MGDT_ALWAYS_INLINE explicit LocalColumns(const PointColumns<R>& v) : PointColumns<R>(v) {
        square = R::multiply_add(v.z, v.z, R::multiply_add(v.y, v.y, R::multiply(v.x, v.x)));
        largest = R::larger(R::magnitude(v.x), R::larger(R::magnitude(v.y), R::magnitude(v.z)));
    }
    // The vertex at infinity, as spheres_through() wants it.
    MGDT_ALWAYS_INLINE LocalColumns infinite_where(typename R::Mask mask) const {
        return {{R::zero_where(mask, this->x), R::zero_where(mask, this->y),
                 R::zero_where(mask, this->z)},
                R::where(mask, R::all(1.0), square),
                R::zero_where(mask, largest)};
    }
    Vector square, largest;
};

// Where there are no ghosts, and none are looked for.
struct NoGhosts {};

// The spheres through the base vertex and three others; with what rounding adds if they are to be
// kept, as upper halves. Where one of the three is the vertex at infinity, with coordinates of 0
// and a square of 1, and the determinant is taken for 1, the same formulas give the normal of the
// ghost's facet, with twice the bound that it wants.
template <bool to_keep, class R, class Ghosts = NoGhosts>
MGDT_ALWAYS_INLINE SphereColumns<R> spheres_through(const LocalColumns<R>& a,
                                                    const LocalColumns<R>& b,
                                                    const LocalColumns<R>& c, Ghosts ghosts = {}) {
    constexpr bool has_ghosts = !std::is_same_v<Ghosts, NoGhosts>;
    using Vector = typename R::Vector;
    const auto minor = [](Vector p, Vector q, Vector r, Vector s) {
        return R::multiply_subtract(p, q, R::multiply(r, s));
    };
    const auto dot = [](Vector p, Vector q, Vector r, Vector s, Vector t, Vector u) {
        return R::multiply_add(t, u, R::multiply_add(r, s, R::multiply(p, q)));
    };
    const Vector bcx = minor(b.y, c.z, b.z, c.y), bcy = minor(b.z, c.x, b.x, c.z),
                 bcz = minor(b.x, c.y, b.y, c.x);
    const Vector cax = minor(c.y, a.z, c.z, a.y), cay = minor(c.z, a.x, c.x, a.z),
                 caz = minor(c.x, a.y, c.y, a.x);
    const Vector abx = minor(a.y, b.z, a.z, b.y), aby = minor(a.z, b.x, a.x, b.z),
                 abz = minor(a.x, b.y, a.y, b.x);
    Vector det = dot(a.x, bcx, a.y, bcy, a.z, bcz);
    if constexpr (has_ghosts) det = R::where(ghosts, R::all(1.0), det);
    const Vector inverse = R::divide(R::all(1.0), det);
    SphereColumns<R> s;
    s.x = R::multiply(inverse, dot(a.square, bcx, b.square, cax, c.square, abx));
    s.y = R::multiply(inverse, dot(a.square, bcy, b.square, cay, c.square, aby));
    s.z = R::multiply(inverse, dot(a.square, bcz, b.square, caz, c.square, abz));

    const Vector lbc = R::multiply(b.largest, c.largest), lca = R::multiply(c.largest, a.largest),
                 lab = R::multiply(a.largest, b.largest);
    const Vector sum = dot(a.square, lbc, b.square, lca, c.square, lab);
    const Vector product =
        R::multiply(R::all(proved_bounds.sphere_det * unit_roundoff), R::multiply(a.largest, lbc));
    const Vector largest =
        R::larger(R::magnitude(s.x), R::larger(R::magnitude(s.y), R::magnitude(s.z)));
    const Vector numerator = R::multiply_add(
        product, largest, R::multiply(R::all(proved_bounds.sphere_sum * unit_roundoff), sum));
    if constexpr (to_keep) {
        s.e = R::multiply_add(inverse, numerator, R::multiply(largest, R::all(kept_roundoff)));
        s.x = R::to_upper_half(s.x);
        s.y = R::to_upper_half(s.y);
        s.z = R::to_upper_half(s.z);
    } else {
        s.e = R::multiply(inverse, numerator);
    }
    s.e = R::where(R::above(det, product), s.e, R::all(infinity));
    if constexpr (has_ghosts) s.e = R::where(ghosts, R::multiply(R::all(-1.0), s.e), s.e);
    return s;
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
