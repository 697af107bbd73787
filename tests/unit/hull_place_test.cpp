// SPDX-License-Identifier: MIT
// The nearest place of the hull, against all facets one by one, from wherever the walk begins.
#include "interpolation/hull_place.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "../support/points.hpp"
#include "../support/small.h"
#include "core/triangulation.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

using mgdt_tests::Points;
using P = std::array<double, 3>;

double dot(const P& a, const P& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
P operator-(const P& a, const P& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
P at(const double* x) {
    return {x[0], x[1], x[2]};
}

double distance_from_segment(const P& q, const P& a, const P& b) {
    const P e = b - a, w = q - a;
    const double s = std::min(std::max(dot(e, w) / dot(e, e), 0.0), 1.0);
    const P d = {w[0] - s * e[0], w[1] - s * e[1], w[2] - s * e[2]};
    return std::sqrt(dot(d, d));
}
double distance_from_triangle(const P& q, const P& a, const P& b, const P& c) {
    const P e = b - a, f = c - a, w = q - a;
    const double ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), ew = dot(e, w), fw = dot(f, w);
    const double whole = ee * ff - ef * ef, s = (ff * ew - ef * fw) / whole,
                 t = (ee * fw - ef * ew) / whole;
    if (s >= 0 && t >= 0 && s + t <= 1) {
        const P d = {w[0] - s * e[0] - t * f[0], w[1] - s * e[1] - t * f[1],
                     w[2] - s * e[2] - t * f[2]};
        return std::sqrt(dot(d, d));
    }
    return std::min({distance_from_segment(q, a, b), distance_from_segment(q, b, c),
                     distance_from_segment(q, c, a)});
}

void try_places(const Points& xyz, double size, std::mt19937& random, int places) {
    Triangulation t(nullptr, nullptr, nullptr);
    const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
    t.insert(xyz.size() / 3, axis, 3);
    const Mesh& mesh = t.mesh();
    ASSERT_EQ(mesh.scale, 0);
    int outside = 0;
    for (int k = 0; k < places; ++k) {
        double q[3];
        const double far = k % 3 == 0 ? 1.2 : k % 3 == 1 ? 4 : 100;
        // On a grid, so that q is often over edges and corners exactly.
        for (double& x : q) x = size * far * (static_cast<double>(random() % 129) / 64 - 1);
        double least = std::numeric_limits<double>::infinity();
        std::vector<TetId> beyond;
        for (TetId id = 0; id < mesh.tetrahedra.size(); ++id) {
            const Tetrahedron& g = mesh.tetrahedra[id];
            if (g.is_dead() || !g.is_ghost()) continue;
            const unsigned char* const facet = outer_face[g.infinite_slot()];
            const double *const a = mesh.point(g.v[facet[0]]), *const b = mesh.point(g.v[facet[1]]),
                                *const c = mesh.point(g.v[facet[2]]);
            least = std::min(least, distance_from_triangle(at(q), at(a), at(b), at(c)));
            if (orientation(q, a, b, c) < 0) beyond.push_back(id);
        }
        if (beyond.empty()) continue;
        ++outside;
        const HullPlace first = nearest_hull_place(mesh, q, beyond[0]);
        const P d = at(q) - at(first.x);
        EXPECT_NEAR(std::sqrt(dot(d, d)), least, 1e-13 * (size + least));
        double sum = 0;
        for (unsigned i = 0; i < 3; ++i) {
            EXPECT_GE(first.weight[i], 0);
            sum += first.weight[i];
        }
        EXPECT_NEAR(sum, 1, 1e-15);
        for (const TetId from : beyond) {
            const HullPlace again = nearest_hull_place(mesh, q, from);
            EXPECT_EQ(std::memcmp(&first, &again, sizeof first), 0);
        }
    }
    EXPECT_GT(outside, places / 3);
}

TEST(HullPlace, IsTheNearestOfAllFacets) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    const int places = is_small() ? 30 : 300;
    Points ball, lattice, needle, turned;
    for (int i = 0; i < 200; ++i) {
        P p;
        for (double& x : p) x = normal(random);
        for (const double x : p) {
            ball.push_back(x / std::sqrt(dot(p, p)));
            needle.push_back(x * (needle.size() % 3 == 0 ? 1 : 1e-3));
        }
        // A cube turned about z, whose faces are flat but for rounding.
        const double a = i % 6 - 2.5, b = i / 6 % 6 - 2.5, c = i / 36 - 2.5;
        lattice.insert(lattice.end(), {a, b, c});
        turned.insert(turned.end(), {.6 * a - .8 * b, .8 * a + .6 * b, c / 3});
    }
    try_places(ball, 1, random, places);
    try_places(lattice, 2.5, random, places);
    try_places(needle, 2, random, places);
    try_places(turned, 2.5, random, places);
    try_places({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 1, random, places);
}

using Rational = boost::multiprecision::cpp_rational;
using R = std::array<Rational, 3>;

Rational dot(const R& a, const R& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
R operator-(const R& a, const R& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
R exactly(const double* x) {
    return {Rational(x[0]), Rational(x[1]), Rational(x[2])};
}
// a + s e + t f
R sum(const R& a, const Rational& s, const R& e, const Rational& t, const R& f) {
    R x;
    for (std::size_t k = 0; k < 3; ++k) x[k] = a[k] + s * e[k] + t * f[k];
    return x;
}
R nearest_of_segment(const R& q, const R& a, const R& b) {
    const R e = b - a;
    Rational s = dot(e, q - a) / dot(e, e);
    s = s < 0 ? Rational(0) : s > 1 ? Rational(1) : s;
    return sum(a, s, e, 0, e);
}
R nearest_of_triangle(const R& q, const R& a, const R& b, const R& c) {
    const R e = b - a, f = c - a, w = q - a;
    const Rational ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), ew = dot(e, w), fw = dot(f, w),
                   whole = ee * ff - ef * ef, s = (ff * ew - ef * fw) / whole,
                   t = (ee * fw - ef * ew) / whole;
    if (s >= 0 && t >= 0 && s + t <= 1) return sum(a, s, e, t, f);
    R best = nearest_of_segment(q, a, b);
    for (const R& x : {nearest_of_segment(q, b, c), nearest_of_segment(q, c, a)})
        if (dot(q - x, q - x) < dot(q - best, q - best)) best = x;
    return best;
}

// The place has the error that is promised, for places beyond each facet: near it, by rounding
// only, and far.
void expect_bound(const Points& xyz, std::mt19937& random, std::size_t most) {
    Triangulation t(nullptr, nullptr, nullptr);
    const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
    t.insert(xyz.size() / 3, axis, 3);
    const Mesh& mesh = t.mesh();
    struct Facet {
        TetId ghost;
        const double* corner[3];
    };
    std::vector<Facet> facets;
    for (TetId id = 0; id < mesh.tetrahedra.size(); ++id) {
        const Tetrahedron& g = mesh.tetrahedra[id];
        if (g.is_dead() || !g.is_ghost()) continue;
        const unsigned char* const at = outer_face[g.infinite_slot()];
        facets.push_back(
            {id, {mesh.point(g.v[at[0]]), mesh.point(g.v[at[1]]), mesh.point(g.v[at[2]])}});
    }
    ASSERT_FALSE(facets.empty());
    std::size_t tried = 0;
    for (std::size_t i = 0; i < 20 * most && tried < most; ++i) {
        const Facet& facet = facets[random() % facets.size()];
        double q[3], share[3], all = 0;
        for (double& s : share) all += s = static_cast<double>(random() % 1000);
        if (all == 0) continue;
        const double away = i % 3 == 0 ? 0 : std::ldexp(1, -static_cast<int>(random() % 60));
        for (int k = 0; k < 3; ++k) {
            q[k] = 0;
            double size = 0;
            for (std::size_t j = 0; j < 3; ++j) {
                q[k] += share[j] / all * facet.corner[j][k];
                size = std::max(size, std::fabs(facet.corner[j][k]));
            }
            q[k] += away * size * (static_cast<double>(random() % 65) / 32 - 1);
        }
        if (orientation(q, facet.corner[0], facet.corner[1], facet.corner[2]) >= 0) continue;
        ++tried;
        const R of_q = exactly(q);
        R best{};
        Rational least = -1;
        for (const Facet& f : facets) {
            const R x = nearest_of_triangle(of_q, exactly(f.corner[0]), exactly(f.corner[1]),
                                            exactly(f.corner[2]));
            const Rational d = dot(of_q - x, of_q - x);
            if (least < 0 || d < least) {
                least = d;
                best = x;
            }
        }
        const HullPlace place = nearest_hull_place(mesh, q, facet.ghost);
        double extent = 0;
        for (unsigned j = 0; j < place.size; ++j)
            for (int k = 0; k < 3; ++k)
                extent = std::max(extent, std::fabs(mesh.point(place.corner[j])[k] -
                                                    mesh.point(place.corner[0])[k]));
        R mean = {0, 0, 0};
        for (unsigned j = 0; j < place.size; ++j)
            mean =
                sum(mean, Rational(place.weight[j]), exactly(mesh.point(place.corner[j])), 0, mean);
        for (std::size_t k = 0; k < 3; ++k) {
            const Rational bound = Rational(0x1p-50) * Rational(extent) +
                                   Rational(0x1p-53) * abs(Rational(place.x[k])) +
                                   Rational(std::numeric_limits<double>::denorm_min());
            EXPECT_LE(abs(Rational(place.x[k]) - best[k]), bound);
            // The weights have it too, but that their sum is rounded.
            EXPECT_LE(abs(mean[k] - best[k]), 4 * bound + Rational(0x1p-50) * abs(best[k]));
        }
    }
    EXPECT_GT(tried, most / 4);
}

TEST(HullPlace, IsNearWhereTheExactOneIs) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    const std::size_t most = is_small() ? 5 : 60;
    // A needle among the facets, whose Gram determinant cancels.
    const Points needle = {0.18214803790146344, 0.7583082191422585, 1.2813238220957044,
                           0.42098216018286494, 0.9027685799819729, 1.0643227479505928,
                           0.42098216018286494, 0.8288885283166381, 1.3031568702319944,
                           0.6598162824642665,  0.8994688374910174, 1.3249899183682847};
    Triangulation t(nullptr, nullptr, nullptr);
    const double* const axis[3] = {needle.data(), needle.data() + 1, needle.data() + 2};
    t.insert(4, axis, 3);
    const double q[3] = {0.5233396411606084, 0.8591372322485149, 1.3125138908618332};
    for (TetId id = 0; id < t.mesh().tetrahedra.size(); ++id) {
        const Tetrahedron& g = t.mesh().tetrahedra[id];
        if (g.is_dead() || !g.is_ghost()) continue;
        const unsigned char* const at = outer_face[g.infinite_slot()];
        if (orientation(q, t.mesh().point(g.v[at[0]]), t.mesh().point(g.v[at[1]]),
                        t.mesh().point(g.v[at[2]])) >= 0)
            continue;
        const HullPlace place = nearest_hull_place(t.mesh(), q, id);
        ASSERT_EQ(place.size, 3u);
        EXPECT_NEAR(place.weight[0], 0.17112, 1e-5);
        EXPECT_NEAR(place.weight[1], 0.22919, 1e-5);
        EXPECT_NEAR(place.weight[2], 0.59969, 1e-5);
    }
    expect_bound(needle, random, most);
    // A block that is turned about two axes: its faces are flat but for rounding.
    Points block, cap, thin;
    const double c = std::cos(.3), s = std::sin(.3);
    for (int i = 0; i < 125; ++i) {
        const double x = i % 5, y = i / 5 % 5, z = i / 25;
        const double u = c * x - s * y, v = s * x + c * y;
        block.insert(block.end(), {u, c * v - s * z, s * v + c * z});
    }
    for (int i = 0; i < 40; ++i) {
        P p;
        for (double& x : p) x = normal(random);
        // Nearly one plane, and nearly one line.
        cap.insert(cap.end(), {p[0], p[1], 1e-12 * (p[0] * p[0] + p[1] * p[1]) + p[0] / 3});
        thin.insert(thin.end(), {p[0], p[0] / 3 + 1e-14 * p[1], p[0] / 7 + 1e-14 * p[2]});
    }
    expect_bound(block, random, most);
    expect_bound(cap, random, most);
    expect_bound(thin, random, most);
    for (const double size : {1e-300, 1e-200, 1e150, 1e300})
        for (Points xyz : {needle, thin, cap}) {
            for (double& x : xyz) x *= size;
            expect_bound(xyz, random, most / 5);
        }
}

}  // namespace
}  // namespace mgdt
