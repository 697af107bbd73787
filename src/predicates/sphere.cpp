// SPDX-License-Identifier: MIT
#include "predicates.hpp"
#include "stages.hpp"

namespace mgdt {
namespace {

using exact::Differences;
using exact::Integer;

// With rows a, b, c, d relative to q: |a|^2 [bcd] - |b|^2 [acd] + |c|^2 [abd] - |d|^2 [abc],
// positive for q inside the circumsphere of a positively oriented tetrahedron.
struct Determinant {
    template <class T>
    static MGDT_PREDICATES_INLINE auto square(const T* p) {
        return (p[0] * p[0] + p[1] * p[1]) + p[2] * p[2];
    }

    template <class T>
    static MGDT_PREDICATES_INLINE auto minor(const T* p, const T* q) {
        return p[0] * q[1] - q[0] * p[1];
    }

    template <class T>
    MGDT_PREDICATES_INLINE auto operator()(const T (&v)[12]) const {
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
        return (square(a) * bcd - square(b) * acd) + (square(c) * abd - square(d) * abc);
    }
};

// The result fits the widest native type: 5 * 25 + 3 <= 128, 5 * 12 + 3 <= 64.
constexpr int lattice_bits = exact::widest_bits == 128 ? 25 : 12;

MGDT_PREDICATES_INLINE int filter(const Differences<12>& v, const exact::Bound& bound) {
    return exact::filtered(v, bound, Determinant());
}

MGDT_PREDICATES_INLINE int lattice(const Differences<12>& v) {
    Integer<lattice_bits> n[12];
    return exact::to_lattice(v, n) ? sign(Determinant()(n)) : exact::undecided;
}

}  // namespace

int side_of_sphere(const double* a, const double* b, const double* c, const double* d,
                   const double* q) {
    const auto v = exact::differences({a, b, c, d}, q);
    int s = filter(v, exact::sphere_bound);
    if (s == exact::undecided) s = lattice(v);
    if (s == exact::undecided) s = exact::sphere_integer(a, b, c, d, q);
    return s;
}

namespace exact {

int sphere_filter(const double* a, const double* b, const double* c, const double* d,
                  const double* q, const Bound& bound) {
    return filter(differences({a, b, c, d}, q), bound);
}

int sphere_lattice(const double* a, const double* b, const double* c, const double* d,
                   const double* q) {
    return lattice(differences({a, b, c, d}, q));
}

int sphere_integer(const double* a, const double* b, const double* c, const double* d,
                   const double* q, int least_width) {
    return with_integers(ExactDifferences<12>({a, b, c, d}, q), least_width,
                         [](const auto& v) { return sign(Determinant()(v)); });
}

}  // namespace exact
}  // namespace mgdt
