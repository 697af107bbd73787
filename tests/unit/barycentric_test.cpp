// SPDX-License-Identifier: MIT
// Barycentric weights against ratios of unlimited integers, for tetrahedra as flat as doubles allow
// and of any size, by each stage.
#include "predicates/barycentric.hpp"

#include <gtest/gtest.h>

#include "../support/reproduction.h"
#include "exact_reference.hpp"
#include "point_families.hpp"
#include "predicates/differences.hpp"
#include "predicates/native_integer.hpp"

namespace {

using families::Five;
using families::Random;
using reference::Big;
using reference::BigPoint;
using reference::Point;
using Weights = std::array<double, 4>;

// Six times the signed volume, by homogeneous coordinates.
Big volume(const BigPoint& a, const BigPoint& b, const BigPoint& c, const BigPoint& d) {
    const auto det = [](const BigPoint& u, const BigPoint& v, const BigPoint& w) -> Big {
        return u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
               u[2] * (v[0] * w[1] - v[1] * w[0]);
    };
    return -det(a, b, c) + det(a, b, d) - det(a, c, d) + det(b, c, d);
}

// The volumes with q, the last of the points, in place of each of the others, and the whole one,
// which becomes positive.
struct Volumes {
    Big part[4], whole;

    explicit Volumes(Five& five) {
        const std::vector<BigPoint> p = reference::scaled({five.begin(), five.end()});
        whole = volume(p[0], p[1], p[2], p[3]);
        part[0] = volume(p[4], p[1], p[2], p[3]);
        part[1] = volume(p[0], p[4], p[2], p[3]);
        part[2] = volume(p[0], p[1], p[4], p[3]);
        part[3] = volume(p[0], p[1], p[2], p[4]);
        if (whole >= 0) return;
        whole = -whole;
        for (Big& v : part) v = -v;
        std::swap(five[0], five[1]);
        std::swap(part[0], part[1]);
    }
    bool contains() const {
        return part[0] >= 0 && part[1] >= 0 && part[2] >= 0 && part[3] >= 0 && whole > 0;
    }
};

// w in units of 2^-1074.
Big in_least_units(double w) {
    int e;
    const double m = std::frexp(std::fabs(w), &e);
    const Big mantissa = static_cast<long long>(std::ldexp(m, 53));
    const int shift = e - 53 + 1074;
    Big units = mantissa;
    if (shift >= 0)
        units <<= shift;
    else
        units >>= -shift;
    return w < 0 ? Big(-units) : units;
}

// |w - part / whole| <= 3.01 * 2^-53 |part / whole| + 2^-1075.
bool is_near(double w, const Big& part, const Big& whole) {
    const Big error = abs(in_least_units(w) * whole - (part << 1074));
    return (error << 60) * 100 <= (abs(part) << 1074) * (301 << 7) + (whole << 59) * 100;
}

Weights weights(const Five& five) {
    Weights w;
    double out[4];
    mgdt::barycentric_weights({five[0].data(), five[1].data(), five[2].data(), five[3].data()},
                              five[4].data(), out);
    std::copy(out, out + 4, w.begin());
    return w;
}

bool by_native(const Five& five, Weights& w) {
    double out[4] = {};
    const bool can = mgdt::exact::barycentric_native(
        {five[0].data(), five[1].data(), five[2].data(), five[3].data()}, five[4].data(), out);
    std::copy(out, out + 4, w.begin());
    return can;
}

Weights by_integer(const Five& five, int least_width) {
    double out[4];
    mgdt::exact::barycentric_integer(
        {five[0].data(), five[1].data(), five[2].data(), five[3].data()}, five[4].data(), out,
        least_width);
    Weights w;
    std::copy(out, out + 4, w.begin());
    return w;
}

std::string text(const Five& five) {
    std::string out;
    for (const Point& p : five) {
        char line[128];
        std::snprintf(line, sizeof line, "\n%a %a %a", p[0], p[1], p[2]);
        out += line;
    }
    return out;
}

// The weights by all stages are the same, near the ratio, and 0 where that is; so are those of the
// vertices in other orders. Returns whether native integers did it.
bool expect_right(const Five& five, const Volumes& volumes) {
    const Weights w = weights(five);
    for (std::size_t i = 0; i < 4; ++i) {
        // Far from a small tetrahedron a ratio may be beyond all doubles.
        if ((abs(volumes.part[i]) >> 1020) > volumes.whole) continue;
        EXPECT_TRUE(is_near(w[i], volumes.part[i], volumes.whole)) << w[i] << text(five);
        if (volumes.part[i] == 0) {
            EXPECT_EQ(w[i], 0) << text(five);
            EXPECT_FALSE(std::signbit(w[i])) << text(five);
        }
    }
    Weights whole;
    const bool can = by_native(five, whole);
    if (can) {
        EXPECT_EQ(whole, w) << text(five);
    }
    for (const int width : mgdt::exact::widths)
        EXPECT_EQ(by_integer(five, width), w) << width << text(five);
    // Rotations of three vertices give all even permutations.
    std::array<std::size_t, 4> order = {0, 1, 2, 3};
    for (int i = 0; i < 12; ++i) {
        std::rotate(order.begin() + i % 2, order.begin() + i % 2 + 1, order.begin() + i % 2 + 3);
        const Weights other =
            weights({five[order[0]], five[order[1]], five[order[2]], five[order[3]], five[4]});
        for (std::size_t k = 0; k < 4; ++k) EXPECT_EQ(other[k], w[order[k]]) << text(five);
    }
    if (volumes.contains()) {
        const double* p[4] = {five[0].data(), five[1].data(), five[2].data(), five[3].data()};
        EXPECT_TRUE(reproduces(p, five[4].data(), w.data())) << text(five);
        double sum = 0;
        for (const double x : w) sum += x;
        EXPECT_NEAR(sum, 1, 8 * 0x1p-53);
    }
    return can;
}

// A place that is likely to be in the tetrahedron: a vertex, within an edge or a facet, or inside.
Point somewhere_in(Random& r, const Five& five) {
    double share[4] = {}, sum = 0;
    const int kind = r.integer(1, 5);
    for (int n = 0; n < kind; ++n)
        share[r.integer(0, 3)] += r.integer(0, 1) ? 1 : r.uniform(0x1p-20, 1);
    for (const double s : share) sum += s;
    Point q = {};
    for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t i = 0; i < 4; ++i) q[k] += share[i] / sum * five[i][k];
    return q;
}

TEST(Barycentric, RightOnEveryFamily) {
    Random random(21);
    int native = 0, other = 0;
    for (const auto& f : families::all()) {
        SCOPED_TRACE(f.name);
        int inside = 0, on_boundary = 0;
        for (int i = 0; i < reference::cases(120) && !testing::Test::HasFailure(); ++i) {
            Five p = f.make(random);
            const Volumes anywhere(p);
            if (anywhere.whole == 0) continue;
            (expect_right(p, anywhere) ? native : other) += 1;
            for (int k = 0; k < 4; ++k) {
                p[4] = somewhere_in(random, p);
                const Volumes volumes(p);
                if (!volumes.contains()) continue;
                ++inside;
                for (const Big& part : volumes.part) on_boundary += part == 0;
                (expect_right(p, volumes) ? native : other) += 1;
            }
        }
        if (reference::cases(120) == 120 && f.name != "repeated points" &&
            f.name != "rounded onto a line") {
            EXPECT_GT(inside, 50);
            EXPECT_GT(on_boundary, 50);
        }
    }
    EXPECT_EQ(native > 0, mgdt::exact::have_native);
    EXPECT_GT(other, 0);
}

// Four points within some units in the last place of a plane, and places that are inside between
// them: volumes of which a determinant in doubles has no digit.
TEST(Barycentric, RightInSlivers) {
    Random random(22);
    int inside = 0, native = 0;
    for (int i = 0; i < reference::cases(4000); ++i) {
        const Point a = random.in_cube(), u = random.direction(), v = random.direction();
        Five p;
        for (Point& x : p) {
            const double s = random.uniform(-1, 1), t = random.uniform(-1, 1);
            x = families::nudged(random, {a[0] + s * u[0] + t * v[0], a[1] + s * u[1] + t * v[1],
                                          a[2] + s * u[2] + t * v[2]});
        }
        p[4] = somewhere_in(random, p);
        const Volumes volumes(p);
        if (!volumes.contains()) continue;
        ++inside;
        native += expect_right(p, volumes);
        if (testing::Test::HasFailure()) return;
    }
    EXPECT_TRUE(native > inside * 3 / 4 || !mgdt::exact::have_native) << native << ' ' << inside;
    EXPECT_GT(inside, reference::cases(4000) / 20);
}

// At a vertex one weight is 1 and the others are 0; on an edge and on a facet two and one are 0.
TEST(Barycentric, ExactOnTheBoundary) {
    Random random(23);
    for (int i = 0; i < reference::cases(500); ++i) {
        Five p;
        for (Point& x : p)
            for (double& c : x) c = random.integer(-1000000, 1000000);
        // Multiples of 3, so that thirds of sums are coordinates.
        for (Point& x : p)
            for (double& c : x) c *= 6 * (i % 3 == 0 ? 0.1 : 1);
        if (Volumes(p).whole == 0) continue;
        for (std::size_t v = 0; v < 4; ++v) {
            p[4] = p[v];
            Weights expected = {};
            expected[v] = 1;
            EXPECT_EQ(weights(p), expected) << text(p);
        }
        if (i % 3 == 0) continue;
        for (std::size_t k = 0; k < 3; ++k) p[4][k] = (p[1][k] + p[3][k]) / 2;
        EXPECT_EQ(weights(p), (Weights{0, 0.5, 0, 0.5})) << text(p);
        for (std::size_t k = 0; k < 3; ++k) p[4][k] = (p[0][k] + p[1][k] + p[2][k]) / 3;
        const double third = 1 / 3.;
        EXPECT_NEAR(weights(p)[0], third, 0x1p-54);
        EXPECT_EQ(weights(p)[3], 0) << text(p);
    }
}

// Each axis has a unit of its own, so coordinates of any different sizes along the three are
// native integers.
TEST(Barycentric, AxesOfDifferentSizes) {
    if (!mgdt::exact::have_native) return;
    Random random(24);
    const double sizes[][3] = {{1, 1e-6, 1e6}, {1e-200, 1, 1e200}, {0x1p890, 0x1p-890, 0x1p40}};
    for (const auto& size : sizes) {
        for (int i = 0; i < reference::cases(300); ++i) {
            Five p;
            for (Point& x : p)
                for (std::size_t k = 0; k < 3; ++k) x[k] = size[k] * random.uniform(0.125, 1);
            const Volumes volumes(p);
            if (volumes.whole == 0) continue;
            EXPECT_TRUE(expect_right(p, volumes));
            p[4] = somewhere_in(random, p);
            const Volumes within(p);
            EXPECT_TRUE(expect_right(p, within));
        }
    }
}

// The largest native integers, with every sign, and the first beyond.
TEST(Barycentric, NativeIntegersHoldTheLargest) {
    if (!mgdt::exact::have_native) return;
    Random random(25);
    for (const double unit : {1.0, 0x1p-840, 0x1p840}) {
        for (int i = 0; i < reference::cases(600); ++i) {
            // 53 bits just below 2^59, of which pairs of opposite sign differ by nearly 2^60.
            Five p;
            for (Point& v : p)
                for (double& x : v)
                    x = (random.integer(0, 1) ? 1 : -1) * unit *
                        (0x1p59 - 64 * (1 + random.integer(0, i % 4 == 0 ? 1 << 20 : 3)));
            const Volumes volumes(p);
            if (volumes.whole == 0) continue;
            ASSERT_TRUE(expect_right(p, volumes)) << text(p);
        }
    }
    const Five in_units = {{{0x1p58, 0, 0}, {0, 0x1p58, 0}, {0, 0, 0x1p58}, {0, 0, 0}, {1, 1, 1}}};
    Weights w;
    EXPECT_TRUE(by_native(in_units, w));
    EXPECT_EQ(w, (Weights{0x1p-58, 0x1p-58, 0x1p-58, 1}));
    Five finer = in_units;
    finer[4][1] = 0.5;
    EXPECT_FALSE(by_native(finer, w));
    EXPECT_EQ(weights(finer), (Weights{0x1p-58, 0x1p-59, 0x1p-58, 1}));
    Five wider = in_units;
    wider[2][2] = 0x1p59;
    EXPECT_FALSE(by_native(wider, w));
    // What underflows in units is not 0; -0 is.
    Five tiny = in_units;
    for (Point& v : tiny)
        for (double& x : v) x *= 0x1p800;
    EXPECT_TRUE(by_native(tiny, w));
    tiny[4] = {0x1p-1074, -0.0, 0};
    EXPECT_FALSE(by_native(tiny, w));
    tiny[4] = {-0.0, -0.0, 0};
    EXPECT_TRUE(by_native(tiny, w));
    EXPECT_EQ(w, (Weights{0, 0, 0, 1}));
}

// Volumes at and beside the middle of two doubles, and of few bits: each is rounded once, so all
// stages agree to the last bit.
TEST(Barycentric, VolumesAreRoundedOnce) {
    Random random(26);
    for (int i = 0; i < reference::cases(4000); ++i) {
        // A unit corner: the volumes are q's coordinates times a power of two, of at most 59 bits.
        const double size = std::ldexp(1, random.integer(30, 58));
        Five p = {{{size, 0, 0}, {0, size, 0}, {0, 0, size}, {0, 0, 0}, {}}};
        for (double& x : p[4]) {
            x = std::ldexp(random.integer(0, 1 << 30), random.integer(0, 28)) +
                (random.integer(0, 1) ? random.integer(0, 3) : 0);
            x = std::fmod(x, size / 2);
        }
        p[3] = {double(random.integer(-1, 1)), double(random.integer(-1, 1)), 0};
        const Volumes volumes(p);
        expect_right(p, volumes);
        if (testing::Test::HasFailure()) return;
    }
}

// Integers of every width are the least for some tetrahedra of the families.
TEST(Barycentric, EveryWidthIsUsed) {
    Random random(27);
    int used[std::size(mgdt::exact::widths)] = {};
    for (const auto& f : families::all()) {
        for (int i = 0; i < 300; ++i) {
            const Five p = f.make(random);
            const mgdt::exact::ExactDifferencesByAxis<12> d(
                {p[0].data(), p[1].data(), p[2].data(), p[3].data()}, p[4].data());
            std::size_t w = 0;
            while (w < std::size(mgdt::exact::widths) && d.bits() > mgdt::exact::widths[w]) ++w;
            ASSERT_LT(w, std::size(mgdt::exact::widths));
            ++used[w];
        }
    }
    for (const int count : used) EXPECT_GT(count, 0);
}

// The whole range of doubles along each axis.
TEST(Barycentric, TheWholeRange) {
    const double big = DBL_MAX, tiny = 0x1p-1074;
    for (const Point& q : {Point{0, 0, 0}, Point{tiny, tiny, tiny}, Point{-tiny, 0, tiny},
                           Point{1, -1, 1e300}, Point{big, big, big}}) {
        for (Five p :
             {Five{{{big, tiny, -big}, {-big, big, tiny}, {tiny, -big, big}, {big, big, big}, q}},
              Five{{{0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}, {0, 0, big}, q}}}) {
            const Volumes volumes(p);
            expect_right(p, volumes);
        }
    }
    // A subnormal weight is rounded too.
    const Five flat = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0x1.8p0}, {0, 0, tiny}}};
    EXPECT_EQ(weights(flat), (Weights{1, 0, 0, tiny}));
}

}  // namespace
