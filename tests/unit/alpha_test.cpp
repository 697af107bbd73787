// SPDX-License-Identifier: MIT
// Alphas of simplices beside their definition in rational numbers, the surface of alpha shapes, and
// the stages of the predicate that decides which facets are attached.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "../support/points.hpp"
#include "../support/small.h"
#include "mgdt/mgdt.hpp"
#include "predicates/facet_sphere.hpp"
#include "predicates/filter.hpp"

namespace mgdt {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using mgdt_tests::lattice;
using mgdt_tests::Points;
using mgdt_tests::scaled;
using mgdt_tests::uniform;
struct V {
    Rational x[3];
    friend V operator-(const V& a, const V& b) {
        return {{a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2]}};
    }
    friend V operator+(const V& a, const V& b) {
        return {{a.x[0] + b.x[0], a.x[1] + b.x[1], a.x[2] + b.x[2]}};
    }
};
V times(const Rational& s, const V& a) {
    return {{s * a.x[0], s * a.x[1], s * a.x[2]}};
}
Rational dot(const V& a, const V& b) {
    return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}
V cross(const V& a, const V& b) {
    return {{a.x[1] * b.x[2] - a.x[2] * b.x[1], a.x[2] * b.x[0] - a.x[0] * b.x[2],
             a.x[0] * b.x[1] - a.x[1] * b.x[0]}};
}

struct Sphere {
    V center;
    Rational square;
};
// The least sphere through 2 to 4 points.
Sphere sphere(const std::vector<V>& p) {
    V offset = {{0, 0, 0}};
    const V a = p[1] - p[0];
    if (p.size() == 2) {
        offset = times(Rational(1) / 2, a);
    } else {
        const V b = p[2] - p[0], n = cross(a, b);
        if (p.size() == 3) {
            offset =
                times(1 / (2 * dot(n, n)), cross(times(dot(a, a), b) - times(dot(b, b), a), n));
        } else {
            const V c = p[3] - p[0];
            offset =
                times(1 / (2 * dot(n, c)), times(dot(a, a), cross(b, c)) +
                                               times(dot(b, b), cross(c, a)) + times(dot(c, c), n));
        }
    }
    return {p[0] + offset, dot(offset, offset)};
}

using Simplex = std::vector<std::int64_t>;

// The alphas of all simplices by the definition, every vertex looked at.
class Definition {
  public:
    Definition(const Points& xyz, const std::vector<std::array<std::int64_t, 4>>& tetrahedra) {
        for (std::size_t i = 0; i < xyz.size(); i += 3)
            points_.push_back({{xyz[i], xyz[i + 1], xyz[i + 2]}});
        for (const auto& t : tetrahedra) add(Simplex(t.begin(), t.end()));
        for (std::size_t size = 4; size >= 2; --size)
            for (auto& [simplex, alpha] : alphas_)
                if (simplex.size() == size) settle(simplex, alpha);
    }
    const Rational& operator[](Simplex simplex) const {
        std::sort(simplex.begin(), simplex.end());
        return alphas_.at(simplex);
    }
    std::size_t attached() const { return attached_; }

  private:
    void add(Simplex simplex) {
        std::sort(simplex.begin(), simplex.end());
        if (!alphas_.emplace(simplex, -1).second || simplex.size() == 2) return;
        for (std::size_t i = 0; i < simplex.size(); ++i) {
            Simplex face = simplex;
            face.erase(face.begin() + static_cast<std::ptrdiff_t>(i));
            above_[face].push_back(simplex);
            add(face);
        }
    }
    void settle(const Simplex& simplex, Rational& alpha) {
        std::vector<V> corners;
        for (const std::int64_t v : simplex)
            corners.push_back(points_[static_cast<std::size_t>(v)]);
        const Sphere s = sphere(corners);
        bool is_empty = true;
        for (const V& q : points_) is_empty &= dot(q - s.center, q - s.center) >= s.square;
        if (is_empty) {
            alpha = s.square;
            return;
        }
        ++attached_;
        for (const Simplex& of : above_[simplex])
            if (alpha < 0 || alphas_[of] < alpha) alpha = alphas_[of];
    }
    std::vector<V> points_;
    std::map<Simplex, Rational> alphas_;
    std::map<Simplex, std::vector<Simplex>> above_;
    std::size_t attached_ = 0;
};

std::vector<double> alphas_of(const Triangulation& t, std::int32_t dimension, std::size_t count) {
    std::vector<double> alphas(count);
    EXPECT_EQ(
        mgdt_get_alphas(t.handle(), dimension, static_cast<std::int64_t>(count), alphas.data()),
        MGDT_OK);
    return alphas;
}

void expect_near(double found, const Rational& exact) {
    if (exact > Rational(std::numeric_limits<double>::max())) {
        EXPECT_TRUE(std::isinf(found)) << found;
        return;
    }
    // A subnormal alpha is rounded to a multiple of the least number.
    if (exact < Rational(std::numeric_limits<double>::min())) {
        EXPECT_LE(abs(Rational(found) - exact),
                  Rational(2 * std::numeric_limits<double>::denorm_min()))
            << found;
        return;
    }
    EXPECT_LE(abs(Rational(found) - exact), exact * Rational(2e-14)) << found;
}

void compare(const Points& xyz) {
    for (const bool canonical : {false, true}) {
        if (is_small() && canonical) continue;
        Triangulation t;
        t.set_canonical_output(canonical);
        EXPECT_EQ(
            mgdt_insert_points(t.handle(), static_cast<std::int64_t>(xyz.size() / 3), xyz.data()),
            MGDT_OK);
        const auto tetrahedra = t.tetrahedra();
        const auto edges = t.edges();
        const Definition exact(xyz, tetrahedra);
        EXPECT_GT(exact.attached(), 0u);
        const auto of_tetrahedra = alphas_of(t, 3, tetrahedra.size()),
                   of_facets = alphas_of(t, 2, 4 * tetrahedra.size()),
                   of_edges = alphas_of(t, 1, edges.size());
        for (std::size_t k = 0; k < tetrahedra.size(); ++k) {
            const Simplex all(tetrahedra[k].begin(), tetrahedra[k].end());
            expect_near(of_tetrahedra[k], exact[all]);
            for (std::size_t i = 0; i < 4; ++i) {
                Simplex facet = all;
                facet.erase(facet.begin() + static_cast<std::ptrdiff_t>(i));
                expect_near(of_facets[4 * k + i], exact[facet]);
                EXPECT_LE(of_facets[4 * k + i], of_tetrahedra[k]);
            }
        }
        for (std::size_t e = 0; e < edges.size(); ++e)
            expect_near(of_edges[e], exact[{edges[e][0], edges[e][1]}]);
        for (const double alpha : alphas_of(t, 0, xyz.size() / 3)) EXPECT_EQ(alpha, 0);
    }
}

TEST(Alphas, AreThoseOfTheDefinition) {
    const std::size_t n = is_small() ? 8 : 30;
    compare(uniform(n));
    compare(lattice(3));
    compare(lattice(3, 0x1p200));
    compare(uniform(n, 1, 1, 1e-3, 1e-6));
    compare(uniform(n, 1, 1, 1e-9, 1e-9));
    compare(scaled(uniform(n), 1e-120));
    compare(scaled(uniform(n), 1e120));
}

// Some are beyond the range of doubles, and none is lost within it.
TEST(Alphas, OfPointsWhoseExponentsAreFarApart) {
    std::mt19937_64 random(6);
    for (const int most : {200, 700}) {
        if (is_small() && most > 200) break;
        Points xyz(is_small() ? 12 : 24);
        for (double& x : xyz)
            x = std::ldexp(static_cast<double>(random() >> 11) * 0x1p-53 - 0.5,
                           static_cast<int>(random() % (2 * static_cast<unsigned>(most))) - most);
        compare(xyz);
    }
    // Edges that are short beside the largest coordinate.
    Points xyz = {1e150, 0, 0, 0, 1e150, 0, 0, 0, -1e150};
    for (const double x : scaled(uniform(4), 1e-143)) xyz.push_back(x);
    compare(xyz);
}

// At each edge of a surface as many facets turn one way as the other.
TEST(AlphaSurface, IsClosed) {
    const Points xyz = uniform(400);
    Triangulation t;
    EXPECT_EQ(mgdt_insert_points(t.handle(), 400, xyz.data()), MGDT_OK);
    const auto tetrahedra = t.tetrahedra();
    const auto alphas = alphas_of(t, 3, tetrahedra.size());
    for (const double alpha2 : {0.0, 0.004, 0.01, 0.02, 1e9}) {
        std::vector<std::int64_t> v(12 * tetrahedra.size());
        std::int64_t count = -1;
        ASSERT_EQ(mgdt_get_alpha_surface(t.handle(), alpha2, static_cast<std::int64_t>(v.size()),
                                         v.data(), &count),
                  MGDT_OK);
        std::map<std::pair<std::int64_t, std::int64_t>, int> turns;
        const auto point = [&](std::int64_t k) { return &xyz[3 * static_cast<std::size_t>(k)]; };
        const auto volume = [&](const double* a, const double* b, const double* c) {
            return (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                    a[2] * (b[0] * c[1] - b[1] * c[0])) /
                   6;
        };
        double inside = 0, around = 0;
        for (std::size_t f = 0; f < static_cast<std::size_t>(count); ++f) {
            const std::int64_t* const facet = &v[3 * f];
            EXPECT_LT(facet[0], std::min(facet[1], facet[2]));
            around += volume(point(facet[0]), point(facet[1]), point(facet[2]));
            for (std::size_t i = 0; i < 3; ++i) {
                const std::int64_t a = facet[i], b = facet[(i + 1) % 3];
                turns[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : -1;
            }
        }
        for (const auto& [edge, sum] : turns) EXPECT_EQ(sum, 0);
        for (std::size_t k = 0; k < tetrahedra.size(); ++k) {
            if (alphas[k] > alpha2) continue;
            double relative[3][3];
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    relative[i][axis] =
                        point(tetrahedra[k][i + 1])[axis] - point(tetrahedra[k][0])[axis];
            inside += volume(relative[0], relative[1], relative[2]);
        }
        EXPECT_NEAR(inside, around, 1e-12);
    }
}

// The least alpha with one solid and all vertices, found by trying all.
TEST(SolidAlpha, IsTheLeastOne) {
    for (const std::size_t n : {4u, 5u, 30u, 200u}) {
        const Points xyz = uniform(n);
        Triangulation t;
        EXPECT_EQ(mgdt_insert_points(t.handle(), static_cast<std::int64_t>(n), xyz.data()),
                  MGDT_OK);
        const auto tetrahedra = t.tetrahedra();
        const auto neighbors = t.neighbors();
        const auto alphas = alphas_of(t, 3, tetrahedra.size());
        double least = 1e300;
        for (const double alpha2 : alphas) {
            std::set<std::int64_t> vertices;
            std::vector<std::size_t> stack;
            std::vector<bool> is_in(alphas.size(), false);
            std::size_t in = 0, reached = 0;
            for (std::size_t k = 0; k < alphas.size(); ++k) {
                if (alphas[k] > alpha2) continue;
                ++in;
                vertices.insert(tetrahedra[k].begin(), tetrahedra[k].end());
                if (in == 1) stack.push_back(k), is_in[k] = true;
            }
            while (!stack.empty()) {
                const std::size_t k = stack.back();
                stack.pop_back();
                ++reached;
                for (const std::int64_t other : neighbors[k]) {
                    const auto o = static_cast<std::size_t>(other);
                    if (other < 0 || is_in[o] || alphas[o] > alpha2) continue;
                    is_in[o] = true;
                    stack.push_back(o);
                }
            }
            if (reached == in && vertices.size() == n) least = std::min(least, alpha2);
        }
        double found = -1;
        EXPECT_EQ(mgdt_get_solid_alpha(t.handle(), &found), MGDT_OK);
        EXPECT_EQ(found, least);
    }
}

TEST(FacetSphere, StagesAgree) {
    std::mt19937_64 random(2);
    const auto coordinate = [&](int bits) {
        return std::ldexp(static_cast<double>(random() >> (64 - bits)), -bits);
    };
    int known = 0, by_bounds = 0, wide = 0;
    for (int i = 0; i < (is_small() ? 400 : 2000); ++i) {
        double p[4][3];
        const int bits = i % 2 == 0 ? 53 : 3;
        const bool is_wide = i % 10 == 0;
        for (auto& point : p)
            for (double& x : point)
                x = std::ldexp(coordinate(bits), is_wide ? static_cast<int>(random() % 300) : 0);
        std::vector<V> corners;
        for (int k = 0; k < 3; ++k) corners.push_back({{p[k][0], p[k][1], p[k][2]}});
        const V n = cross(corners[1] - corners[0], corners[2] - corners[0]),
                q = {{p[3][0], p[3][1], p[3][2]}};
        if (dot(n, n) == 0 || dot(n, q - corners[0]) == 0) continue;
        const Sphere s = sphere(corners);
        const Rational excess = s.square - dot(q - s.center, q - s.center);
        const int expected = excess > 0 ? 1 : excess < 0 ? -1 : 0;
        EXPECT_EQ(exact::facet_sphere_integer(p[0], p[1], p[2], p[3]), expected);
        EXPECT_EQ(exact::facet_sphere_integer(p[0], p[1], p[2], p[3], 511), expected);
        const int filtered = exact::facet_sphere_filter(p[0], p[1], p[2], p[3]);
        if (filtered != exact::undecided) {
            EXPECT_EQ(filtered, expected);
            ++known;
        }
        const int bounded = exact::facet_sphere_bounded(p[0], p[1], p[2], p[3]);
        if (bounded != exact::undecided) {
            EXPECT_EQ(bounded, expected);
            ++by_bounds;
        }
        double square = 0;
        if (is_wide) {
            // The square itself may be no double.
            constexpr int scale = 300;
            const Rational small =
                s.square / Rational(boost::multiprecision::cpp_int(1) << (2 * scale));
            if (!exact::facet_radius2_bounded({p[0], p[1], p[2]}, scale, square)) continue;
            EXPECT_LE(abs(Rational(square) - small), small * Rational(facet_radius_error));
            ++wide;
            continue;
        }
        ASSERT_TRUE(exact::facet_radius2_bounded({p[0], p[1], p[2]}, 0, square));
        EXPECT_LE(abs(Rational(square) - s.square), s.square * Rational(facet_radius_error));
        if (exact::facet_radius2_plain({p[0], p[1], p[2]}, square)) {
            EXPECT_LE(abs(Rational(square) - s.square), s.square * Rational(facet_radius_error));
        }
        if (exact::facet_radius2_twofold({p[0], p[1], p[2]}, square)) {
            EXPECT_LE(abs(Rational(square) - s.square), s.square * Rational(0x1p-52));
        }
        square = exact::facet_radius2_integer({p[0], p[1], p[2]}, 0);
        EXPECT_LE(abs(Rational(square) - s.square), s.square * Rational(0x1p-53));
        EXPECT_EQ(exact::facet_radius2_integer({p[0], p[1], p[2]}, 3, 511), square * 0x1p-6);
    }
    EXPECT_GT(known, (is_small() ? 200 : 1000));
    EXPECT_GT(by_bounds, (is_small() ? 300 : 1500));  // lattices have points on spheres
    EXPECT_GT(wide, (is_small() ? 20 : 100));
}

}  // namespace
}  // namespace mgdt
