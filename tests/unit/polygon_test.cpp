// SPDX-License-Identifier: MIT
// Triangulations of polygons beside a plain search for the shortest ear, in integers.
#include "boundary/polygon.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <vector>

namespace mgdt {
namespace {

using Corners = std::vector<std::uint32_t>;

struct Lattice {
    std::vector<double> points;  // with z = 0

    std::int64_t turn(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        const auto at = [&](std::uint32_t v, unsigned k) {
            return static_cast<std::int64_t>(points[3 * std::size_t{v} + k]);
        };
        return (at(b, 0) - at(a, 0)) * (at(c, 1) - at(a, 1)) -
               (at(b, 1) - at(a, 1)) * (at(c, 0) - at(a, 0));
    }
    std::int64_t squared_length(std::uint32_t a, std::uint32_t b) const {
        std::int64_t sum = 0;
        for (unsigned k = 0; k < 2; ++k) {
            const auto d = static_cast<std::int64_t>(points[3 * std::size_t{b} + k] -
                                                     points[3 * std::size_t{a} + k]);
            sum += d * d;
        }
        return sum;
    }
};

// Cuts off the ear with the shortest new edge, the first of equal ones, again and again. All
// corners have different places.
std::optional<Corners> cut_plainly(const Lattice& lattice, Corners left) {
    Corners triangles;
    while (left.size() >= 3) {
        const std::size_t n = left.size();
        std::size_t best = n;
        for (std::size_t i = 0; i < n; ++i) {
            const std::uint32_t a = left[(i + n - 1) % n], b = left[i], c = left[(i + 1) % n];
            if (lattice.turn(a, b, c) <= 0) continue;
            if (std::any_of(left.begin(), left.end(), [&](std::uint32_t k) {
                    return k != a && k != b && k != c && lattice.turn(a, b, k) >= 0 &&
                           lattice.turn(b, c, k) >= 0 && lattice.turn(c, a, k) >= 0;
                }))
                continue;
            if (best == n ||
                lattice.squared_length(a, c) <
                    lattice.squared_length(left[(best + n - 1) % n], left[(best + 1) % n]))
                best = i;
            if (n == 3) break;  // the last triangle begins with its first corner
        }
        if (best == n) return std::nullopt;
        const std::size_t first = n == 3 ? 0 : (best + n - 1) % n;
        for (std::size_t k = 0; k < 3; ++k) triangles.push_back(left[(first + k) % n]);
        left.erase(left.begin() + static_cast<std::ptrdiff_t>(best));
        if (n == 3) break;
    }
    return triangles;
}

// A polygon around the origin whose corners are on a lattice, in order of their angles.
Lattice random_star(unsigned seed, std::size_t count) {
    std::mt19937 random(seed);
    const int side = 3 + static_cast<int>(seed % 40);
    std::uniform_int_distribution<int> coordinate(-side, side);
    std::set<std::pair<int, int>> directions;
    std::vector<std::pair<int, int>> corners;
    for (std::size_t i = 0; i < count; ++i) {
        const int x = coordinate(random), y = coordinate(random);
        const int divisor = std::gcd(x, y);
        if (divisor != 0 && directions.insert({x / divisor, y / divisor}).second)
            corners.push_back({x, y});
    }
    std::sort(corners.begin(), corners.end(), [](const auto& a, const auto& b) {
        return std::atan2(a.second, a.first) < std::atan2(b.second, b.first);
    });
    Lattice lattice;
    for (const auto& [x, y] : corners) {
        lattice.points.push_back(x);
        lattice.points.push_back(y);
        lattice.points.push_back(0);
    }
    return lattice;
}

Corners all_corners(const Lattice& lattice) {
    Corners corners;
    for (std::uint32_t i = 0; i < lattice.points.size() / 3; ++i) corners.push_back(i);
    return corners;
}

std::optional<Corners> triangles_of(const Lattice& lattice, const Corners& corners) {
    Allocator allocator;
    Buffer<std::uint32_t> triangles(allocator);
    if (!triangulate_polygon(lattice.points.data(), corners.data(), corners.size(), triangles))
        return std::nullopt;
    return Corners(triangles.begin(), triangles.end());
}

TEST(Polygon, TheShortestEarIsCutOffFirst) {
    std::size_t concave = 0;
    for (unsigned seed = 1; seed < 400; ++seed) {
        const Lattice lattice = random_star(seed, 4 + seed % 60);
        const Corners corners = all_corners(lattice);
        const std::size_t n = corners.size();
        // A gap of half a turn has the origin outside, and the corners may turn right.
        std::int64_t area = 0;
        for (std::size_t i = 0; i + 2 < n; ++i)
            area += lattice.turn(corners[0], corners[i + 1], corners[i + 2]);
        if (n < 4 || area <= 0) continue;
        const std::optional<Corners> expected = cut_plainly(lattice, corners);
        ASSERT_EQ(triangles_of(lattice, corners), expected) << "seed " << seed;
        if (!expected) continue;
        for (std::size_t i = 0; i < n; ++i)
            concave += lattice.turn(corners[i], corners[(i + 1) % n], corners[(i + 2) % n]) < 0;
    }
    EXPECT_GT(concave, 1000u);
}

// In a comb, nearly every ear waits for another corner.
TEST(Polygon, Combs) {
    for (const std::uint32_t teeth : {2u, 9u, 40u}) {
        Lattice lattice;
        const auto add = [&](double x, double y) {
            for (const double c : {x, y, 0.0}) lattice.points.push_back(c);
        };
        add(-1, -2);
        add(2 * double(teeth), -2);
        for (std::uint32_t i = teeth; i-- > 0;) {
            add(2 * double(i) + 1, 50 + i % 7);
            add(2 * double(i), i % 3);
        }
        const Corners corners = all_corners(lattice);
        const std::optional<Corners> expected = cut_plainly(lattice, corners);
        ASSERT_TRUE(expected);
        EXPECT_EQ(triangles_of(lattice, corners), expected);
    }
}

// Each of 20,000 corners is compared with those in the box of its ear alone. A search through all
// ears for each triangle would take minutes.
TEST(Polygon, ManyCorners) {
    const std::uint32_t n = 20000;
    Lattice lattice;
    for (std::uint32_t i = 0; i < n; ++i) {
        const double angle = 6.283185307179586 * i / n;
        for (const double c : {std::cos(angle), std::sin(angle), 0.0}) lattice.points.push_back(c);
    }
    const std::optional<Corners> triangles = triangles_of(lattice, all_corners(lattice));
    ASSERT_TRUE(triangles);
    EXPECT_EQ(triangles->size(), 3 * (std::size_t{n} - 2));
}

}  // namespace
}  // namespace mgdt
