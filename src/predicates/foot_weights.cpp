// SPDX-License-Identifier: MIT
#include "predicates/foot_weights.hpp"

#include <cmath>

#include "predicates/determinants.hpp"
#include "predicates/differences.hpp"
#include "predicates/quotient.hpp"

namespace mgdt {

using exact::quotient;
using exact::Rounded;
using exact::scalar_product;

void foot_weights(const double* a, const double* b, const double* c, const double* q,
                  double (&w)[3]) {
    exact::with_integers(exact::ExactDifferences<9>({b, c, q}, a), 0, [&](const auto& v) {
        const auto *const e = v, *const f = v + 3, *const d = v + 6;
        const auto ee = scalar_product(e, e), ff = scalar_product(f, f), ef = scalar_product(e, f),
                   ed = scalar_product(e, d), fd = scalar_product(f, d);
        using exact::two_products;
        // The square of e x f, and the scalar products of e x f with d x f and with e x d.
        const auto whole = two_products(ee, ff, ef, ef), of_b = two_products(ff, ed, fd, ef),
                   of_c = two_products(ee, fd, ed, ef);
        const Rounded all = exact::apart([&] { return rounded(whole); });
        w[0] = exact::apart([&] { return quotient(rounded(whole - (of_b + of_c)), all); });
        w[1] = exact::apart([&] { return quotient(rounded(of_b), all); });
        w[2] = exact::apart([&] { return quotient(rounded(of_c), all); });
        return 0;
    });
}

void foot_weights(const double* a, const double* b, const double* q, double (&w)[2]) {
    exact::with_integers(exact::ExactDifferences<6>({b, q}, a), 0, [&](const auto& v) {
        const auto *const e = v, *const d = v + 3;
        const auto ee = scalar_product(e, e), ed = scalar_product(e, d);
        const Rounded all = rounded(ee);
        w[0] = quotient(rounded(ee - ed), all);
        w[1] = quotient(rounded(ed), all);
        return 0;
    });
}

}  // namespace mgdt
