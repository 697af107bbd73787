// SPDX-License-Identifier: MIT
// Orientation and the sphere predicate over sparse integers. These stages decide if the coordinates
// have a few scales far apart, at a fraction of the cost of integers that span all scales.
#include "predicates/determinants.hpp"
#include "predicates/sparse.hpp"
#include "predicates/stages.hpp"

namespace mgdt::exact {

template <int Bits>
constexpr bool is_long<Sparse<Bits>> = true;

namespace {

// Calls f with the differences as sparse integers of this width. Returns `undecided` if the
// differences do not fit, or if `terms` is `single` and a difference has several terms. The
// function is not inlined, so that the stack holds the numbers of one width only.
template <int Bits, int N, class F>
MGDT_PREDICATES_APART int with_sparse_of(const ExactDifferences<N>& d, Terms terms, const F& f) {
    const SparseDifferences<N, Bits> v(d);
    if (!v.is_good() || (terms == Terms::single && !v.is_single())) return undecided;
    return f(v.value);
}

// Calls f with sparse integers of the least width that fits; for single terms, of 60 bits only.
template <int N, class F>
int with_sparse(const ExactDifferences<N>& d, Terms terms, const F& f) {
    const int s = with_sparse_of<60>(d, terms, f);
    return s != undecided || terms == Terms::single ? s : with_sparse_of<124>(d, terms, f);
}

}  // namespace

int orientation_sparse(const double* a, const double* b, const double* c, const double* d,
                       Terms terms, int least) {
    const ExactDifferences<9> v({b, c, d}, a);
    if (v.bits() < least) return undecided;
    return with_sparse(v, terms, [](const auto& x) { return sign(OrientationDeterminant()(x)); });
}

int sphere_sparse(const double* a, const double* b, const double* c, const double* d,
                  const double* q, Terms terms, int minor_signs[4], int least) {
    const ExactDifferences<12> v({a, b, c, d}, q);
    if (v.bits() < least) return undecided;
    return with_sparse(v, terms, [&](const auto& x) {
        const auto minors = apart([&] { return SphereDeterminant::minors(x); });
        const int s = apart([&] { return sign(SphereDeterminant::value(x, minors)); });
        if (s == 0 && minor_signs)
            for (int i = 0; i < 4; ++i) minor_signs[i] = sign(minors.of[i]);
        return s;
    });
}

}  // namespace mgdt::exact
