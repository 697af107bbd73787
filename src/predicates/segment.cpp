// SPDX-License-Identifier: MIT
#include "predicates/segment.hpp"

#include <cmath>

#include "predicates/bounded_float.hpp"
#include "predicates/determinants.hpp"
#include "predicates/differences.hpp"
#include "predicates/normal_range.hpp"
#include "predicates/quotient.hpp"
#include "predicates/vector.hpp"

namespace mgdt {
namespace exact {

int change_of_orientation_bounded(const double* a, const double* b, const double* d,
                                  const double* p, const double* q) {
    const auto ab = bounded_difference<double>(b, a), ad = bounded_difference<double>(d, a),
               qp = bounded_difference<double>(p, q);
    return dot(cross(ab, ad), qp).sign();
}

int change_of_orientation_integer(const double* a, const double* b, const double* d,
                                  const double* p, const double* q, int least_width) {
    // Relative to a, the triple product is [bdp] - [bdq], and [bdp] = [pbd].
    return with_integers(ExactDifferences<12>({p, b, d, q}, a), least_width, [](const auto& v) {
        return sign(OrientationDeterminant::of(v) - OrientationDeterminant::of(v + 3));
    });
}

namespace {

// A scalar product of a normal, and the sum of the magnitudes of its terms.
struct NormalProduct {
    Twofold value;
    double size;
};
MGDT_PREDICATES_INLINE NormalProduct product_of(const Vector<Twofold>& normal,
                                                const double (&sizes)[3],
                                                const Vector<Twofold>& d) {
    return {dot(normal, d),
            (sizes[0] * std::fabs(d.x[0].high) + sizes[1] * std::fabs(d.x[1].high)) +
                sizes[2] * std::fabs(d.x[2].high)};
}

}  // namespace

bool crossing_parameter_twofold(const double* a, const double* b, const double* const (&p)[3],
                                double& t, double bound) {
    for (const double* const x : {a, b, p[0], p[1], p[2]})
        if (!in_normal_range(x)) return false;
    const Vector<Twofold> e = difference<Twofold>(p[1], p[0]), f = difference<Twofold>(p[2], p[0]),
                          normal = mgdt::cross(e, f);
    double sizes[3];  // of the terms of the normal's coordinates
    each<3>([&](auto k) {
        constexpr std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
        sizes[k] = std::fabs(e.x[l].high * f.x[m].high) + std::fabs(e.x[m].high * f.x[l].high);
    });
    const NormalProduct distance = product_of(normal, sizes, difference<Twofold>(p[0], a)),
                        whole = product_of(normal, sizes, difference<Twofold>(b, a));
    const double unit = bound * rounding_of<Twofold>;
    const double least = std::fabs(whole.value.high) * (1 - 0x1p-40) - unit * whole.size;
    if (!(least > 0)) return false;
    const Twofold quotient = distance.value / whole.value;
    const double size = std::fabs(quotient.high);
    if (!(size > 0x1p-900)) return false;  // its lower part may underflow
    const double error =
        (unit * (distance.size + size * whole.size) / least + rounding_of<Twofold> * size) *
        (1 + 0x1p-40);
    return round_if_certain(quotient, error, t);
}

bool crossing_parameter_bounded(const double* a, const double* b, const double* const (&p)[3],
                                double& t) {
    using Number = BoundedFloat<Twofold>;
    const Vector<Number> normal =
        cross(bounded_difference<Twofold>(p[1], p[0]), bounded_difference<Twofold>(p[2], p[0]));
    const Number distance = dot(normal, bounded_difference<Twofold>(p[0], a)),
                 whole = dot(normal, bounded_difference<Twofold>(b, a));
    return round_to_nearest(distance / whole, 0, t);
}

double crossing_parameter_integer(const double* a, const double* b, const double* const (&p)[3],
                                  int least_width) {
    double t = 0;
    // With normal = (p1 - p0) x (p2 - p0) and relative to a, normal.p0 is the minor [p0 p1 p2], and
    // normal.b is the sum of three other minors.
    with_integers(ExactDifferences<12>({p[0], p[1], p[2], b}, a), least_width, [&](const auto& v) {
        const auto minors = SphereDeterminant::minors(v);
        const auto& m = minors.of;
        t = rounded_quotient(m[3], m[0] - m[1] + m[2], 0);
        return 0;
    });
    return t;
}

}  // namespace exact

int change_of_orientation(const double* a, const double* b, const double* d, const double* p,
                          const double* q) {
    const int known = exact::change_of_orientation_bounded(a, b, d, p, q);
    return known != exact::undecided ? known : exact::change_of_orientation_integer(a, b, d, p, q);
}

double crossing_parameter(const double* a, const double* b, const double* const (&p)[3]) {
    double t = 0;
    if (exact::crossing_parameter_twofold(a, b, p, t)) return t;
    if (exact::crossing_parameter_bounded(a, b, p, t)) return t;
    return exact::crossing_parameter_integer(a, b, p);
}

}  // namespace mgdt
