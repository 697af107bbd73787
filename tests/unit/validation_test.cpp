// SPDX-License-Identifier: MIT
// The pairs of a boundary that offend, beside a test of all pairs.
#include "boundary/validation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>
#include <vector>

#include "unwatched.hpp"

namespace mgdt {
namespace {

using Pairs = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

struct Fixture {
    Allocator allocator;
    Boundary boundary{allocator};
    Unwatched unwatched;

    std::uint32_t point(double x, double y, double z) {
        for (const double of : {x, y, z}) boundary.points.push_back(of);
        return static_cast<std::uint32_t>(boundary.points.size() / 3 - 1);
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        for (const std::uint32_t v : {a, b, c}) boundary.triangles.push_back(v);
    }
    void segment(std::uint32_t a, std::uint32_t b) {
        for (const std::uint32_t v : {a, b}) boundary.segments.push_back(v);
    }
    Pairs found(unsigned threads = 1) {
        Team team(threads);
        Pairs pairs;
        for (const OffendingPair& p : offending_pairs(boundary, team, allocator, unwatched))
            pairs.emplace_back(p.first, p.second);
        return pairs;
    }
};

// The surface of a cube of n x n x 12 triangles with its corner at the origin.
void add_cube(Fixture& f, int n) {
    std::vector<std::uint32_t> number(static_cast<std::size_t>((n + 1) * (n + 1) * (n + 1)),
                                      0xFFFFFFFFu);
    const auto at = [&](int x, int y, int z) {
        std::uint32_t& of = number[static_cast<std::size_t>((x * (n + 1) + y) * (n + 1) + z)];
        if (of == 0xFFFFFFFFu) of = f.point(x / double(n), y / double(n), z / double(n));
        return of;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (const int w : {0, n})
            for (int u = 0; u < n; ++u)
                for (int v = 0; v < n; ++v) {
                    const auto corner = [&](int du, int dv) {
                        int x[3];
                        x[axis] = w;
                        x[(axis + 1) % 3] = u + du;
                        x[(axis + 2) % 3] = v + dv;
                        return at(x[0], x[1], x[2]);
                    };
                    f.triangle(corner(0, 0), corner(1, 0), corner(1, 1));
                    f.triangle(corner(0, 0), corner(1, 1), corner(0, 1));
                }
}

TEST(Validation, PassesACubeWithItsEdges) {
    Fixture f;
    add_cube(f, 8);
    for (std::size_t t = 0; t + 2 < f.boundary.triangles.size(); t += 3)
        f.segment(f.boundary.triangles[t], f.boundary.triangles[t + 1]);
    EXPECT_TRUE(f.found().empty());
    EXPECT_TRUE(f.found(2).empty());
}

TEST(Validation, NamesWhatCrosses) {
    Fixture f;
    add_cube(f, 1);
    // A segment through the cube crosses two facets; a point is on another one's diagonal.
    f.segment(f.point(0.25, 0.5, -1), f.point(0.25, 0.5, 2));
    f.boundary.lone_points.push_back(f.point(0.5, 0.5, 0));
    const std::uint32_t segment = 12, point = 13;
    Pairs expected;
    for (std::uint32_t t = 0; t < 12; ++t) {
        if (!meet_in_common_face(f.boundary.simplex(t), f.boundary.simplex(segment)))
            expected.emplace_back(t, segment);
        if (!meet_in_common_face(f.boundary.simplex(t), f.boundary.simplex(point)))
            expected.emplace_back(t, point);
    }
    EXPECT_EQ(expected.size(), 4u);
    EXPECT_EQ(f.found(), expected);
}

TEST(Validation, NamesFlatAndRepeatedTriangles) {
    Fixture f;
    const std::uint32_t a = f.point(0, 0, 0), b = f.point(1, 0, 0), c = f.point(2, 0, 0),
                        d = f.point(0, 1, 0);
    f.triangle(a, b, c);
    f.triangle(b, d, a);
    f.triangle(d, a, b);
    f.segment(a, d);
    f.segment(d, a);
    f.segment(c, c);
    EXPECT_EQ(f.found(), (Pairs{{0, 0}, {1, 2}, {5, 5}}));
}

TEST(Validation, OfNothingIsEmpty) {
    Fixture f;
    EXPECT_TRUE(f.found().empty());
}

TEST(Validation, FindsTheSamePairsAsATestOfAll) {
    std::mt19937 random(5);
    for (const int spread : {4, 40, 400}) {
        Fixture f;
        std::uniform_int_distribution<int> step(-4, 4), place(0, spread);
        for (int i = 0; i < 300; ++i) {
            const int x = place(random), y = place(random), z = place(random);
            std::uint32_t v[3];
            for (std::uint32_t& of : v)
                of = f.point(x + step(random) + i * 0x1p-20, y + step(random), z + step(random));
            if (i % 3 == 0)
                f.segment(v[0], v[1]);
            else if (i % 7 == 0)
                f.boundary.lone_points.push_back(v[0]);
            else
                f.triangle(v[0], v[1], v[2]);
        }
        const Pairs pairs = f.found();
        Pairs flat, expected;
        for (const auto& [a, b] : pairs)
            if (a == b) flat.emplace_back(a, b);
        const auto is_flat = [&](std::uint32_t i) {
            for (const auto& [a, b] : flat)
                if (a == i) return true;
            return false;
        };
        const auto n = static_cast<std::uint32_t>(f.boundary.size());
        for (std::uint32_t i = 0; i < n; ++i) {
            if (is_flat(i)) expected.emplace_back(i, i);
            for (std::uint32_t j = i + 1; j < n; ++j)
                if (!is_flat(i) && !is_flat(j) &&
                    !meet_in_common_face(f.boundary.simplex(i), f.boundary.simplex(j)))
                    expected.emplace_back(i, j);
        }
        EXPECT_EQ(pairs, expected) << spread;
        EXPECT_EQ(f.found(2), expected) << spread;
        EXPECT_GT(expected.size(), spread == 4 ? 1000u : 0u) << spread;
    }
}

TEST(Validation, StopsOnRequest) {
    Fixture f;
    add_cube(f, 1);
    f.segment(f.point(0.25, 0.5, -1), f.point(0.25, 0.5, 2));
    f.unwatched.stop.set();
    EXPECT_THROW(f.found(), Error);
}

}  // namespace
}  // namespace mgdt
