// SPDX-License-Identifier: MIT
#include "predicates/circumcenter.hpp"

#include <cmath>
#include <limits>

#include "predicates/bounded_float.hpp"
#include "predicates/determinants.hpp"
#include "predicates/differences.hpp"
#include "predicates/filter.hpp"
#include "predicates/normal_range.hpp"
#include "predicates/quotient.hpp"
#include "predicates/twofold.hpp"

namespace mgdt {
namespace exact {
namespace {

// The position of a vertex relative to the first vertex.
struct Row {
    double x[3], low[3];  // the rounded difference, and the rounding error
    double largest;
};

MGDT_PREDICATES_INLINE Row row(const double* p, const double* origin) {
    Row r;
    each<3>([&](auto k) {
        const Twofold d = Twofold::sum(p[k], -origin[k]);
        r.x[k] = d.high;
        r.low[k] = d.low;
    });
    r.largest = largest_of<0, 3>(r.x);
    return r;
}

// |r|^2 - w.r, computed as the sum of r (r - w) over the axes.
MGDT_PREDICATES_INLINE double residual(const Row& r, const double (&w)[3]) {
    double product[3], rest = 0;
    each<3>([&](auto k) {
        const Twofold factor = Twofold::sum(r.x[k], -w[k]);
        const Twofold p = Twofold::product(r.x[k], factor.high);
        product[k] = p.high;
        rest += p.low + (r.x[k] * (factor.low + r.low[k]) + r.low[k] * factor.high);
    });
    const Twofold first = Twofold::sum(product[0], product[1]),
                  all = Twofold::sum(first.high, product[2]);
    return all.high + (rest + (first.low + all.low));
}

// Multiplies x by 2^exponent. Returns false if that is not exact.
MGDT_PREDICATES_INLINE bool scale_exactly(double& x, int exponent) {
    if (exponent == 0 || x == 0) return true;
    x = std::ldexp(x, exponent);
    // A subnormal result may have been rounded up to the smallest normal number, so that number
    // counts as inexact.
    return std::fabs(x) > std::numeric_limits<double>::min() &&
           std::fabs(x) <= std::numeric_limits<double>::max();
}

}  // namespace

double sphere_residual(const double* p, const double* origin, const double (&w)[3]) {
    return residual(row(p, origin), w);
}

namespace {

// Twice the position of the centre relative to the first vertex.
struct DoubledOffset {
    double rough[3], correction[3];  // an approximation, and the correction to be added
    double error, size;  // a bound on the error of a coordinate; nearly the largest coordinate
};

// Computes w, twice the position of the centre relative to the first vertex: w.r = |r|^2 for the
// positions r of the other three vertices. Returns false if a coordinate is out of range or the
// determinant is too small.
MGDT_PREDICATES_INLINE bool solve(const double* const (&p)[4], const CircumcenterBounds& bounds,
                                  DoubledOffset& result) {
    for (const double* const x : p)
        if (!in_normal_range(x)) return false;
    const Row r[3] = {row(p[1], p[0]), row(p[2], p[0]), row(p[3], p[0])};
    double cross[3][3];
    each<3>([&](auto i) {
        const double *const s = r[(i + 1) % 3].x, *const t = r[(i + 2) % 3].x;
        each<3>([&](auto k) {
            constexpr std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
            cross[i][k] = s[l] * t[m] - s[m] * t[l];
        });
    });
    const double det =
        (r[0].x[0] * cross[0][0] + r[0].x[1] * cross[0][1]) + r[0].x[2] * cross[0][2];
    const double product = r[0].largest * r[1].largest * r[2].largest;
    if (!(det > 2 * bounds.solution * half_ulp * product)) return false;
    const double inverse = 1 / det;
    const auto times_inverse = [&](const double(&of)[3], double(&w)[3]) {
        each<3>([&](auto k) {
            w[k] = ((of[0] * cross[0][k] + of[1] * cross[1][k]) + of[2] * cross[2][k]) * inverse;
        });
    };
    double of[3];
    each<3>([&](auto i) {
        const double(&x)[3] = r[i].x;
        of[i] = (x[0] * x[0] + x[1] * x[1]) + x[2] * x[2];
    });
    times_inverse(of, result.rough);
    each<3>([&](auto i) { of[i] = residual(r[i], result.rough); });
    times_inverse(of, result.correction);

    const double largest = largest_of<0, 3>(result.rough),
                 change = largest_of<0, 3>(result.correction);
    double sum = 0, rests = 0;
    each<3>([&](auto i) {
        const double others = r[(i + 1) % 3].largest * r[(i + 2) % 3].largest;
        sum += std::fabs(of[i]) * others;
        rests += r[i].largest * (r[i].largest + largest) * others;
    });
    result.error =
        inverse * half_ulp *
        (bounds.solution * (sum + product * change) + bounds.residual * half_ulp * rests);
    result.size = largest + change;
    return true;
}

}  // namespace

namespace {

// The position of the centre, with a bound on the error of coordinate k.
MGDT_PREDICATES_INLINE Twofold position(const double* first, const DoubledOffset& offset, int k) {
    const Twofold w = Twofold::sum(offset.rough[k], offset.correction[k]);
    Twofold x = Twofold::sum(first[k], 0.5 * w.high);
    x.low += 0.5 * w.low;
    return x;
}
MGDT_PREDICATES_INLINE double position_error(const DoubledOffset& offset, const Twofold& x) {
    return offset.error + 4 * half_ulp * std::fabs(x.low);
}

}  // namespace

bool circumcenter_refined(const double* const (&p)[4], const double* first, int scale,
                          Circumcenter& c, const CircumcenterBounds& bounds) {
    DoubledOffset offset;
    if (!in_normal_range(first) || !solve(p, bounds, offset)) return false;
    const double error = offset.error, size = offset.size;
    Twofold w[3], square[3];
    double rest = 0;
    bool is_known = true;
    each<3>([&](auto k) {
        w[k] = Twofold::sum(offset.rough[k], offset.correction[k]);
        const Twofold x = position(first, offset, k);
        is_known &= round_if_certain(x, position_error(offset, x), c.x[k]);
        is_known &= scale_exactly(c.x[k], -scale);
        square[k] = Twofold::product(w[k].high, w[k].high);
        rest += square[k].low + 2 * w[k].high * w[k].low;
    });
    const Twofold two = Twofold::sum(square[0].high, square[1].high);
    const Twofold all = Twofold::sum(two.high, square[2].high);
    is_known &= round_if_certain(
        {all.high, rest + (two.low + all.low)},
        (8 * size + 4 * error) * error + 100 * half_ulp * half_ulp * size * size, c.radius2);
    c.radius2 *= 0.25;
    return is_known && scale_exactly(c.radius2, -2 * scale);
}

namespace {

using Number = BoundedFloat<Twofold>;

// The position of the centre relative to the first vertex.
Vector<Number> bounded_offset(const double* const (&p)[4]) {
    const Vector<Number> a = bounded_difference<Twofold>(p[1], p[0]),
                         b = bounded_difference<Twofold>(p[2], p[0]),
                         c = bounded_difference<Twofold>(p[3], p[0]), bc = cross(b, c),
                         ca = cross(c, a), ab = cross(a, b);
    const Number inverse = Number::number(0.5) / dot(a, bc);
    return inverse * ((dot(a, a) * bc + dot(b, b) * ca) + dot(c, c) * ab);
}

}  // namespace

bool circumcenter_bounded(const double* const (&p)[4], const double* first, int scale,
                          Circumcenter& c) {
    const Vector<Number> offset = bounded_offset(p);
    for (int k = 0; k < 3; ++k)
        if (!round_to_nearest(offset.x[k] + Number::number(first[k]), -scale, c.x[k])) return false;
    return round_to_nearest(dot(offset, offset), -2 * scale, c.radius2);
}

namespace {

bool has_short_integers(const double* const (&p)[4]) {
    return ExactDifferences<9>({p[1], p[2], p[3]}, p[0]).bits() <= short_width;
}

}  // namespace

bool center_offset_bounded(const double* const (&p)[4], double (&offset)[3]) {
    const Vector<Number> x = bounded_offset(p);
    WideDouble largest;
    for (const Number& of : x.x)
        if (largest < magnitude(of.wide())) largest = magnitude(of.wide());
    for (int k = 0; k < 3; ++k) {
        if (!(x.x[k].wide_error() < largest * WideDouble(0.5 * center_offset_error))) return false;
        offset[k] = x.x[k].wide().in_double();
    }
    return true;
}

namespace {

// The differences between the other three vertices and the first vertex, followed by the
// coordinates of the place of the first vertex.
struct VertexAndDifferences : ExactPairs<12> {
    static constexpr int count = 12;
};

}  // namespace

void circumcenter_integer(const double* const (&p)[4], const double* first, int scale,
                          Circumcenter& c, int least_width) {
    VertexAndDifferences d;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t i = 0; i < 3; ++i) d.set(3 * i + k, p[i + 1][k], p[0][k]);
        d.set(9 + k, first[k], 0);
    }
    const int unit = d.low - scale;
    with_integers(d, least_width, [&](const auto& v) {
        // Twice the determinant.
        const auto det = apart([&] {
            const auto once = OrientationDeterminant::of(v);
            return once + once;
        });
        const auto w0 = apart([&] { return circumcenter_numerator<0>(v); });
        const auto w1 = apart([&] { return circumcenter_numerator<1>(v); });
        const auto w2 = apart([&] { return circumcenter_numerator<2>(v); });
        c.x[0] = apart([&] { return rounded_quotient(w0 + det * v[9], det, unit); });
        c.x[1] = apart([&] { return rounded_quotient(w1 + det * v[10], det, unit); });
        c.x[2] = apart([&] { return rounded_quotient(w2 + det * v[11], det, unit); });
        c.radius2 = apart(
            [&] { return rounded_quotient((w0 * w0 + w1 * w1) + w2 * w2, det * det, 2 * unit); });
        return 0;
    });
}

void center_offset_integer(const double* const (&p)[4], double (&offset)[3]) {
    const ExactDifferences<9> d({p[1], p[2], p[3]}, p[0]);
    with_integers(d, 0, [&](const auto& v) {
        const auto det = apart([&] {
            const auto once = OrientationDeterminant::of(v);
            return once + once;
        });
        offset[0] =
            apart([&] { return rounded_quotient(circumcenter_numerator<0>(v), det, d.low); });
        offset[1] =
            apart([&] { return rounded_quotient(circumcenter_numerator<1>(v), det, d.low); });
        offset[2] =
            apart([&] { return rounded_quotient(circumcenter_numerator<2>(v), det, d.low); });
        return 0;
    });
}

}  // namespace exact

SplitPoint split(const Twofold (&x)[3], const double (&error)[3], const double (&nearest)[3],
                 double factor) {
    // Floats below this size lose digits, and those above the other one overflow.
    constexpr double least = 0x1p-126, most = 0x1p120;
    SplitPoint result;
    double largest = 0;
    for (int k = 0; k < 3; ++k) {
        result.x[k] = nearest[k];
        const double low = ((x[k].high - nearest[k]) + x[k].low) * factor;
        result.low[k] = std::fabs(low) < most ? static_cast<float>(low) : 0;
        const double lost = std::fabs(low - static_cast<double>(result.low[k]));
        // The sum is unordered, and so not below `most`, if a coordinate is infinite.
        largest += error[k] * factor + lost;
    }
    largest = largest * (1 + 0x1p-20) + least;
    result.error =
        largest < most ? static_cast<float>(largest) : std::numeric_limits<float>::infinity();
    return result;
}

SplitPoint split_circumcenter(const double* const (&p)[4], double factor) {
    exact::DoubledOffset w;
    Twofold x[3];
    double error[3], nearest[3];
    if (!exact::solve(p, exact::circumcenter_bounds, w)) {
        const Circumcenter c = circumcenter(p);
        for (int k = 0; k < 3; ++k) {
            x[k] = {c.x[k], 0};
            error[k] = exact::half_ulp * std::fabs(c.x[k]) + 0x1p-1074;
        }
        return split(x, error, c.x, factor);
    }
    bool is_known = true;
    for (int k = 0; k < 3; ++k) {
        x[k] = exact::position(p[0], w, k);
        error[k] = exact::position_error(w, x[k]);
        is_known &= round_if_certain(x[k], error[k], nearest[k]);
    }
    return is_known ? split(x, error, nearest, factor) : split(x, error, circumcenter(p).x, factor);
}

void center_offset(const double* const (&p)[4], double (&offset)[3]) {
    exact::DoubledOffset w;
    if (!exact::solve(p, exact::circumcenter_bounds, w) ||
        w.error > 0.5 * center_offset_error * w.size) {
        if (exact::has_short_integers(p) || !exact::center_offset_bounded(p, offset))
            exact::center_offset_integer(p, offset);
        return;
    }
    for (int k = 0; k < 3; ++k) offset[k] = 0.5 * (w.rough[k] + w.correction[k]);
}

Circumcenter circumcenter(const double* const (&p)[4], int scale) {
    return translated_circumcenter(p, p[0], scale);
}

Circumcenter translated_circumcenter(const double* const (&p)[4], const double* first, int scale) {
    Circumcenter c;
    if (exact::circumcenter_refined(p, first, scale, c)) return c;
    if (exact::has_short_integers(p) || !exact::circumcenter_bounded(p, first, scale, c))
        exact::circumcenter_integer(p, first, scale, c);
    return c;
}

}  // namespace mgdt
