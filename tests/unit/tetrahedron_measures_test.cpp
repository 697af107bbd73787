// SPDX-License-Identifier: MIT
// Measures of tetrahedra beside rational numbers and floats of 100 digits.
#include "query/tetrahedron_measures.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <functional>
#include <iterator>
#include <random>

#include "../support/small.h"

namespace mgdt {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Float = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>>;
using Row = std::array<Rational, 3>;
using Points = std::array<std::array<double, 3>, 4>;
using M = TetrahedronMeasure;

constexpr M all_measures[] = {M::volume,
                              M::radius_ratio,
                              M::volume_length,
                              M::least_dihedral_angle,
                              M::largest_dihedral_angle,
                              M::longest_edge,
                              M::edge_ratio};

Row minus(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    Row r;
    for (std::size_t k = 0; k < 3; ++k) r[k] = Rational(a[k]) - Rational(b[k]);
    return r;
}
Row cross(const Row& a, const Row& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Rational dot(const Row& a, const Row& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
Float root(const Rational& x) {
    return sqrt(Float(x));
}

Rational volume6(const Points& p) {
    return abs(dot(minus(p[1], p[0]), cross(minus(p[2], p[0]), minus(p[3], p[0]))));
}

// The measure by its definition, from other formulas than the library's.
Float expected(const Points& p, M measure) {
    Rational longest = 0, shortest = -1, sum = 0;
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = i + 1; j < 4; ++j) {
            const Rational square = dot(minus(p[i], p[j]), minus(p[i], p[j]));
            longest = std::max(longest, square);
            shortest = shortest < 0 ? square : std::min(shortest, square);
            sum += square;
        }
    if (measure == M::longest_edge) return root(longest);
    if (measure == M::edge_ratio) return root(longest / shortest);
    if (measure == M::volume) return Float(volume6(p)) / 6;
    if (measure == M::volume_length) {
        const Float mean = root(sum / 6);
        return sqrt(Float(2)) * Float(volume6(p)) / (mean * mean * mean);
    }
    if (measure == M::radius_ratio) {
        // Three times the volume over the area of the surface; the circumradius by Cramer's rule.
        Float surface = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            const auto &a = p[(i + 1) % 4], &b = p[(i + 2) % 4], &c = p[(i + 3) % 4];
            const Row normal = cross(minus(b, a), minus(c, a));
            surface += root(dot(normal, normal)) / 2;
        }
        const Row a = minus(p[1], p[0]), b = minus(p[2], p[0]), c = minus(p[3], p[0]);
        const Row bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
        const Rational twice = 2 * dot(a, bc);
        Row center;
        for (std::size_t k = 0; k < 3; ++k)
            center[k] = (dot(a, a) * bc[k] + dot(b, b) * ca[k] + dot(c, c) * ab[k]) / twice;
        return 3 * (Float(volume6(p)) / 2 / surface) / root(dot(center, center));
    }
    // The angle at an edge is that between the components of two others normal to it.
    Float extreme = -1;
    for (std::size_t i = 0; i < 4; ++i) {
        for (std::size_t j = i + 1; j < 4; ++j) {
            std::size_t others[2], n = 0;
            for (std::size_t k = 0; k < 4; ++k)
                if (k != i && k != j) others[n++] = k;
            const Row edge = minus(p[j], p[i]);
            Row side[2];
            for (int s = 0; s < 2; ++s) {
                side[s] = minus(p[others[s]], p[i]);
                const Rational along = dot(side[s], edge) / dot(edge, edge);
                for (std::size_t k = 0; k < 3; ++k) side[s][k] -= along * edge[k];
            }
            const Row normal = cross(side[0], side[1]);
            const Float angle = atan2(root(dot(normal, normal)), Float(dot(side[0], side[1])));
            const bool is_more =
                measure == M::least_dihedral_angle ? angle < extreme : angle > extreme;
            if (extreme < 0 || is_more) extreme = angle;
        }
    }
    return extreme;
}

double measured(const Points& p, M measure, int scale = 0) {
    Allocator allocator;
    return measure_tetrahedron({p[0].data(), p[1].data(), p[2].data(), p[3].data()}, scale, measure,
                               allocator);
}

void expect_measures(const Points& p, double tolerance = tetrahedron_measure_error) {
    for (const M measure : all_measures) {
        const Float exact = expected(p, measure);
        const double x = measured(p, measure);
        const bool is_angle =
            measure == M::least_dihedral_angle || measure == M::largest_dihedral_angle;
        if (exact > std::numeric_limits<double>::max()) {
            EXPECT_EQ(x, HUGE_VAL);
        } else if (exact < std::numeric_limits<double>::min()) {
            EXPECT_LE(abs(Float(x) - exact), std::numeric_limits<double>::min());
        } else {
            EXPECT_LE(abs(Float(x) - exact), tolerance * (is_angle ? Float(1) : exact))
                << "measure " << static_cast<int>(measure) << ": " << x << " for " << exact;
        }
    }
}

Points random_points(std::mt19937& draw, double size) {
    std::uniform_real_distribution<double> coordinate(-size, size);
    Points p;
    for (auto& x : p)
        for (double& c : x) c = coordinate(draw);
    return p;
}

TEST(TetrahedronMeasures, OfARegularOne) {
    const Points p = {{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}};
    EXPECT_NEAR(measured(p, M::volume), 8.0 / 3, 1e-14);
    EXPECT_NEAR(measured(p, M::radius_ratio), 1, 1e-14);
    EXPECT_NEAR(measured(p, M::least_dihedral_angle), std::acos(1.0 / 3), 1e-14);
    EXPECT_NEAR(measured(p, M::largest_dihedral_angle), std::acos(1.0 / 3), 1e-14);
    EXPECT_NEAR(measured(p, M::longest_edge), std::sqrt(8), 1e-14);
    EXPECT_NEAR(measured(p, M::volume_length), 1, 1e-14);
    EXPECT_NEAR(measured(p, M::edge_ratio), 1, 1e-14);
}

TEST(TetrahedronMeasures, OfOrdinaryOnes) {
    std::mt19937 draw(1);
    for (int i = 0; i < fewer(100); ++i) expect_measures(random_points(draw, 1));
}

// Four points that rounding moved out of a plane, or near a line, far from the origin.
TEST(TetrahedronMeasures, OfFlatAndThinOnes) {
    std::mt19937 draw(2);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (const double height : {1e-2, 1e-5, 1e-9, 1e-14, 1e-30, 1e-300}) {
        for (int i = 0; i < fewer(6); ++i) {
            Points flat = random_points(draw, 1), thin = random_points(draw, height);
            for (auto& x : flat) x[2] = height * unit(draw);
            for (auto& x : thin) x[0] = unit(draw);
            if (volume6(flat) > 0) expect_measures(flat);
            if (volume6(thin) > 0) expect_measures(thin);
            for (auto& x : flat) {
                const double z = .28 * x[1] - .96 * x[2];
                x[1] = .96 * x[1] + .28 * x[2] + 100;
                x[2] = z;
            }
            if (volume6(flat) > 0) expect_measures(flat);
        }
    }
}

TEST(TetrahedronMeasures, OfAnySize) {
    std::mt19937 draw(3);
    for (const double size : {1e-308, 1e-200, 1e-110, 1e-30, 1e30, 1e95, 1e150, 1e307}) {
        for (int i = 0; i < fewer(5); ++i) expect_measures(random_points(draw, size));
    }
    expect_measures({{{0, 0, 0}, {5e-324, 0, 0}, {0, 5e-324, 0}, {0, 0, 5e-324}}});
    expect_measures({{{1e308, 0, 0}, {-1e308, 0, 0}, {0, 1e308, 1}, {0, 0, 1.7e308}}});
    // Coordinates of every size in one tetrahedron.
    std::uniform_int_distribution<int> exponent(-1000, 1000);
    for (int i = 0; i < fewer(8); ++i) {
        Points p = random_points(draw, 1);
        for (auto& x : p)
            for (double& c : x) c = std::ldexp(c, exponent(draw));
        if (volume6(p) > 0) expect_measures(p);
    }
}

TEST(TetrahedronMeasures, DependOnNeitherOrderNorScale) {
    std::mt19937 draw(4);
    for (int i = 0; i < fewer(50); ++i) {
        Points p = random_points(draw, 1);
        if (i % 2 == 1)
            for (auto& x : p) x[2] *= 1e-12;
        double reference[5];
        for (std::size_t m = 0; m < 5; ++m) reference[m] = measured(p, all_measures[m]);
        std::sort(p.begin(), p.end());
        do {
            for (std::size_t m = 0; m < 5; ++m)
                EXPECT_EQ(measured(p, all_measures[m]), reference[m]);
        } while (std::next_permutation(p.begin(), p.end()));
        // Vertices that were multiplied by a power of two, at whose end differences overflow.
        for (const int scale : {30, 900, 1023, -900}) {
            Points scaled = p;
            for (auto& x : scaled)
                for (double& c : x) c = std::ldexp(c, scale);
            for (std::size_t m = 0; m < 5; ++m)
                EXPECT_EQ(measured(scaled, all_measures[m], scale), reference[m]) << scale;
        }
    }
}

// The least volume of what doubles measure matters: flatter ones are off by more than the bound.
TEST(TetrahedronMeasures, FlatterOnesAreNotForDoubles) {
    std::mt19937 draw(5);
    constexpr std::size_t count = std::size(all_measures);
    double worst[count] = {};
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int i = 0; i < std::max(fewer(400), 80); ++i) {
        Points p = random_points(draw, 1);
        const double height = std::pow(10, -6 * (unit(draw) + 1));
        for (auto& x : p) {
            x[2] *= height;
            if (i % 2 == 1) x[1] *= height;
            // Turned, so that no axis is special.
            const double z = .28 * x[1] - .96 * x[2], y = .96 * x[1] + .28 * x[2];
            x = {.6 * x[0] - .8 * y, .8 * x[0] + .6 * y, z + x[0]};
        }
        for (std::size_t m = 0; m < count; ++m) {
            const double* const q[4] = {p[0].data(), p[1].data(), p[2].data(), p[3].data()};
            double x = 0;
            const M measure = all_measures[m];
            const Float exact = expected(p, measure);
            const bool is_angle =
                measure == M::least_dihedral_angle || measure == M::largest_dihedral_angle;
            const auto error = [&] {
                return static_cast<double>(abs(Float(x) - exact) / (is_angle ? Float(1) : exact));
            };
            const double least = measure == M::volume ? exact::least_volume_for_volumes
                                                      : exact::least_volume_in_doubles;
            if (exact::measure_in_doubles(q, 0, measure, x, least)) {
                EXPECT_LE(error(), tetrahedron_measure_error);
            }
            if (exact::measure_in_doubles(q, 0, measure, x, 0))
                worst[m] = std::max(worst[m], error());
        }
    }
    for (std::size_t m = 0; m < count; ++m) {
        if (all_measures[m] == M::longest_edge || all_measures[m] == M::edge_ratio)
            EXPECT_LE(worst[m], tetrahedron_measure_error) << m;
        else
            EXPECT_GT(worst[m], tetrahedron_measure_error) << m;
    }
}

}  // namespace
}  // namespace mgdt
