// SPDX-License-Identifier: MIT
#include "predicates/facet_sphere.hpp"

#include <algorithm>
#include <cmath>

#include "predicates/bounded_float.hpp"
#include "predicates/determinants.hpp"
#include "predicates/differences.hpp"
#include "predicates/filter.hpp"
#include "predicates/quotient.hpp"
#include "predicates/vector.hpp"

namespace mgdt {
namespace exact {
namespace {

// Products of eight lengths whose squares are in this range neither overflow nor underflow.
constexpr double least_square = 0x1p-240, most_square = 0x1p240;

bool is_in_range(double square) {
    return square > least_square && square < most_square;
}

using Number = BoundedFloat<Twofold>;

struct Edges : ExactPairs<9> {
    static constexpr int count = 9;
};

// The corner opposite the longest edge. The angle there distinguishes needles from other triangles.
unsigned widest_corner(const double* const (&p)[3]) {
    double opposite[3];
    for (unsigned i = 0; i < 3; ++i) {
        const Vector<double> edge = difference<double>(p[(i + 1) % 3], p[(i + 2) % 3]);
        opposite[i] = dot(edge, edge);
    }
    if (opposite[0] >= opposite[1]) return opposite[0] >= opposite[2] ? 0 : 2;
    return opposite[1] >= opposite[2] ? 1 : 2;
}

// Computes the squared radius of the smallest sphere through p. Returns false if a squared edge is
// out of range, or if p is a needle: the two squared edges at the widest corner have a product
// above `most` times the square of their cross product.
template <class Real>
bool radius2_as(const double* const (&p)[3], double most, double& square) {
    const unsigned i = widest_corner(p);
    const double *const origin = p[i], *const a = p[(i + 1) % 3], *const b = p[(i + 2) % 3];
    const Vector<Real> r = difference<Real>(a, origin), s = difference<Real>(b, origin),
                       t = difference<Real>(a, b), n = cross(r, s);
    const Real rr = dot(r, r), ss = dot(s, s), tt = dot(t, t), nn = dot(n, n);
    if (!is_in_range(nearest_double(rr)) || !is_in_range(nearest_double(ss)) ||
        !is_in_range(nearest_double(tt)) ||
        !(nearest_double(rr) * nearest_double(ss) <= most * nearest_double(nn)))
        return false;
    square = 0.25 * nearest_double(rr * ss * tt / nn);
    return true;
}

}  // namespace

// `height` is positive if the centre of the sphere through all four points is on q's side of the
// plane of a, b and c. Then q is outside the smallest sphere through a, b and c; if `height` is
// negative, q is inside: docs/theory.md, "Facets".
int facet_sphere_filter(const double* a, const double* b, const double* c, const double* q) {
    const Vector<double> r[3] = {difference<double>(b, a), difference<double>(c, a),
                                 difference<double>(q, a)};
    double square[3], length[3];
    for (int i = 0; i < 3; ++i) {
        square[i] = dot(r[i], r[i]);
        if (!is_in_range(square[i])) return undecided;
        length[i] = std::sqrt(square[i]);
    }
    const Vector<double> n = cross(r[0], r[1]);
    const double height =
        (square[0] * dot(cross(r[1], r[2]), n) + square[1] * dot(cross(r[2], r[0]), n)) +
        square[2] * dot(n, n);
    const double all = length[0] * length[1] * length[2];
    const double error =
        32 * half_ulp * (all * (length[0] + length[1] + length[2])) * (length[0] * length[1]);
    return height > error ? -1 : height < -error ? 1 : undecided;
}

int facet_sphere_bounded(const double* a, const double* b, const double* c, const double* q) {
    const Vector<Number> r = bounded_difference<Twofold>(b, a),
                         s = bounded_difference<Twofold>(c, a),
                         t = bounded_difference<Twofold>(q, a), n = cross(r, s);
    const Number height =
        (dot(r, r) * dot(cross(s, t), n) + dot(s, s) * dot(cross(t, r), n)) + dot(t, t) * dot(n, n);
    const int sign = height.sign();
    return sign == 2 ? undecided : -sign;
}

int facet_sphere_integer(const double* a, const double* b, const double* c, const double* q,
                         int least_width) {
    return with_integers(ExactDifferences<9>({b, c, q}, a), least_width, [](const auto& v) -> int {
        return -sign(apart([&] {
            return (circumcenter_numerator<0>(v) * cross_product<0>(v + 0, v + 3) +
                    circumcenter_numerator<1>(v) * cross_product<1>(v + 0, v + 3)) +
                   circumcenter_numerator<2>(v) * cross_product<2>(v + 0, v + 3);
        }));
    });
}

bool facet_radius2_plain(const double* const (&p)[3], double& square) {
    return radius2_as<double>(p, 64, square);
}

bool facet_radius2_twofold(const double* const (&p)[3], double& square) {
    return radius2_as<Twofold>(p, 0x1p80, square);
}

bool facet_radius2_bounded(const double* const (&p)[3], int scale, double& square) {
    const unsigned i = widest_corner(p);
    const double *const origin = p[i], *const a = p[(i + 1) % 3], *const b = p[(i + 2) % 3];
    const Vector<Number> r = bounded_difference<Twofold>(a, origin),
                         s = bounded_difference<Twofold>(b, origin),
                         t = bounded_difference<Twofold>(a, b), n = cross(r, s);
    const Number x = dot(r, r) * dot(s, s) * dot(t, t) / dot(n, n);
    const WideDouble value = x.wide();
    if (!(x.wide_error() < value * WideDouble(0.5 * facet_radius_error))) return false;
    square = WideDouble(value.mantissa, value.exponent - 2 - 2 * scale).in_double();
    return true;
}

double facet_radius2_integer(const double* const (&p)[3], int scale, int least_width) {
    Edges d;
    for (std::size_t k = 0; k < 3; ++k) {
        d.set(k, p[1][k], p[0][k]);
        d.set(3 + k, p[2][k], p[0][k]);
        d.set(6 + k, p[2][k], p[1][k]);
    }
    const int unit = d.low - scale;
    double square = 0;
    with_integers(d, least_width, [&](const auto& v) {
        const auto squares = apart([&] {
            return (SphereDeterminant::square(v + 0) * SphereDeterminant::square(v + 3)) *
                   SphereDeterminant::square(v + 6);
        });
        const auto x = apart([&] { return cross_product<0>(v + 0, v + 3); });
        const auto y = apart([&] { return cross_product<1>(v + 0, v + 3); });
        const auto z = apart([&] { return cross_product<2>(v + 0, v + 3); });
        const auto doubled = apart([&] { return (x * x + y * y) + z * z; });
        square = apart([&] { return rounded_quotient(squares, doubled, 2 * unit - 2); });
        return 0;
    });
    return square;
}

}  // namespace exact

int side_of_facet_sphere(const double* a, const double* b, const double* c, const double* q) {
    const int s = exact::facet_sphere_filter(a, b, c, q);
    if (s != exact::undecided) return s;
    if (exact::ExactDifferences<9>({b, c, q}, a).bits() > exact::short_width) {
        const int bounded = exact::facet_sphere_bounded(a, b, c, q);
        if (bounded != exact::undecided) return bounded;
    }
    return exact::facet_sphere_integer(a, b, c, q);
}

double edge_radius2(const double* a, const double* b, int scale) {
    double half[3], largest = 0;
    for (int k = 0; k < 3; ++k) {
        half[k] = a[k] - b[k];
        // If the difference overflows, it is computed from halves. A half that has to be rounded is
        // too small to matter.
        half[k] = std::isfinite(half[k]) ? 0.5 * half[k] : 0.5 * a[k] - 0.5 * b[k];
        largest = std::max(largest, std::fabs(half[k]));
    }
    // Scaling brings the largest difference near 1, so that its square is in the range of doubles.
    const int exponent = largest > 0 ? std::ilogb(largest) : 0;
    double square = 0;
    for (const double x : half) {
        const double near_one = std::ldexp(x, -exponent);
        square += near_one * near_one;
    }
    return std::ldexp(square, 2 * (exponent - scale));
}

double facet_radius2(const double* const (&p)[3], int scale) {
    double square;
    if (exact::facet_radius2_plain(p, square) || exact::facet_radius2_twofold(p, square))
        return std::ldexp(square, -2 * scale);
    if (exact::facet_radius2_bounded(p, scale, square)) return square;
    return exact::facet_radius2_integer(p, scale);
}

}  // namespace mgdt
