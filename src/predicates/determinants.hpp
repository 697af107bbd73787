// SPDX-License-Identifier: MIT
// The determinants of orientation and of the sphere predicate, over any number type.
#pragma once

#include "integer.hpp"

namespace mgdt::exact {

// Determinant of the rows b - a, c - a, d - a.
struct OrientationDeterminant {
    template <class T>
    MGDT_PREDICATES_INLINE auto operator()(const T (&v)[9]) const {
        const auto cd = v[3] * v[7] - v[6] * v[4];
        const auto bd = v[0] * v[7] - v[6] * v[1];
        const auto bc = v[0] * v[4] - v[3] * v[1];
        return (v[2] * cd - v[5] * bd) + v[8] * bc;
    }
};

// With rows a, b, c, d relative to q: |a|^2 [bcd] - |b|^2 [acd] + |c|^2 [abd] - |d|^2 [abc],
// positive for q inside the circumsphere of a positively oriented tetrahedron. The four 3 x 3
// minors with their signs are also what multiplies the perturbations of a, b, c, d.
template <class Minor>
struct SphereMinors {
    Minor of[4];
};

struct SphereDeterminant {
    template <class T>
    static MGDT_PREDICATES_INLINE auto square(const T* p) {
        return (p[0] * p[0] + p[1] * p[1]) + p[2] * p[2];
    }

    template <class T>
    static MGDT_PREDICATES_INLINE auto minor(const T* p, const T* q) {
        return p[0] * q[1] - q[0] * p[1];
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
        const auto bcd = (b[2] * cd - c[2] * bd) + d[2] * bc;
        const auto acd = (a[2] * cd - c[2] * ad) + d[2] * ac;
        const auto abd = (a[2] * bd - b[2] * ad) + d[2] * ab;
        const auto abc = (a[2] * bc - b[2] * ac) + c[2] * ab;
        using Minor = std::remove_const_t<decltype(bcd)>;
        return SphereMinors<Minor>{{bcd, acd, abd, abc}};
    }

    template <class T, class Minor>
    static MGDT_PREDICATES_INLINE auto value(const T (&v)[12], const SphereMinors<Minor>& m) {
        return (square(v) * m.of[0] - square(v + 3) * m.of[1]) +
               (square(v + 6) * m.of[2] - square(v + 9) * m.of[3]);
    }

    template <class T>
    MGDT_PREDICATES_INLINE auto operator()(const T (&v)[12]) const {
        return value(v, minors(v));
    }
};

}  // namespace mgdt::exact
