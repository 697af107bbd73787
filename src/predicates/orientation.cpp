// SPDX-License-Identifier: MIT
// The orientation of four points.
#include "predicates/determinants.hpp"
#include "predicates/lattice.hpp"
#include "predicates/native_integer.hpp"
#include "predicates/predicates.hpp"
#include "predicates/stages.hpp"

namespace mgdt {
namespace exact {
namespace {

MGDT_PREDICATES_INLINE int filter(const Differences<9>& v, const Bound& bound) {
    return filtered(v, bound, OrientationDeterminant());
}

MGDT_PREDICATES_INLINE int lattice(const Differences<9>& v) {
    return is_lattice<orientation_lattice_bits>(v) ? sign_of(OrientationDeterminant()(v.rounded))
                                                   : undecided;
}

MGDT_PREDICATES_INLINE int native_sign(const Differences<9>& v) {
    if constexpr (have_native) {
        std::int64_t n[9];
        if (to_native(v, n)) return native_orientation(n);
    }
    return undecided;
}

}  // namespace

int orientation_filter(const double* a, const double* b, const double* c, const double* d,
                       const Bound& bound) {
    return filter(differences({b, c, d}, a), bound);
}

int orientation_lattice(const double* a, const double* b, const double* c, const double* d) {
    return lattice(differences({b, c, d}, a));
}

int orientation_native(const double* a, const double* b, const double* c, const double* d) {
    return native_sign(differences({b, c, d}, a));
}

int orientation_integer(const double* a, const double* b, const double* c, const double* d,
                        int least_width) {
    return with_integers(ExactDifferences<9>({b, c, d}, a), least_width,
                         [](const auto& v) { return sign(OrientationDeterminant()(v)); });
}

}  // namespace exact

int orientation(const double* a, const double* b, const double* c, const double* d) {
    const auto v = exact::differences({b, c, d}, a);
    int s = exact::filter(v, exact::orientation_bound);
    if (s == exact::undecided) s = exact::lattice(v);
    if (s == exact::undecided) s = exact::native_sign(v);
    if (s == exact::undecided) s = exact::orientation_scaled(a, b, c, d);
    if (s == exact::undecided) s = exact::orientation_sparse(a, b, c, d, exact::Terms::single);
    if (s == exact::undecided) s = exact::orientation_ranged(a, b, c, d);
    if (s == exact::undecided) s = exact::orientation_sparse(a, b, c, d);
    if (s == exact::undecided) s = exact::orientation_integer(a, b, c, d);
    return s;
}

}  // namespace mgdt
