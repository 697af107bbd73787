// SPDX-License-Identifier: MIT
// Circumcentres against ratios of unlimited integers, for tetrahedra as flat as doubles allow and
// of any size, by each stage.
#include "predicates/circumcenter.hpp"

#include <gtest/gtest.h>

#include "../support/reproduction.h"
#include "exact_reference.hpp"
#include "point_families.hpp"
#include "predicates/differences.hpp"

namespace {

using families::Random;
using mgdt::Circumcenter;
using mgdt::exact::CircumcenterBounds;
using reference::Big;
using reference::Point;
using Four = std::array<Point, 4>;

constexpr double infinity = std::numeric_limits<double>::infinity();

// x in units of 2^-1074; infinity as the number after the largest.
Big in_least_units(double x) {
    if (std::isinf(x)) return x < 0 ? Big(-(Big(1) << 2098)) : Big(Big(1) << 2098);
    int e;
    const double m = std::frexp(std::fabs(x), &e);
    Big units = static_cast<long long>(std::ldexp(m, 53));
    const int shift = e - 53 + 1074;
    if (shift >= 0)
        units <<= shift;
    else
        units >>= -shift;
    return x < 0 ? Big(-units) : units;
}

// Whether x is the double nearest to n / d in units of 2^unit, ties to even; d is positive.
bool is_nearest(double x, Big n, Big d, int unit) {
    const int shift = unit + 1075;
    if (shift >= 0)
        n <<= shift;
    else
        d <<= -shift;
    // What is half way to the next numbers, times d.
    const auto half = [&](double towards) -> Big {
        return (in_least_units(x) + in_least_units(std::nextafter(x, towards))) * d;
    };
    const bool is_even = (mgdt::exact::bits_of(x) & 1) == 0;
    if (x != infinity) {
        const Big above = half(infinity);
        if (n > above || (n == above && !is_even)) return false;
    }
    if (x != -infinity) {
        const Big below = half(-infinity);
        if (n < below || (n == below && !is_even)) return false;
    }
    return true;
}

struct Reference {
    Big numerator[3], radius2, determinant;  // twice the determinant of the differences

    // Of the tetrahedron after the translation of its first vertex to `first`, if that is given.
    explicit Reference(Four& four, Point* first = nullptr) {
        Big p[4][3];
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < 3; ++k) p[i][k] = in_least_units(four[i][k]);
        Big r[3][3], square[3];
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 3; ++k) {
                r[i][k] = p[i + 1][k] - p[0][k];
                square[i] += r[i][k] * r[i][k];
            }
        }
        // Cramer's rule for 2 r.c = |r|^2.
        const auto det = [](const Big* a, const Big* b, const Big* c) -> Big {
            return a[0] * (b[1] * c[2] - b[2] * c[1]) - b[0] * (a[1] * c[2] - a[2] * c[1]) +
                   c[0] * (a[1] * b[2] - a[2] * b[1]);
        };
        Big columns[3][3];
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t i = 0; i < 3; ++i) columns[k][i] = r[i][k];
        determinant = 2 * det(columns[0], columns[1], columns[2]);
        Big centre[3], place[3];
        for (std::size_t k = 0; k < 3; ++k)
            place[k] = first != nullptr ? in_least_units((*first)[k]) : p[0][k];
        for (std::size_t k = 0; k < 3; ++k) {
            const Big* c[3] = {columns[0], columns[1], columns[2]};
            c[k] = square;
            centre[k] = det(c[0], c[1], c[2]);
            radius2 += centre[k] * centre[k];
            numerator[k] = centre[k] + place[k] * determinant;
        }
        if (determinant >= 0) return;
        determinant = -determinant;
        for (Big& n : numerator) n = -n;
        std::swap(four[first != nullptr ? 2 : 0], four[first != nullptr ? 3 : 1]);
    }
    bool is_met_by(const Circumcenter& c, int scale) const {
        for (std::size_t k = 0; k < 3; ++k)
            if (!is_nearest(c.x[k], numerator[k], determinant, -1074 - scale)) return false;
        return is_nearest(c.radius2, radius2, determinant * determinant, 2 * (-1074 - scale));
    }
};

bool refined(const Four& f, Circumcenter& c, int scale = 0,
             const CircumcenterBounds& bounds = mgdt::exact::circumcenter_bounds) {
    return mgdt::exact::circumcenter_refined({f[0].data(), f[1].data(), f[2].data(), f[3].data()},
                                             f[0].data(), scale, c, bounds);
}
bool bounded(const Four& f, Circumcenter& c, int scale = 0) {
    return mgdt::exact::circumcenter_bounded({f[0].data(), f[1].data(), f[2].data(), f[3].data()},
                                             f[0].data(), scale, c);
}
Circumcenter integer(const Four& f, int least_width, int scale = 0) {
    Circumcenter c;
    mgdt::exact::circumcenter_integer({f[0].data(), f[1].data(), f[2].data(), f[3].data()},
                                      f[0].data(), scale, c, least_width);
    return c;
}

std::string text(const Four& f) {
    std::string s;
    char number[40];
    for (const Point& p : f)
        for (const double x : p) s += (std::snprintf(number, sizeof number, "%a ", x), number);
    return s;
}

// Random, on a lattice, flat, near a sphere or a line, of any exponents.
Four any(Random& random, unsigned kind) {
    Four f;
    const double flatness = std::ldexp(1.0, -random.integer(0, 49));
    for (Point& p : f)
        for (std::size_t k = 0; k < 3; ++k) {
            double x = random.uniform() - 0.5;
            switch (kind % 6) {
                case 1:
                    x = std::floor(x * 16);
                    break;
                case 2:
                    x = k == 2 ? x * flatness : x;
                    break;
                case 3:
                    x = k == 0 ? x : 1e3 + x * flatness;
                    break;
                case 4:
                    x = std::ldexp(x, random.integer(-1070, 1020));
                    break;
                case 5:
                    x = std::ldexp(std::floor(x * 64), -1074);
                    break;
                default:
                    break;
            }
            p[k] = x;
        }
    return f;
}

TEST(Circumcenter, IsTheNearestDouble) {
    Random random(1);
    const int n = is_small() ? 60 : 3000;
    int decided[6] = {}, by_bounds[6] = {}, all[6] = {};
    for (int i = 0; i < n; ++i) {
        const auto kind = static_cast<unsigned>(i % 6);
        Four f = any(random, kind);
        const Reference reference(f);
        if (reference.determinant == 0) continue;
        Circumcenter c;
        ++all[kind];
        if (refined(f, c)) {
            ++decided[kind];
            ASSERT_TRUE(reference.is_met_by(c, 0)) << text(f);
        }
        if (bounded(f, c)) {
            ++by_bounds[kind];
            ASSERT_TRUE(reference.is_met_by(c, 0)) << text(f);
        }
        ASSERT_TRUE(reference.is_met_by(integer(f, 0), 0)) << text(f);
        if (i % 10 == 0)
            for (const int width : mgdt::exact::widths) {
                ASSERT_TRUE(reference.is_met_by(integer(f, width), 0)) << text(f) << width;
            }
    }
    EXPECT_GT(decided[0], all[0] * 9 / 10);
    EXPECT_GT(decided[1], all[1] / 2);
    EXPECT_GT(decided[2], all[2] / 3);
    EXPECT_EQ(decided[5], 0);
    for (const int kind : {0, 2, 3}) EXPECT_GT(by_bounds[kind], all[kind] * 9 / 10);
    EXPECT_GT(by_bounds[4], all[4] / 2);  // results that are subnormal are left open
}

// Coordinates that carry a factor: the result is that of the points without it, down to subnormals.
TEST(Circumcenter, IsThatOfUnscaledPoints) {
    Random random(2);
    for (int i = 0; i < (is_small() ? 40 : 1000); ++i) {
        Four f = any(random, static_cast<unsigned>(i % 3));
        const int scale = random.integer(-1100, 1200);
        const Reference reference(f);
        if (reference.determinant == 0) continue;
        Circumcenter c;
        if (refined(f, c, scale)) {
            ASSERT_TRUE(reference.is_met_by(c, scale)) << text(f) << scale;
        }
        if (bounded(f, c, scale)) {
            ASSERT_TRUE(reference.is_met_by(c, scale)) << text(f) << scale;
        }
        ASSERT_TRUE(reference.is_met_by(integer(f, 0, scale), scale)) << text(f) << scale;
    }
}

// A tetrahedron that is translated so far that its other vertices are no doubles there.
TEST(Circumcenter, IsThatOfTheTranslatedTetrahedron) {
    Random random(7);
    int decided = 0, all = 0;
    for (int i = 0; i < (is_small() ? 60 : 2000); ++i) {
        Four f = any(random, static_cast<unsigned>(i % 5));
        Point first = random.in_cube(-1, 1);
        for (double& x : first) x = std::ldexp(x, random.integer(-3, 40));
        const int scale = i % 2 == 0 ? 0 : random.integer(-1000, 1000);
        const Reference reference(f, &first);
        if (reference.determinant == 0) continue;
        const double* const p[4] = {f[0].data(), f[1].data(), f[2].data(), f[3].data()};
        Circumcenter c;
        ++all;
        if (mgdt::exact::circumcenter_refined(p, first.data(), scale, c)) {
            ++decided;
            ASSERT_TRUE(reference.is_met_by(c, scale)) << text(f);
        }
        if (mgdt::exact::circumcenter_bounded(p, first.data(), scale, c)) {
            ASSERT_TRUE(reference.is_met_by(c, scale)) << text(f);
        }
        c = mgdt::translated_circumcenter(p, first.data(), scale);
        ASSERT_TRUE(reference.is_met_by(c, scale)) << text(f);
        mgdt::exact::circumcenter_integer(p, first.data(), scale, c);
        ASSERT_TRUE(reference.is_met_by(c, scale)) << text(f);
    }
    EXPECT_GT(decided, all / 4);
}

TEST(CenterOffset, StagesAgree) {
    Random random(6);
    int known = 0, all = 0;
    for (int i = 0; i < (is_small() ? 60 : 3000); ++i) {
        Four f = any(random, static_cast<unsigned>(i % 5));
        if (Reference(f).determinant == 0) continue;
        const double* const p[4] = {f[0].data(), f[1].data(), f[2].data(), f[3].data()};
        double offset[3], exact[3], largest = 0;
        mgdt::exact::center_offset_integer(p, exact);
        for (const double x : exact) largest = std::fmax(largest, std::fabs(x));
        ++all;
        if (!mgdt::exact::center_offset_bounded(p, offset)) continue;
        ++known;
        for (std::size_t k = 0; k < 3; ++k) {
            const double tolerance = mgdt::center_offset_error * largest;
            ASSERT_TRUE(offset[k] == exact[k] || std::fabs(offset[k] - exact[k]) <= tolerance)
                << text(f);
        }
    }
    EXPECT_GT(known, all * 8 / 10);
}

// A centre that is a little below a double, which times 2^-1022 is half way to the least normal
// number.
TEST(Circumcenter, IsRoundedOnceToASubnormal) {
    const double x = 2 - 0x1p-52;
    Four f = {{{0, 0, 0}, {x, 0x1p-80, 0}, {0, 2, 0}, {0, 0, 2}}};
    const Reference reference(f);
    const Circumcenter c =
        mgdt::circumcenter({f[0].data(), f[1].data(), f[2].data(), f[3].data()}, 1022);
    EXPECT_EQ(c.x[0], std::nextafter(std::numeric_limits<double>::min(), 0.0));
    EXPECT_TRUE(reference.is_met_by(c, 1022));
}

TEST(Circumcenter, DoesNotDependOnTheOrder) {
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        Four f = any(random, static_cast<unsigned>(i % 4));
        if (Reference(f).determinant == 0) continue;
        const auto of = [](const Four& g) {
            return mgdt::circumcenter({g[0].data(), g[1].data(), g[2].data(), g[3].data()});
        };
        const Circumcenter c = of(f), d = of({f[1], f[2], f[0], f[3]}),
                           e = of({f[2], f[3], f[0], f[1]});
        for (const Circumcenter& other : {d, e}) {
            for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(c.x[k], other.x[k]);
            EXPECT_EQ(c.radius2, other.radius2);
        }
    }
}

// With a bound that is too small the refined stage rounds wrongly.
TEST(Circumcenter, BoundOfTheSolutionIsNeeded) {
    Random random(4);
    int wrong = 0;
    for (int i = 0; i < 20000 && wrong == 0; ++i) {
        Four f = any(random, 0);
        const double flatness = std::ldexp(1.0, -random.integer(20, 40));
        for (Point& p : f) p[2] = p[0] + p[1] + p[2] * flatness;
        if (Reference(f).determinant == 0) continue;
        Circumcenter c;
        if (refined(f, c, 0, {0, mgdt::exact::circumcenter_bounds.residual})) {
            const Circumcenter exact = integer(f, 0);
            for (std::size_t k = 0; k < 3; ++k) wrong += c.x[k] != exact.x[k];
        }
    }
    EXPECT_GT(wrong, 0);
}

// Near the solution, where the terms cancel. A three hundredth of the bound does not hold.
TEST(Circumcenter, BoundOfTheResidual) {
    Random random(5);
    int beyond_a_part = 0;
    for (int i = 0; i < (is_small() ? 2000 : 20000); ++i) {
        const Point p = random.in_cube(-1, 1), origin = random.in_cube(-1, 1);
        double w[3], r[3], square = 0, l = 0, m = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            w[k] = random.uniform(-2, 2);
            r[k] = p[k] - origin[k];
            square += r[k] * r[k];
        }
        w[2] = (square - w[0] * r[0] - w[1] * r[1]) / r[2];
        Big exact = 0;  // in units of 2^-2148
        for (std::size_t k = 0; k < 3; ++k) {
            const Big d = in_least_units(p[k]) - in_least_units(origin[k]);
            exact += d * (d - in_least_units(w[k]));
            l = std::max(l, std::fabs(r[k]));
            m = std::max(m, std::fabs(w[k]));
        }
        const double found = mgdt::exact::sphere_residual(p.data(), origin.data(), w);
        const Big error = abs(Big(in_least_units(found) << 1074) - exact);
        const Big of_rounding = abs(exact) >> 53;
        const double bound = mgdt::exact::sphere_residual_bound * 0x1p-106 * l * (l + m);
        const Big allowed = Big(in_least_units(bound) << 1074);
        ASSERT_LE(error, allowed + of_rounding);
        beyond_a_part += error > allowed / 300 + of_rounding;
    }
    EXPECT_GT(beyond_a_part, 0);
}

}  // namespace
