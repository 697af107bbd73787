// SPDX-License-Identifier: MIT
// The stages of the predicates one by one: each is right or passes the question on, each is
// reached, and each filter's constant is needed.
#include <gtest/gtest.h>

#include "exact_reference.hpp"
#include "point_families.hpp"
#include "predicates/determinants.hpp"
#include "predicates/lattice.hpp"
#include "predicates/native_integer.hpp"
#include "predicates/predicates.hpp"
#include "predicates/sparse.hpp"
#include "predicates/stages.hpp"

namespace {

using families::Five;
using families::Random;
using mgdt::exact::Bound;
using mgdt::exact::Terms;
using mgdt::exact::undecided;
using mgdt::exact::widths;

const families::Family& family(const std::string& name) {
    for (const auto& f : families::all()) {
        if (f.name == name) return f;
    }
    throw std::invalid_argument(name);
}

TEST(Stages, AgreeOnEveryFamily) {
    Random random(3);
    for (const auto& f : families::all()) {
        SCOPED_TRACE(f.name);
        for (int i = 0; i < reference::cases(200); ++i) {
            const Five p = f.make(random);
            const double *a = p[0].data(), *b = p[1].data(), *c = p[2].data(), *d = p[3].data(),
                         *q = p[4].data();
            const int sphere = reference::side_of_sphere(p[0], p[1], p[2], p[3], p[4]);
            const int solid = reference::orientation(p[0], p[1], p[2], p[3]);
            const bool line = reference::collinear(p[0], p[1], p[2]);
            const int nearer = reference::compare_distance(p[0], p[1], p[2]);
            const auto right = [](int s, int expected) { return s == expected || s == undecided; };
            EXPECT_TRUE(right(mgdt::exact::sphere_filter(a, b, c, d, q), sphere));
            EXPECT_TRUE(right(mgdt::exact::sphere_lattice(a, b, c, d, q), sphere));
            EXPECT_TRUE(right(mgdt::exact::orientation_filter(a, b, c, d), solid));
            EXPECT_TRUE(right(mgdt::exact::sphere_native(a, b, c, d, q), sphere));
            EXPECT_TRUE(right(mgdt::exact::orientation_lattice(a, b, c, d), solid));
            EXPECT_TRUE(right(mgdt::exact::orientation_native(a, b, c, d), solid));
            EXPECT_TRUE(right(mgdt::exact::collinear_filter(a, b, c), line ? undecided : 1));
            EXPECT_TRUE(right(mgdt::exact::distance_filter(a, b, c), nearer));
            EXPECT_TRUE(right(mgdt::exact::sphere_scaled(a, b, c, d, q), sphere));
            EXPECT_TRUE(right(mgdt::exact::sphere_ranged(a, b, c, d, q), sphere));
            EXPECT_TRUE(right(mgdt::exact::orientation_scaled(a, b, c, d), solid));
            EXPECT_TRUE(right(mgdt::exact::orientation_ranged(a, b, c, d), solid));
            EXPECT_TRUE(right(mgdt::exact::distance_ranged(a, b, c), nearer));
            EXPECT_TRUE(right(mgdt::exact::collinear_ranged(a, b, c), line ? 0 : 1));
            for (const Terms terms : {Terms::single, Terms::any}) {
                EXPECT_TRUE(
                    right(mgdt::exact::sphere_sparse(a, b, c, d, q, terms, nullptr, 0), sphere));
                EXPECT_TRUE(right(mgdt::exact::orientation_sparse(a, b, c, d, terms, 0), solid));
            }
            const int longer = reference::compare_lengths(p[0], p[1], p[2], p[3]);
            const int inside = reference::side_of_diametral_sphere(p[0], p[1], p[2]);
            EXPECT_TRUE(right(mgdt::exact::lengths_filter(a, b, c, d), longer));
            EXPECT_TRUE(right(mgdt::exact::diametral_filter(a, b, c), inside));
            EXPECT_EQ(mgdt::compare_lengths(a, b, c, d), longer);
            EXPECT_EQ(mgdt::side_of_diametral_sphere(a, b, c), inside);
            const int beside = reference::side_of_edge(p[0], p[1], p[2], p[3]);
            EXPECT_TRUE(right(mgdt::exact::edge_filter(a, b, c, d), beside));
            EXPECT_EQ(mgdt::side_of_edge(a, b, c, d), beside);
            for (int width : widths) {
                EXPECT_EQ(mgdt::exact::edge_integer(a, b, c, d, width), beside) << width;
                EXPECT_EQ(mgdt::exact::lengths_integer(a, b, c, d, width), longer) << width;
                EXPECT_EQ(mgdt::exact::diametral_integer(a, b, c, width), inside) << width;
                EXPECT_EQ(mgdt::exact::sphere_integer(a, b, c, d, q, width), sphere) << width;
                EXPECT_EQ(mgdt::exact::orientation_integer(a, b, c, d, width), solid) << width;
                EXPECT_EQ(mgdt::exact::collinear_integer(a, b, c, width), line) << width;
                EXPECT_EQ(mgdt::exact::distance_integer(a, b, c, width), nearer) << width;
            }
        }
    }
}

TEST(Stages, FilterDecidesGenericPoints) {
    Random random(4);
    int sphere = 0, solid = 0, line = 0, distance = 0;
    for (int i = 0; i < 500; ++i) {
        const Five p = family("uniform").make(random);
        sphere += mgdt::exact::sphere_filter(p[0].data(), p[1].data(), p[2].data(), p[3].data(),
                                             p[4].data()) == undecided;
        solid += mgdt::exact::orientation_filter(p[0].data(), p[1].data(), p[2].data(),
                                                 p[3].data()) == undecided;
        line += mgdt::exact::collinear_filter(p[0].data(), p[1].data(), p[2].data()) == undecided;
        distance +=
            mgdt::exact::distance_filter(p[0].data(), p[1].data(), p[2].data()) == undecided;
    }
    EXPECT_EQ(sphere, 0);
    EXPECT_EQ(solid, 0);
    EXPECT_EQ(line, 0);
    EXPECT_EQ(distance, 0);
}

TEST(Stages, LatticeDecidesItsTies) {
    Random random(5);
    int ties = 0;
    for (const char* name : {"lattice 3", "rounded to 1/1024, far off"}) {
        for (int i = 0; i < 2000; ++i) {
            const Five p = family(name).make(random);
            const double *a = p[0].data(), *b = p[1].data(), *c = p[2].data(), *d = p[3].data(),
                         *q = p[4].data();
            if (p[0] == p[1] && p[1] == p[2] && p[2] == p[3] && p[3] == p[4]) continue;
            EXPECT_NE(mgdt::exact::sphere_lattice(a, b, c, d, q), undecided);
            if (p[0] != p[1] || p[1] != p[2] || p[2] != p[3]) {
                EXPECT_NE(mgdt::exact::orientation_lattice(a, b, c, d), undecided);
            }
            ties += mgdt::exact::sphere_lattice(a, b, c, d, q) == 0;
        }
    }
    EXPECT_GT(ties, 200);
}

// The widest differences that the lattice stages take, and the first beyond.
TEST(Stages, LatticeEndsWhereDoublesEnd) {
    const auto sphere = [](double m, double unit, double odd) {
        m *= unit;
        const double a[] = {m, -m, m}, b[] = {-m, m, m}, c[] = {m, m, -m}, d[] = {-m, -m, -m};
        const double q[] = {odd * unit, 0, 0};
        const int s = mgdt::exact::sphere_lattice(a, b, c, d, q);
        EXPECT_TRUE(s == undecided || s == mgdt::exact::sphere_integer(a, b, c, d, q));
        return s != undecided;
    };
    const auto solid = [](double m, double unit, double odd) {
        m *= unit;
        const double a[] = {odd * unit, 0, 0}, b[] = {m, -m, m}, c[] = {-m, m, m}, d[] = {m, m, -m};
        const int s = mgdt::exact::orientation_lattice(a, b, c, d);
        EXPECT_TRUE(s == undecided || s == mgdt::exact::orientation_integer(a, b, c, d));
        return s != undecided;
    };
    for (double unit : {1.0, 0x1p-180, 0x1p160}) {
        EXPECT_TRUE(sphere(0x1p9 - 2, unit, 1));
        EXPECT_FALSE(sphere(0x1p9 - 2, unit, 0.5));
        EXPECT_FALSE(sphere(0x1p9, unit, 1));
        EXPECT_TRUE(solid(0x1p16 - 2, unit, 1));
        EXPECT_FALSE(solid(0x1p16 - 2, unit, 0.5));
        EXPECT_FALSE(solid(0x1p16, unit, 1));
    }
    EXPECT_FALSE(sphere(1, 0x1p-181, 0));
    EXPECT_FALSE(sphere(1, 0x1p181, 0));
    // Coordinates so large that the sum with the shifter has another exponent.
    for (double far : {-0x1p52, 0x1p52, -0x1p53, 0x1p53, -0x1p54, 0x1p54}) {
        const double x = far + 1;  // where far is large enough, far itself
        const double a[] = {far, 0, 0}, b[] = {x, 1, 0}, c[] = {far, 1, 1}, d[] = {x, 0, 1};
        const double q[] = {x, 1, 1};
        const int s = mgdt::exact::sphere_lattice(a, b, c, d, q);
        EXPECT_TRUE(s == undecided || s == mgdt::exact::sphere_integer(a, b, c, d, q)) << far;
    }
    // Differences that are not exact, although their rounded values are multiples of one unit.
    const double a[] = {1, 0, 0}, b[] = {0, 1, 0}, c[] = {0, 0, 1}, d[] = {1, 1, 1};
    const double q[] = {0x1p-60, 0, 0};
    EXPECT_EQ(mgdt::exact::sphere_lattice(a, b, c, d, q), undecided);
    EXPECT_EQ(mgdt::exact::orientation_lattice(q, a, b, c), undecided);
    const double e[] = {0x1p-60, 1, 1};  // the same with the small coordinate in front
    EXPECT_EQ(mgdt::exact::sphere_lattice(e, b, c, a, d), undecided);
    EXPECT_EQ(mgdt::exact::orientation_lattice(d, e, b, c), undecided);
}

// With a few bits more, doubles round, and ties come out as something else.
TEST(Stages, LatticeErrsWithMoreBits) {
    Random random(9);
    int sphere = 0, solid = 0, proved = 0;
    for (int i = 0; i < 2000; ++i) {
        // Integers on a sphere, and on a plane: d = b + c - a.
        const int x = random.integer(0, 2000), y = random.integer(0, 2000);
        Five p;
        for (auto& v : p) {
            v = {double(x), double(y), double(random.integer(0, 1) ? 1 : -1) * 1999};
            std::swap(v[0], v[std::size_t(random.integer(0, 2))]);
            if (random.integer(0, 1)) v[1] = -v[1];
        }
        const auto on_sphere = mgdt::exact::differences(
            {p[0].data(), p[1].data(), p[2].data(), p[3].data()}, p[4].data());
        if (mgdt::exact::is_lattice<13>(on_sphere))
            sphere += mgdt::exact::SphereDeterminant()(on_sphere.rounded) != 0;
        if (mgdt::exact::is_lattice<mgdt::exact::sphere_lattice_bits>(on_sphere))
            proved += mgdt::exact::SphereDeterminant()(on_sphere.rounded) != 0;
        const auto any = [&] { return double(random.integer(-1000000, 1000000)); };
        const double a[] = {any(), any(), any()}, b[] = {any(), any(), any()},
                     c[] = {any(), any(), any()};
        const double d[] = {b[0] + c[0] - a[0], b[1] + c[1] - a[1], b[2] + c[2] - a[2]};
        const auto on_plane = mgdt::exact::differences({b, c, d}, a);
        if (mgdt::exact::is_lattice<23>(on_plane))
            solid += mgdt::exact::OrientationDeterminant()(on_plane.rounded) != 0;
        if (mgdt::exact::is_lattice<mgdt::exact::orientation_lattice_bits>(on_plane))
            proved += mgdt::exact::OrientationDeterminant()(on_plane.rounded) != 0;
    }
    EXPECT_GT(sphere, 0);
    EXPECT_GT(solid, 0);
    EXPECT_EQ(proved, 0);
}

// The integers that span the whole range of doubles cost a hundred times as much as what comes
// before them. Sets that occur are not left to them.
TEST(Stages, WideIntegersAreSeldomReached) {
    Random random(12);
    for (const char* name :
         {"axes of other sizes", "lattice with axes of other sizes", "terrain with a floor",
          "lattice terrain with a floor", "lattice at an extreme scale",
          "sphere at an extreme scale", "subnormal"}) {
        int open = 0, cases = 0;
        for (int i = 0; i < 1000; ++i) {
            const Five p = family(name).make(random);
            const double *a = p[0].data(), *b = p[1].data(), *c = p[2].data(), *d = p[3].data(),
                         *q = p[4].data();
            const mgdt::exact::ExactDifferences<12> v({a, b, c, d}, q);
            if (v.bits() <= 511) continue;  // narrower ones are cheap
            ++cases;
            int s = mgdt::exact::sphere_scaled(a, b, c, d, q);
            if (s == undecided) s = mgdt::exact::sphere_ranged(a, b, c, d, q);
            if (s == undecided) s = mgdt::exact::sphere_sparse(a, b, c, d, q);
            int o = mgdt::exact::orientation_scaled(a, b, c, d);
            if (o == undecided) o = mgdt::exact::orientation_ranged(a, b, c, d);
            if (o == undecided) o = mgdt::exact::orientation_sparse(a, b, c, d);
            open += s == undecided || o == undecided;
        }
        EXPECT_LE(open, cases / 100) << name;
    }
}

// Scaling the axes is what decides where one axis is far longer than another, without ties.
TEST(Stages, ScaledAxesDecideGenericPoints) {
    Random random(13);
    int open = 0;
    for (int i = 0; i < 1000; ++i) {
        const Five p = family("axes of other sizes").make(random);
        open += mgdt::exact::sphere_scaled(p[0].data(), p[1].data(), p[2].data(), p[3].data(),
                                           p[4].data()) == undecided;
        open += mgdt::exact::orientation_scaled(p[0].data(), p[1].data(), p[2].data(),
                                                p[3].data()) == undecided;
    }
    EXPECT_LE(open, 20);
}

// Sums of terms that overlap, touch, cancel, and lie far apart.
TEST(Sparse, SignsAreThoseOfTheSum) {
    Random random(14);
    using mgdt::exact::Sparse;
    for (int i = 0; i < reference::cases(20000); ++i) {
        Sparse<60> a;
        reference::Big sum = 0;
        const int terms = random.integer(0, 5);
        const int spread = random.integer(0, 1) ? 100 : 2000;
        for (int t = 0; t < terms; ++t) {
            const int e = random.integer(0, spread);
            const long long f = static_cast<long long>(random.integer(-1000000, 1000000))
                                << random.integer(0, 30);
            a.add(e, mgdt::exact::shifted<60>(f, 0));
            sum += reference::Big(f) << e;
        }
        EXPECT_EQ(mgdt::exact::sign(a), sum.sign());
        const auto square = a * a;
        EXPECT_EQ(mgdt::exact::sign(square), sum == 0 ? 0 : 1);
        EXPECT_EQ(mgdt::exact::sign(square - square), 0);
        EXPECT_EQ(mgdt::exact::sign(a - square), reference::Big(sum - sum * sum).sign());
        EXPECT_EQ(mgdt::exact::sign(a + square), reference::Big(sum + sum * sum).sign());
    }
    // One unit above what all lower terms can take away, and one below.
    for (const int sign : {-1, 1}) {
        Sparse<60> a;
        a.add(59, mgdt::exact::shifted<60>(sign, 0));
        for (int e = 0; e < 10; ++e) a.add(e, mgdt::exact::shifted<60>(-sign, 49));
        EXPECT_EQ(mgdt::exact::sign(a), sign);
        a.add(49, mgdt::exact::shifted<60>(-sign, 1));
        EXPECT_EQ(mgdt::exact::sign(a), -sign);
    }
}

TEST(Sparse, TooManyTermsAreNoNumber) {
    mgdt::exact::Sparse<60> a;
    for (int e = 0; e < mgdt::exact::Sparse<60>::capacity; ++e)
        a.add(100 * e, mgdt::exact::shifted<60>(1, 0));
    EXPECT_EQ(mgdt::exact::sign(a), 1);
    EXPECT_EQ(mgdt::exact::sign(a * a), undecided);
    EXPECT_EQ(mgdt::exact::sign(a + a * a), undecided);
    a.add(-1, mgdt::exact::shifted<60>(1, 0));
    EXPECT_EQ(mgdt::exact::sign(a), undecided);
    EXPECT_EQ(mgdt::exact::sign(a - a), undecided);
}

// The largest native integers, every sign of every coordinate, and the first beyond.
TEST(Stages, NativeIntegersHoldTheLargest) {
    if (!mgdt::exact::have_native) return;
    Random random(10);
    for (double unit : {1.0, 0x1p-700, 0x1p700}) {
        for (int i = 0; i < reference::cases(4000); ++i) {
            // 53 bits below 2^59, of which pairs of opposite sign differ by nearly 2^60.
            Five p;
            for (auto& v : p)
                for (double& x : v)
                    x = (random.integer(0, 1) ? 1 : -1) * unit *
                        (0x1p59 - 64 * (1 + random.integer(0, i % 4 == 0 ? 1 << 20 : 3)));
            p[4][0] += (random.integer(0, 1) ? 0x1p7 : 0) * unit;
            const double *a = p[0].data(), *b = p[1].data(), *c = p[2].data(), *d = p[3].data(),
                         *q = p[4].data();
            const int s = mgdt::exact::sphere_native(a, b, c, d, q);
            ASSERT_NE(s, undecided);
            ASSERT_EQ(s, mgdt::exact::sphere_integer(a, b, c, d, q));
            const int o = mgdt::exact::orientation_native(a, b, c, d);
            ASSERT_NE(o, undecided);
            ASSERT_EQ(o, mgdt::exact::orientation_integer(a, b, c, d));
        }
    }
    const double a[] = {0x1p59, 0, 0}, b[] = {0, 0x1p59, 0}, c[] = {0, 0, 0x1p59}, d[] = {1, 1, 1},
                 half[] = {0.5, 0, 0}, o[] = {0, 0, 0};
    EXPECT_EQ(mgdt::exact::orientation_native(d, a, b, c), 1);
    EXPECT_EQ(mgdt::exact::orientation_native(half, a, b, c), undecided);
    const double wide[] = {0x1p60, 0, 0};
    EXPECT_EQ(mgdt::exact::orientation_native(d, wide, b, c), undecided);
    EXPECT_EQ(mgdt::exact::sphere_native(a, b, c, d, half), undecided);
    EXPECT_EQ(mgdt::exact::sphere_native(a, b, c, half, o), undecided);
    // What underflows in units is not 0.
    const double tiny[] = {0x1p-1074, 0, 0}, e[] = {0x1p800, 0, 0}, f[] = {0, 0x1p800, 0},
                 g[] = {0, 0, 0x1p800};
    EXPECT_EQ(mgdt::exact::orientation_native(tiny, e, f, g), undecided);
    EXPECT_EQ(mgdt::exact::sphere_native(o, e, f, g, tiny), undecided);
    // -0 is 0.
    const double minus[] = {-0.0, 1, -0.0}, plus[] = {1, 0, 0}, two[] = {0, 0, 1};
    EXPECT_EQ(mgdt::exact::orientation_native(o, plus, minus, two), 1);
}

TEST(Stages, EveryWidthIsTheLeastForSomePoints) {
    Random random(6);
    int used[std::size(widths)] = {};
    for (const auto& f : families::all()) {
        for (int i = 0; i < 300; ++i) {
            const Five p = f.make(random);
            const mgdt::exact::ExactDifferences<12> d(
                {p[0].data(), p[1].data(), p[2].data(), p[3].data()}, p[4].data());
            std::size_t w = 0;
            while (w < std::size(widths) && d.bits() > widths[w]) ++w;
            ASSERT_LT(w, std::size(widths));
            ++used[w];
        }
    }
    for (std::size_t w = 0; w < std::size(widths); ++w) EXPECT_GT(used[w], 0) << widths[w];
}

// Points in units of 2^-1074 up to the largest number need every bit of the last width.
TEST(Stages, TheLastWidthHoldsTheWholeRange) {
    const double big = DBL_MAX, tiny = 0x1p-1074;
    const double a[] = {big, tiny, -big}, b[] = {-big, big, tiny}, c[] = {tiny, -big, big},
                 d[] = {big, big, big}, q[] = {-big, -big, -big};
    const mgdt::exact::ExactDifferences<12> e({a, b, c, d}, q);
    EXPECT_EQ(e.bits(), 2100);
    const auto point = [](const double* p) { return reference::Point{p[0], p[1], p[2]}; };
    EXPECT_EQ(mgdt::side_of_sphere(a, b, c, d, q),
              reference::side_of_sphere(point(a), point(b), point(c), point(d), point(q)));
    EXPECT_EQ(mgdt::orientation(a, b, c, q),
              reference::orientation(point(a), point(b), point(c), point(q)));
}

// In each plane of coordinates one product of the three tells that points are not on a line.
TEST(Stages, EachCoordinateOfACrossProductCounts) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        double a[3] = {}, b[3] = {}, c[3] = {};
        b[(axis + 1) % 3] = 1;
        c[(axis + 2) % 3] = 1;
        EXPECT_FALSE(mgdt::exact::collinear_integer(a, b, c)) << axis;
        c[(axis + 2) % 3] = 0;
        c[(axis + 1) % 3] = -3;
        EXPECT_TRUE(mgdt::exact::collinear_integer(a, b, c)) << axis;
    }
}

// The two-sum of a difference may overflow within although the rounded difference is finite: where
// it is rounded up to the next but largest number, what is taken back of it is beyond all.
TEST(Stages, AnOverflowWithinADifferenceIsSeen) {
    const double most = DBL_MAX, little = 3 * 0x1p970;
    ASSERT_EQ(little - most, -0x1.ffffffffffffep1023);
    ASSERT_EQ(little - (little - most), HUGE_VAL);
    const double a[] = {little, 0, -most}, q[] = {most, -most, -little};
    const mgdt::exact::ExactDifferences<3> d({a}, q);
    ASSERT_LE(d.bits(), 62);
    ASSERT_EQ(d.low, 970);
    const auto in_units = [&](double x) { return static_cast<std::int64_t>(std::ldexp(x, -970)); };
    for (std::size_t i = 0; i < 3; ++i) {
        // In 64 bits: the largest double is (2^54 - 2) units.
        EXPECT_EQ(d.get<62>(i).value, in_units(a[i]) - in_units(q[i])) << i;
    }
    const double b[] = {most, most, most}, c[] = {-most, little, 0}, e[] = {little, most, little};
    const auto point = [](const double* p) { return reference::Point{p[0], p[1], p[2]}; };
    EXPECT_EQ(mgdt::orientation(a, b, c, q),
              reference::orientation(point(a), point(b), point(c), point(q)));
    EXPECT_EQ(mgdt::side_of_sphere(a, b, c, e, q),
              reference::side_of_sphere(point(a), point(b), point(c), point(e), point(q)));
    EXPECT_EQ(mgdt::compare_distance(q, a, e),
              reference::compare_distance(point(q), point(a), point(e)));
}

// Each filter's constants are tried on points made to be hard for it: with the constants it is
// never wrong; with either part of the bound too small it is, so that neither the constants nor
// these points are idle.
template <class Make, class Filter, class Exact>
int wrong_answers(const Make& make, const Filter& filter, const Exact& exact) {
    Random random(8);
    int wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        const Five p = make(random);
        const int s = filter(p);
        if (s != undecided && s != exact(p)) ++wrong;
    }
    return wrong;
}

Bound with_relative_part_over(double factor, const Bound& b) {
    return {b.relative / factor, b.underflow};
}

Bound without_underflow(const Bound& b) {
    return {b.relative, 0};
}

Five scaled(Five five, int exponent) {
    for (auto& p : five) {
        for (double& v : p) v = std::ldexp(v, exponent);
    }
    return five;
}

// The same points where products of so many of their differences lie among the subnormals.
template <class Make>
auto where_products_underflow(int degree, const Make& make) {
    return
        [=](Random& r) { return scaled(make(r), r.integer(-1074 / degree - 2, -1000 / degree)); };
}

Five on_a_plane(Random& r) {
    return family("rounded onto a plane").make(r);
}
Five on_a_sphere(Random& r) {
    return family("rounded onto a sphere").make(r);
}

// Both others as far from the first: their coordinates are the same in another order.
Five equidistant(Random& r) {
    const auto p = r.in_cube(-1, 1);
    return {{{0, 0, 0}, p, {p[1], p[2], p[0]}, {}, {}}};
}

// On one line exactly, though b - a takes more than 53 bits and is rounded: let n be a small
// integer, a = (2^4 j - n) 2^-53 and b = n; then c = b - 2^53 (b - a) = 2^4 j - 2^53 n.
Five on_a_line(Random& r) {
    Five p{};
    for (std::size_t k = 0; k < 3; ++k) {
        const double n = r.integer(1, 15), j = std::floor(r.uniform(-0x1p48, 0x1p48));
        p[0][k] = (0x1p4 * j - n) * 0x1p-53;
        p[1][k] = n;
        p[2][k] = 0x1p4 * j - 0x1p53 * n;
    }
    return p;
}

Five around_the_origin(Random& r) {
    return {{{0, 0, 0}, r.in_cube(-1, 1), r.in_cube(-1, 1), {}, {}}};
}

// The last over the edge of the first two, but for its rounding.
Five over_an_edge(Random& r) {
    Five p = {{r.in_cube(-1, 1), r.in_cube(-1, 1), r.in_cube(-1, 1), {}, {}}};
    const double along = r.uniform(0, 1), up = r.uniform(-2, 2);
    double e[3], f[3];
    for (std::size_t k = 0; k < 3; ++k) {
        e[k] = p[1][k] - p[0][k];
        f[k] = p[2][k] - p[0][k];
    }
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
        p[3][k] = p[0][k] + along * e[k] + up * (e[l] * f[m] - e[m] * f[l]);
    }
    return p;
}

int sphere_exact(const Five& p) {
    return mgdt::exact::sphere_integer(p[0].data(), p[1].data(), p[2].data(), p[3].data(),
                                       p[4].data());
}

int orientation_exact(const Five& p) {
    return mgdt::exact::orientation_integer(p[0].data(), p[1].data(), p[2].data(), p[3].data());
}

int distance_exact(const Five& p) {
    return mgdt::exact::distance_integer(p[0].data(), p[1].data(), p[2].data());
}

int line_exact(const Five& p) {
    return mgdt::exact::collinear_integer(p[0].data(), p[1].data(), p[2].data()) ? 0 : 1;
}

auto sphere_with(Bound bound) {
    return [bound](const Five& p) {
        return mgdt::exact::sphere_filter(p[0].data(), p[1].data(), p[2].data(), p[3].data(),
                                          p[4].data(), bound);
    };
}

auto orientation_with(Bound bound) {
    return [bound](const Five& p) {
        return mgdt::exact::orientation_filter(p[0].data(), p[1].data(), p[2].data(), p[3].data(),
                                               bound);
    };
}

auto distance_with(Bound bound) {
    return [bound](const Five& p) {
        return mgdt::exact::distance_filter(p[0].data(), p[1].data(), p[2].data(), bound);
    };
}

auto line_with(Bound bound) {
    return [bound](const Five& p) {
        return mgdt::exact::collinear_filter(p[0].data(), p[1].data(), p[2].data(), bound);
    };
}

TEST(FilterConstants, Sphere) {
    const Bound bound = mgdt::exact::sphere_bound;
    const auto wrong = [](const auto& make, const Bound& b) {
        return wrong_answers(make, sphere_with(b), sphere_exact);
    };
    const auto tiny = where_products_underflow(5, on_a_sphere);
    EXPECT_EQ(wrong(on_a_sphere, bound), 0);
    EXPECT_GT(wrong(on_a_sphere, with_relative_part_over(16, bound)), 0);
    EXPECT_EQ(wrong(tiny, bound), 0);
    EXPECT_GT(wrong(tiny, without_underflow(bound)), 0);
}

// Each point moved by a power of two along an axis of its own scale.
Five with_other_axes(Five five, Random& r) {
    const int e[3] = {r.integer(-900, 900), r.integer(-900, 900), r.integer(-900, 900)};
    for (auto& p : five)
        for (std::size_t k = 0; k < 3; ++k) p[k] = std::ldexp(p[k], e[k]);
    return five;
}

// A tie of the coordinates along the longest axis, and of the others beside it.
TEST(FilterConstants, ScaledAxes) {
    const auto on_a_sphere_scaled = [](Random& r) { return scaled(on_a_sphere(r), -900); };
    const auto flat = [](Random& r) { return with_other_axes(on_a_plane(r), r); };
    const auto sphere = [](Bound b) {
        return [b](const Five& p) {
            return mgdt::exact::sphere_scaled(p[0].data(), p[1].data(), p[2].data(), p[3].data(),
                                              p[4].data(), b);
        };
    };
    const auto solid = [](Bound b) {
        return [b](const Five& p) {
            return mgdt::exact::orientation_scaled(p[0].data(), p[1].data(), p[2].data(),
                                                   p[3].data(), b);
        };
    };
    const Bound s = mgdt::exact::sphere_bound, o = mgdt::exact::orientation_bound;
    EXPECT_EQ(wrong_answers(on_a_sphere_scaled, sphere(s), sphere_exact), 0);
    EXPECT_GT(
        wrong_answers(on_a_sphere_scaled, sphere(with_relative_part_over(16, s)), sphere_exact), 0);
    EXPECT_EQ(wrong_answers(flat, solid(o), orientation_exact), 0);
    EXPECT_GT(wrong_answers(flat, solid(with_relative_part_over(12, o)), orientation_exact), 0);
}

TEST(FilterConstants, Ranged) {
    const auto tiny = [](Random& r) { return scaled(on_a_sphere(r), -1000); };
    const auto flat = [](Random& r) { return with_other_axes(on_a_plane(r), r); };
    const auto sphere = [](double b) {
        return [b](const Five& p) {
            return mgdt::exact::sphere_ranged(p[0].data(), p[1].data(), p[2].data(), p[3].data(),
                                              p[4].data(), b);
        };
    };
    const auto solid = [](double b) {
        return [b](const Five& p) {
            return mgdt::exact::orientation_ranged(p[0].data(), p[1].data(), p[2].data(),
                                                   p[3].data(), b);
        };
    };
    const auto distance = [](double b) {
        return [b](const Five& p) {
            return mgdt::exact::distance_ranged(p[0].data(), p[1].data(), p[2].data(), b);
        };
    };
    const double s = mgdt::exact::ranged_sphere_bound, o = mgdt::exact::ranged_orientation_bound,
                 d = mgdt::exact::distance_bound.relative;
    EXPECT_EQ(wrong_answers(tiny, sphere(s), sphere_exact), 0);
    EXPECT_GT(wrong_answers(tiny, sphere(s / 16), sphere_exact), 0);
    EXPECT_EQ(wrong_answers(flat, solid(o), orientation_exact), 0);
    EXPECT_GT(wrong_answers(flat, solid(o / 12), orientation_exact), 0);
    EXPECT_EQ(wrong_answers(equidistant, distance(d), distance_exact), 0);
    EXPECT_GT(wrong_answers(equidistant, distance(d / 8), distance_exact), 0);
}

TEST(FilterConstants, Orientation) {
    const Bound bound = mgdt::exact::orientation_bound;
    const auto wrong = [](const auto& make, const Bound& b) {
        return wrong_answers(make, orientation_with(b), orientation_exact);
    };
    const auto tiny = where_products_underflow(3, on_a_plane);
    EXPECT_EQ(wrong(on_a_plane, bound), 0);
    EXPECT_GT(wrong(on_a_plane, with_relative_part_over(12, bound)), 0);
    EXPECT_EQ(wrong(tiny, bound), 0);
    EXPECT_GT(wrong(tiny, without_underflow(bound)), 0);
}

TEST(FilterConstants, Distance) {
    const Bound bound = mgdt::exact::distance_bound;
    const auto wrong = [](const auto& make, const Bound& b) {
        return wrong_answers(make, distance_with(b), distance_exact);
    };
    const auto tiny = where_products_underflow(2, around_the_origin);
    EXPECT_EQ(wrong(equidistant, bound), 0);
    EXPECT_GT(wrong(equidistant, with_relative_part_over(8, bound)), 0);
    EXPECT_EQ(wrong(tiny, bound), 0);
    EXPECT_GT(wrong(tiny, without_underflow(bound)), 0);
}

TEST(FilterConstants, SideOfAnEdge) {
    const Bound bound = mgdt::exact::edge_bound;
    const auto wrong = [](const auto& make, const Bound& b) {
        const auto filter = [&b](const Five& p) {
            return mgdt::exact::edge_filter(p[0].data(), p[1].data(), p[2].data(), p[3].data(), b);
        };
        const auto exact = [](const Five& p) {
            return mgdt::exact::edge_integer(p[0].data(), p[1].data(), p[2].data(), p[3].data());
        };
        return wrong_answers(make, filter, exact);
    };
    // An edge whose square is subnormal.
    const auto tiny = [](Random& r) {
        Five p = {{{0, 0, 0}, r.in_cube(-1, 1), r.in_cube(-1, 1), r.in_cube(-1, 1), {}}};
        for (double& x : p[1]) x *= 0x1p-536;
        return p;
    };
    EXPECT_EQ(wrong(over_an_edge, bound), 0);
    EXPECT_GT(wrong(over_an_edge, with_relative_part_over(16, bound)), 0);
    EXPECT_EQ(wrong(tiny, bound), 0);
    EXPECT_GT(wrong(tiny, without_underflow(bound)), 0);
}

// Where differences are exact, both products of a collinear triple are the same number and round
// the same way, so only the relative part is ever needed.
TEST(FilterConstants, Collinear) {
    const Bound bound = mgdt::exact::collinear_bound;
    const auto wrong = [](const auto& make, const Bound& b) {
        return wrong_answers(make, line_with(b), line_exact);
    };
    EXPECT_EQ(wrong(on_a_line, bound), 0);
    EXPECT_GT(wrong(on_a_line, with_relative_part_over(4, bound)), 0);
    EXPECT_EQ(wrong(where_products_underflow(2, on_a_line), bound), 0);
}

}  // namespace
