// SPDX-License-Identifier: MIT
#include "predicates.hpp"
#include "stages.hpp"

namespace mgdt {
namespace {

using exact::Differences;
using exact::Integer;

// Determinant of the rows b - a, c - a, d - a.
struct Determinant {
    template <class T>
    MGDT_PREDICATES_INLINE auto operator()(const T (&v)[9]) const {
        const auto cd = v[3] * v[7] - v[6] * v[4];
        const auto bd = v[0] * v[7] - v[6] * v[1];
        const auto bc = v[0] * v[4] - v[3] * v[1];
        return (v[2] * cd - v[5] * bd) + v[8] * bc;
    }
};

// Minors of 2 * 32 bits; without a 128-bit type the result itself, 3 * 21 + 1, fits 64.
constexpr int lattice_bits = exact::widest_bits == 128 ? 32 : 21;

MGDT_PREDICATES_INLINE int filter(const Differences<9>& v, const exact::Bound& bound) {
    return exact::filtered(v, bound, Determinant());
}

MGDT_PREDICATES_INLINE int lattice(const Differences<9>& v) {
    Integer<lattice_bits> n[9];
    return exact::to_lattice(v, n) ? sign(Determinant()(n)) : exact::undecided;
}

}  // namespace

int orientation(const double* a, const double* b, const double* c, const double* d) {
    const auto v = exact::differences({b, c, d}, a);
    int s = filter(v, exact::orientation_bound);
    if (s == exact::undecided) s = lattice(v);
    if (s == exact::undecided) s = exact::orientation_integer(a, b, c, d);
    return s;
}

namespace exact {

int orientation_filter(const double* a, const double* b, const double* c, const double* d,
                       const Bound& bound) {
    return filter(differences({b, c, d}, a), bound);
}

int orientation_lattice(const double* a, const double* b, const double* c, const double* d) {
    return lattice(differences({b, c, d}, a));
}

int orientation_integer(const double* a, const double* b, const double* c, const double* d,
                        int least_width) {
    return with_integers(ExactDifferences<9>({b, c, d}, a), least_width,
                         [](const auto& v) { return sign(Determinant()(v)); });
}

}  // namespace exact
}  // namespace mgdt
