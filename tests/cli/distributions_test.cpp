// SPDX-License-Identifier: MIT
//
// The point generators: counts, shapes, exactness of the degenerate sets.
#include "cli/point_sets/distributions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>
#include <set>
#include <string>

#include "cli/point_sets/random_points.hpp"
#include "generated_points.hpp"

namespace mgdt::cli {
namespace {

const double pi = std::acos(-1.0);

/// From the line through a and b.
double distance_from_line(const Point& p, const Point& a, const Point& b) {
    const double length = distance(a, b);
    double along = 0;
    for (std::size_t i = 0; i < 3; ++i) along += (p[i] - a[i]) * (b[i] - a[i]) / length;
    const double d = distance(p, a);
    return std::sqrt(std::max(0.0, d * d - along * along));
}

double distance_from_diagonals(const Point& p, int* nearest = nullptr) {
    double least = 2;
    for (int which = 0; which < 4; ++which) {
        const Point a{0, (which & 1) != 0 ? 1.0 : 0.0, (which & 2) != 0 ? 1.0 : 0.0};
        const Point b{1, 1 - a[1], 1 - a[2]};
        const double d = distance_from_line(p, a, b);
        if (d < least && nearest != nullptr) *nearest = which;
        least = std::min(least, d);
    }
    return least;
}

/// From the point of the spiral at the same height, give or take the height's own jitter.
double distance_from_spiral(const Point& p, double width) {
    double least = 2;
    for (int i = -500; i <= 500; ++i) {
        const double t = p[2] + width * i / 1000;
        const double r = 0.1 + 0.4 * t;
        least = std::min(least, distance(p, {0.5 + r * std::cos(8 * pi * t),
                                             0.5 + r * std::sin(8 * pi * t), t}));
    }
    return least;
}

/// Norm of p relative to the ellipsoid about the centre of the cube.
double ellipsoid_norm(const Point& p, const Point& axes) {
    return distance({(p[0] - 0.5) / axes[0], (p[1] - 0.5) / axes[1], (p[2] - 0.5) / axes[2]},
                    {0, 0, 0});
}

Point mean(const Points& points) {
    Point m{0, 0, 0};
    for (const Point& p : points) {
        for (std::size_t i = 0; i < 3; ++i) m[i] += p[i] / static_cast<double>(points.size());
    }
    return m;
}

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), 8 * a.size()) == 0;
}

const std::set<std::string> not_random{"machine", "church", "lattice"};

TEST(Distributions, HaveUniqueNamesAndDescriptions) {
    std::set<std::string> names;
    for (const Distribution& d : distributions()) {
        EXPECT_TRUE(names.insert(d.name).second) << d.name;
        EXPECT_GT(std::strlen(d.description), 5U) << d.name;
    }
    for (const char* name :
         {"uniform",         "line",     "diagonal",       "ellipse",      "sphere",      "spiral",
          "cluster",         "galaxy",   "mixdiag",        "mixsphere",    "mixspiral",   "machine",
          "church",          "lattice",  "integer-sphere", "moment-curve", "two-lines",   "rounded",
          "lattice-repeats", "coplanar", "collinear",      "one-point",    "anisotropic", "nan",
          "infinity"}) {
        EXPECT_EQ(names.count(name), 1U) << name;
    }
}

TEST(Distributions, GiveAsManyPointsAsAsked) {
    for (const Distribution& d : distributions()) {
        for (const std::size_t n : {0U, 1U, 2U, 7U, 1000U, 6630U}) {
            EXPECT_EQ(generate(d.name, n, with_seed(1)).size(), 3 * n) << d.name;
        }
    }
}

TEST(Distributions, AreFunctionsOfTheSeed) {
    for (const Distribution& d : distributions()) {
        const std::vector<double> first = generate(d.name, 500, with_seed(1));
        EXPECT_TRUE(same_bits(first, generate(d.name, 500, with_seed(1)))) << d.name;
        EXPECT_EQ(same_bits(first, generate(d.name, 500, with_seed(2))),
                  not_random.count(d.name) == 1)
            << d.name;
    }
}

// The generator's own definition, so that no platform or later version changes what a seed means.
// By hand: splitmix64 from 1 gives 910a2dec89025cc1, beeb8da1658eec67, f893a2eefb32555e,
// 71c18690ee42c90b, and the sum of the first and last, rotated by 23, plus the first is the word.
TEST(Distributions, SeedMeansTheSameForEver) {
    const std::uint64_t first = 0x910a2dec89025cc1U;
    const std::uint64_t last = 0x71c18690ee42c90bU;
    const std::uint64_t sum = first + last;
    const std::uint64_t word = ((sum << 23) | (sum >> 41)) + first;
    EXPECT_EQ(generate("uniform", 1, with_seed(1))[0],
              std::ldexp(static_cast<double>(word >> 11), -53));
}

TEST(Distributions, UniformFillsTheCubeEvenly) {
    const Points points = points_of("uniform", 80000);
    std::array<int, 8> octants{};
    for (const Point& p : points) {
        for (const double c : p) {
            ASSERT_GE(c, 0);
            ASSERT_LT(c, 1);
        }
        ++octants[(p[0] < 0.5 ? 0U : 1U) + (p[1] < 0.5 ? 0U : 2U) + (p[2] < 0.5 ? 0U : 4U)];
    }
    for (const int count : octants) EXPECT_NEAR(count, 10000, 500);  // 5 standard deviations
    EXPECT_EQ(distinct(points), points.size());
}

TEST(Distributions, LineIsNarrow) {
    const Points points = points_of("line", 20000);
    double farthest = 0;
    for (const Point& p : points) {
        farthest = std::max(farthest, distance_from_line(p, {0, 0, 0}, {1, 1, 1}));
    }
    EXPECT_LE(farthest, 1e-4 * std::sqrt(3) / 2);
    EXPECT_GT(farthest, 0.5e-4);  // it has the width, too
    EXPECT_NEAR(mean(points)[0], 0.5, 0.02);
}

TEST(Distributions, WidthCanBeSet) {
    GenerateOptions options = with_seed(1);
    options.width = 0.01;
    double farthest = 0;
    for (const Point& p : points_of("line", 20000, options)) {
        farthest = std::max(farthest, distance_from_line(p, {0, 0, 0}, {1, 1, 1}));
    }
    EXPECT_LE(farthest, 0.01 * std::sqrt(3) / 2);
    EXPECT_GT(farthest, 0.5e-2);
}

TEST(Distributions, DiagonalHasFourOfThemAlike) {
    std::array<int, 4> counts{};
    for (const Point& p : points_of("diagonal", 40000)) {
        int nearest = -1;
        ASSERT_LE(distance_from_diagonals(p, &nearest), 1e-4 * std::sqrt(3) / 2);
        ++counts[static_cast<std::size_t>(nearest)];
    }
    for (const int count : counts) EXPECT_NEAR(count, 10000, 500);
}

TEST(Distributions, EllipseAndSphereAreShells) {
    const std::map<std::string, Point> shells{{"ellipse", {0.5, 0.4, 0.3}},
                                              {"sphere", {0.5, 0.5, 0.5}}};
    for (const auto& [kind, axes] : shells) {
        const Points points = points_of(kind, 20000);
        double inner = 2;
        double outer = 0;
        for (const Point& p : points) {
            inner = std::min(inner, ellipsoid_norm(p, axes));
            outer = std::max(outer, ellipsoid_norm(p, axes));
        }
        EXPECT_GE(inner, 1 - 0.50001e-4) << kind;
        EXPECT_LE(outer, 1 + 0.50001e-4) << kind;
        EXPECT_GT(outer - inner, 0.8e-4) << kind;
        for (const double c : mean(points)) EXPECT_NEAR(c, 0.5, 0.02) << kind;
    }
}

TEST(Distributions, SpiralIsNarrow) {
    const Points points = points_of("spiral", 2000);
    double highest = 0;
    for (const Point& p : points) {
        // Beside the jitter, the sampling of the curve: its speed is below 13, so 0.013 widths.
        ASSERT_LE(distance_from_spiral(p, 1e-4), 1e-4 * (std::sqrt(3) / 2 + 0.02));
        highest = std::max(highest, p[2]);
    }
    EXPECT_GT(highest, 0.99);
}

TEST(Distributions, ClusterCrowdsAtTheCentre) {
    const Points points = points_of("cluster", 50000);
    std::size_t near = 0;
    for (const Point& p : points) {
        const double r = distance(p, {0.5, 0.5, 0.5});
        ASSERT_LE(r, 0.5 * (1 + 1e-15));
        if (r < 0.5 / 32) ++near;  // u^5 < 2^-5: half of them
    }
    EXPECT_NEAR(static_cast<double>(near), 25000, 600);

    GenerateOptions mild = with_seed(1);
    mild.power = 3;
    near = 0;
    for (const Point& p : points_of("cluster", 50000, mild)) {
        if (distance(p, {0.5, 0.5, 0.5}) < 0.5 / 8) ++near;
    }
    EXPECT_NEAR(static_cast<double>(near), 25000, 600);
}

TEST(Distributions, GalaxyIsClusteredAndFlat) {
    const Points points = points_of("galaxy", 20000);
    std::set<std::array<int, 3>> cells;
    for (const Point& p : points) {
        std::array<int, 3> cell{};
        for (std::size_t i = 0; i < 3; ++i) {
            ASSERT_GT(p[i], -0.021);  // a cluster's radius is below .02
            ASSERT_LT(p[i], 1.021);
            cell[i] = static_cast<int>(std::floor(p[i] * 20));
        }
        cells.insert(cell);
    }
    // 60 clusters no wider than a cell touch at most 8 cells each; uniform points fill 8000.
    EXPECT_LE(cells.size(), 480U);
    EXPECT_GE(cells.size(), 40U);

    // From one point to the next in the same cluster, z differs .3 times as much as x.
    double x = 0;
    double z = 0;
    for (std::size_t i = 1; i < points.size(); ++i) {
        if (distance(points[i - 1], points[i]) > 0.04) continue;
        x += std::abs(points[i][0] - points[i - 1][0]);
        z += std::abs(points[i][2] - points[i - 1][2]);
    }
    EXPECT_NEAR(z / x, 0.3, 0.05);
}

TEST(Distributions, MixedSetsAreHalfUniform) {
    const double width = 0.01;
    const Points diagonal = points_of("mixdiag", 20000);
    const Points sphere = points_of("mixsphere", 20000);
    const Points spiral = points_of("mixspiral", 1000);
    double uniform_far = 0;
    for (std::size_t i = 1; i < 20000; i += 2) {
        ASSERT_LE(distance_from_diagonals(diagonal[i]), width * std::sqrt(3) / 2);
        ASSERT_NEAR(ellipsoid_norm(sphere[i], {0.5, 0.5, 0.5}), 1, width * 0.50001);
        uniform_far = std::max(uniform_far, distance_from_diagonals(diagonal[i - 1]));
    }
    EXPECT_GT(uniform_far, 0.3);
    for (std::size_t i = 1; i < 1000; i += 2) {
        ASSERT_LE(distance_from_spiral(spiral[i], width), width * (std::sqrt(3) / 2 + 0.02));
    }
    for (const Points* points : {&diagonal, &sphere}) {
        int in_corner = 0;  // an eighth of the uniform half, besides what else is there
        for (std::size_t i = 0; i < 20000; i += 2) {
            const Point& p = (*points)[i];
            if (p[0] < 0.5 && p[1] < 0.5 && p[2] < 0.5) ++in_corner;
        }
        EXPECT_NEAR(in_corner, 1250, 170);
    }
}

TEST(Distributions, LatticeIsTheStartOfACube) {
    const Points points = points_of("lattice", 30);  // of 4^3
    EXPECT_EQ(distinct(points), 30U);
    for (const Point& p : points) {
        for (const double c : p) {
            EXPECT_EQ(c, std::floor(c));
            EXPECT_GE(c, 0);
            EXPECT_LE(c, 3);
        }
    }
    const Points cube = points_of("lattice", 27);
    EXPECT_EQ(distinct(cube), 27U);
    for (const Point& p : cube) EXPECT_LE(std::max({p[0], p[1], p[2]}), 2);
}

TEST(Distributions, IntegerSphereIsWholeAndCospherical) {
    const Points points = points_of("integer-sphere", 1000000);
    // Sums of three squares: r3(1105^2) = 6 * 5 * 13 * 17, as each prime is 1 modulo 4.
    EXPECT_EQ(points.size(), 6630U);
    EXPECT_EQ(distinct(points), 6630U);
    for (const Point& p : points) {
        for (const double c : p) ASSERT_EQ(c, std::floor(c));
        ASSERT_EQ(p[0] * p[0] + p[1] * p[1] + p[2] * p[2], 1105.0 * 1105.0);
    }
    const std::set<Point> all(points.begin(), points.end());
    for (const Point& p : points_of("integer-sphere", 100)) EXPECT_EQ(all.count(p), 1U);
}

TEST(Distributions, CurvesOfQuadraticSizeAreExact) {
    for (const Point& p : points_of("moment-curve", 1000)) {
        EXPECT_EQ(p[1], p[0] * p[0]);
        EXPECT_EQ(p[2], p[0] * p[0] * p[0]);
    }
    std::size_t first = 0;
    for (const Point& p : points_of("two-lines", 1000)) {
        const bool on_first = p[1] == 0.5 && p[2] == 0.25;
        EXPECT_TRUE(on_first || (p[0] == 0.5 && p[2] == 0.75));
        if (on_first) ++first;
    }
    EXPECT_EQ(first, 500U);
}

TEST(Distributions, RoundedAndRepeatedCoordinates) {
    for (const Point& p : points_of("rounded", 1000)) {
        for (const double c : p) {
            EXPECT_EQ(c * 1024, std::floor(c * 1024));
            EXPECT_LE(c, 1);
        }
    }
    const Points repeats = points_of("lattice-repeats", 100000);
    EXPECT_EQ(distinct(repeats), 8000U);  // each of them missed with probability 4e-6
    for (const Point& p : repeats) {
        for (const double c : p) EXPECT_TRUE(c >= 0 && c <= 19 && c == std::floor(c));
    }
}

// In integers, where nothing is rounded: the coordinates are multiples of 2^-53 below 4.
std::int64_t scaled_integer(double c, int exponent) {
    const double scaled = std::ldexp(c, exponent);
    EXPECT_EQ(scaled, std::floor(scaled));
    return static_cast<std::int64_t>(scaled);
}

TEST(Distributions, FlatSetsAreExactlyFlat) {
    const Points plane = points_of("coplanar", 5000);
    EXPECT_EQ(distinct(plane), plane.size());
    for (const Point& p : plane) {
        ASSERT_EQ(scaled_integer(p[0], 24) + 2 * scaled_integer(p[1], 24),
                  3 * scaled_integer(p[2], 24));
    }
    const Points line = points_of("collinear", 5000);
    EXPECT_EQ(distinct(line), line.size());
    for (const Point& p : line) {
        ASSERT_EQ(2 * scaled_integer(p[0], 53), scaled_integer(p[1], 53));
        ASSERT_EQ(3 * scaled_integer(p[0], 53), scaled_integer(p[2], 53));
    }
    EXPECT_EQ(distinct(points_of("one-point", 1000)), 1U);
}

TEST(Distributions, AnisotropicIsLongAndThin) {
    Point most{0, 0, 0};
    for (const Point& p : points_of("anisotropic", 1000)) {
        for (std::size_t i = 0; i < 3; ++i) most[i] = std::max(most[i], p[i]);
    }
    EXPECT_NEAR(most[0], 1e6, 2e4);
    EXPECT_NEAR(most[1], 1, 2e-2);
    EXPECT_NEAR(most[2], 1e-6, 2e-8);
}

TEST(Distributions, BadPointIsInTheMiddle) {
    for (const std::string kind : {"nan", "infinity"}) {
        const Points points = points_of(kind, 1001);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool finite = std::isfinite(points[i][0]) && std::isfinite(points[i][1]) &&
                                std::isfinite(points[i][2]);
            EXPECT_EQ(finite, i != 500) << kind << " " << i;
        }
        EXPECT_EQ(std::isnan(points[500][1]), kind == "nan");
    }
}

TEST(Distributions, ScaleReachesTheEndsOfTheRange) {
    for (const double scale : {1e60, 1e300, 1e-300, 1e-310}) {
        GenerateOptions options = with_seed(1);
        options.scale = scale;
        const std::vector<double> plain = generate("uniform", 1000, with_seed(1));
        const std::vector<double> scaled = generate("uniform", 1000, options);
        for (std::size_t i = 0; i < plain.size(); ++i) ASSERT_EQ(scaled[i], plain[i] * scale);
        EXPECT_EQ(std::fpclassify(scaled[0]), scale < 1e-305 ? FP_SUBNORMAL : FP_NORMAL);
    }
}

TEST(Distributions, UnknownKindIsRefusedByName) {
    try {
        generate("sponge", 10, with_seed(1));
        FAIL() << "accepted";
    } catch (const std::invalid_argument& e) {
        EXPECT_NE(std::string(e.what()).find("'sponge'"), std::string::npos);
        EXPECT_NE(std::string(e.what()).find("mixspiral"), std::string::npos);
    }
}

}  // namespace
}  // namespace mgdt::cli
