// SPDX-License-Identifier: MIT
// The position of a point with respect to the circumsphere of a tetrahedron, without ties.
#include "predicates/determinants.hpp"
#include "predicates/lattice.hpp"
#include "predicates/native_integer.hpp"
#include "predicates/predicates.hpp"
#include "predicates/stages.hpp"

namespace mgdt {
namespace exact {
namespace {

MGDT_PREDICATES_INLINE int filter(const Differences<12>& v, const Bound& bound) {
    return filtered(v, bound, SphereDeterminant());
}

MGDT_PREDICATES_INLINE int lattice(const Differences<12>& v) {
    return is_lattice<sphere_lattice_bits>(v) ? sign_of(SphereDeterminant()(v.rounded)) : undecided;
}

MGDT_PREDICATES_INLINE int native_sign(const Differences<12>& v) {
    if constexpr (have_native) {
        std::int64_t n[12];
        if (to_native(v, n)) return NativeSphere(n).sign;
    }
    return undecided;
}

}  // namespace

int sphere_filter(const double* a, const double* b, const double* c, const double* d,
                  const double* q, const Bound& bound) {
    return filter(differences({a, b, c, d}, q), bound);
}

int sphere_lattice(const double* a, const double* b, const double* c, const double* d,
                   const double* q) {
    return lattice(differences({a, b, c, d}, q));
}

int sphere_native(const double* a, const double* b, const double* c, const double* d,
                  const double* q) {
    return native_sign(differences({a, b, c, d}, q));
}

int sphere_integer(const double* a, const double* b, const double* c, const double* d,
                   const double* q, int least_width) {
    return with_integers(ExactDifferences<12>({a, b, c, d}, q), least_width,
                         [](const auto& v) { return sign(SphereDeterminant()(v)); });
}

}  // namespace exact

int side_of_sphere(const double* a, const double* b, const double* c, const double* d,
                   const double* q) {
    const auto v = exact::differences({a, b, c, d}, q);
    int s = exact::filter(v, exact::sphere_bound);
    if (s == exact::undecided) {
        s = exact::have_native ? exact::native_sign(v) : exact::lattice(v);
    }
    if (s == exact::undecided) s = exact::sphere_scaled(a, b, c, d, q);
    if (s == exact::undecided) s = exact::sphere_sparse(a, b, c, d, q, exact::Terms::single);
    if (s == exact::undecided) s = exact::sphere_ranged(a, b, c, d, q);
    if (s == exact::undecided) s = exact::sphere_sparse(a, b, c, d, q);
    if (s == exact::undecided) s = exact::sphere_integer(a, b, c, d, q);
    return s;
}

}  // namespace mgdt
