// SPDX-License-Identifier: MIT
// The determinants of orientation and of the sphere predicate, over any number type.
#pragma once

#include "predicates/integer.hpp"

namespace mgdt::exact {

// Whether T is a long integer. A sum of products of long integers is computed in a function that is
// not inlined (apart() below), so that the stack holds the intermediate results of one such sum at
// a time; see docs/theory.md.
template <class T>
constexpr bool is_long = false;
template <int Bits>
constexpr bool is_long<Integer<Bits>> = (Bits > 511);

template <class F>
MGDT_PREDICATES_APART auto apart(const F& f) {
    return f();
}

// x u - y v
template <class X, class U>
MGDT_PREDICATES_INLINE auto two_products(const X& x, const U& u, const X& y, const U& v) {
    if constexpr (is_long<X>) {
        return apart([&] { return x * u - y * v; });
    } else {
        return x * u - y * v;
    }
}

// (x u - y v) + z w
template <class X, class U>
MGDT_PREDICATES_INLINE auto three_products(const X& x, const U& u, const X& y, const U& v,
                                           const X& z, const U& w) {
    if constexpr (is_long<X>) {
        return apart([&] { return two_products(x, u, y, v) + z * w; });
    } else {
        return (x * u - y * v) + z * w;
    }
}

// The scalar product of two vectors.
template <class T>
MGDT_PREDICATES_INLINE auto scalar_product(const T* a, const T* b) {
    if constexpr (is_long<T>) {
        return apart([&] { return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]; });
    } else {
        return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2];
    }
}

// Determinant of the rows b - a, c - a, d - a.
struct OrientationDeterminant {
    template <class T>
    MGDT_PREDICATES_INLINE auto operator()(const T (&v)[9]) const {
        return of(v);
    }
    template <class T>
    static MGDT_PREDICATES_INLINE auto of(const T* v) {
        const auto cd = two_products(v[3], v[7], v[6], v[4]);
        const auto bd = two_products(v[0], v[7], v[6], v[1]);
        const auto bc = two_products(v[0], v[4], v[3], v[1]);
        return three_products(v[2], cd, v[5], bd, v[8], bc);
    }
};

// With rows a, b, c, d relative to q, |a|^2 [bcd] - |b|^2 [acd] + |c|^2 [abd] - |d|^2 [abc] is the
// sphere determinant. It is positive if q is inside the circumsphere of a positively oriented
// tetrahedron. The four 3 x 3 minors, with their signs, are also the coefficients of the
// perturbations of a, b, c, d.
template <class Minor>
struct SphereMinors {
    Minor of[4];
};

struct SphereDeterminant {
    template <class T>
    static MGDT_PREDICATES_INLINE auto square(const T* p) {
        return scalar_product(p, p);
    }

    template <class T>
    static MGDT_PREDICATES_INLINE auto minor(const T* p, const T* q) {
        return two_products(p[0], q[1], q[0], p[1]);
    }

    // [bcd], [acd], [abd], [abc]
    template <class T>
    static MGDT_PREDICATES_INLINE auto minors(const T (&v)[12]) {
        const T *a = v, *b = v + 3, *c = v + 6, *d = v + 9;
        const auto ab = minor(a, b);
        const auto ac = minor(a, c);
        const auto ad = minor(a, d);
        const auto bc = minor(b, c);
        const auto bd = minor(b, d);
        const auto cd = minor(c, d);
        using Minor = decltype(three_products(b[2], cd, c[2], bd, d[2], bc));
        return SphereMinors<Minor>{{three_products(b[2], cd, c[2], bd, d[2], bc),
                                    three_products(a[2], cd, c[2], ad, d[2], ac),
                                    three_products(a[2], bd, b[2], ad, d[2], ab),
                                    three_products(a[2], bc, b[2], ac, c[2], ab)}};
    }

    template <class T, class Minor>
    static MGDT_PREDICATES_INLINE auto value(const T (&v)[12], const SphereMinors<Minor>& m) {
        return two_products(square(v), m.of[0], square(v + 3), m.of[1]) +
               two_products(square(v + 6), m.of[2], square(v + 9), m.of[3]);
    }

    template <class T>
    MGDT_PREDICATES_INLINE auto operator()(const T (&v)[12]) const {
        if constexpr (is_long<T>) {
            const auto m = apart([&] { return minors(v); });
            return apart([&] { return value(v, m); });
        } else {
            return value(v, minors(v));
        }
    }
};

// One coordinate of the cross product of two vectors.
template <std::size_t K, class T>
MGDT_PREDICATES_INLINE auto cross_product(const T* a, const T* b) {
    constexpr std::size_t l = (K + 1) % 3, m = (K + 2) % 3;
    return two_products(a[l], b[m], a[m], b[l]);
}

// Coordinate K of |b|^2 (c x d) + |c|^2 (d x b) + |d|^2 (b x c), for rows b, c, d relative to a.
// This vector is [bcd] times twice the circumcentre relative to a.
template <std::size_t K, class T>
MGDT_PREDICATES_INLINE auto circumcenter_numerator(const T* v) {
    const T *const b = v, *const c = v + 3, *const d = v + 6;
    const auto bb = SphereDeterminant::square(b), cc = SphereDeterminant::square(c),
               dd = SphereDeterminant::square(d);
    return three_products(bb, cross_product<K>(c, d), cc, cross_product<K>(b, d), dd,
                          cross_product<K>(b, c));
}

}  // namespace mgdt::exact
