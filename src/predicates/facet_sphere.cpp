// SPDX-License-Identifier: MIT
#include "facet_sphere.hpp"

#include <cmath>

#include "determinants.hpp"
#include "differences.hpp"
#include "filter.hpp"
#include "quotient.hpp"
#include "twofold.hpp"

namespace mgdt {
namespace exact {
namespace {

constexpr double u = 0x1p-53;
// Lengths between these neither overflow nor lose anything that counts in products of eight.
constexpr double least_square = 0x1p-240, most_square = 0x1p240;

bool is_in_range(double square) {
    return square > least_square && square < most_square;
}

template <class T>
struct Rows {
    T x[3];
};
template <class T>
T product(const Rows<T>& a, const Rows<T>& b) {
    return (a.x[0] * b.x[0] + a.x[1] * b.x[1]) + a.x[2] * b.x[2];
}
template <class T>
Rows<T> normal(const Rows<T>& a, const Rows<T>& b) {
    return {{a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2],
             a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}
Rows<double> difference(const double* a, const double* b) {
    return {{a[0] - b[0], a[1] - b[1], a[2] - b[2]}};
}
Rows<Twofold> twofold_difference(const double* a, const double* b) {
    return {{Twofold::sum(a[0], -b[0]), Twofold::sum(a[1], -b[1]), Twofold::sum(a[2], -b[2])}};
}

struct Edges : ExactPairs<9> {
    static constexpr int count = 9;
};

// The corner opposite the longest edge: the angle there tells a needle from others.
unsigned widest_corner(const double* const (&p)[3]) {
    double opposite[3];
    for (unsigned i = 0; i < 3; ++i) {
        const Rows<double> edge = difference(p[(i + 1) % 3], p[(i + 2) % 3]);
        opposite[i] = product(edge, edge);
    }
    if (opposite[0] >= opposite[1]) return opposite[0] >= opposite[2] ? 0 : 2;
    return opposite[1] >= opposite[2] ? 1 : 2;
}

}  // namespace

// The centre c of the sphere through all four has |c - a| = |c - q|. Spheres through a, b and c
// whose centres are beyond their plane, as seen from q, have q outside if the least one has:
// docs/theory.md.
int facet_sphere_filter(const double* a, const double* b, const double* c, const double* q) {
    const Rows<double> r[3] = {difference(b, a), difference(c, a), difference(q, a)};
    double square[3], length[3];
    for (int i = 0; i < 3; ++i) {
        square[i] = product(r[i], r[i]);
        if (!is_in_range(square[i])) return undecided;
        length[i] = std::sqrt(square[i]);
    }
    const Rows<double> n = normal(r[0], r[1]);
    const double height =
        (square[0] * product(normal(r[1], r[2]), n) + square[1] * product(normal(r[2], r[0]), n)) +
        square[2] * product(n, n);
    const double all = length[0] * length[1] * length[2];
    const double error =
        32 * u * (all * (length[0] + length[1] + length[2])) * (length[0] * length[1]);
    return height > error ? -1 : height < -error ? 1 : undecided;
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
    const unsigned i = widest_corner(p);
    const double *const origin = p[i], *const a = p[(i + 1) % 3], *const b = p[(i + 2) % 3];
    const Rows<double> r = difference(a, origin), s = difference(b, origin), t = difference(a, b);
    const Rows<double> n = normal(r, s);
    const double rr = product(r, r), ss = product(s, s), tt = product(t, t), nn = product(n, n);
    if (!is_in_range(rr) || !is_in_range(ss) || !is_in_range(tt) || !(rr * ss <= 64 * nn))
        return false;
    square = rr * ss * tt / (4 * nn);
    return true;
}

bool facet_radius2_twofold(const double* const (&p)[3], double& square) {
    const unsigned i = widest_corner(p);
    const double *const origin = p[i], *const a = p[(i + 1) % 3], *const b = p[(i + 2) % 3];
    const Rows<Twofold> r = twofold_difference(a, origin), s = twofold_difference(b, origin),
                        t = twofold_difference(a, b), n = normal(r, s);
    const Twofold rr = product(r, r), ss = product(s, s), tt = product(t, t), nn = product(n, n);
    if (!is_in_range(rr.high) || !is_in_range(ss.high) || !is_in_range(tt.high) ||
        !(rr.high * ss.high <= 0x1p80 * nn.high))
        return false;
    square = 0.25 * (rr * ss * tt / nn).high;
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
    return s != exact::undecided ? s : exact::facet_sphere_integer(a, b, c, q);
}

double facet_radius2(const double* const (&p)[3], int scale) {
    double square;
    if (exact::facet_radius2_plain(p, square) || exact::facet_radius2_twofold(p, square))
        return std::ldexp(square, -2 * scale);
    return exact::facet_radius2_integer(p, scale);
}

}  // namespace mgdt
