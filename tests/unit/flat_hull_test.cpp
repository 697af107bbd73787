// SPDX-License-Identifier: MIT
// The hull of points that do not span space, against all triangles of points.
#include "query/flat_hull.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "../support/points.hpp"
#include "../support/small.h"
#include "core/triangulation.hpp"

namespace mgdt {
namespace {

using mgdt_tests::Points;

struct Place {
    int x, y;
};

int turn(const Place& a, const Place& b, const Place& c) {
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

// In the closed triangle, which may be a segment or a point.
bool is_in(const Place& q, const Place& a, const Place& b, const Place& c) {
    const int ab = turn(a, b, q), bc = turn(b, c, q), ca = turn(c, a, q);
    if ((ab < 0 || bc < 0 || ca < 0) && (ab > 0 || bc > 0 || ca > 0)) return false;
    return q.x >= std::min({a.x, b.x, c.x}) && q.x <= std::max({a.x, b.x, c.x}) &&
           q.y >= std::min({a.y, b.y, c.y}) && q.y <= std::max({a.y, b.y, c.y});
}

bool is_in_hull(const Place& q, const std::vector<Place>& places) {
    for (const Place& a : places)
        for (const Place& b : places)
            for (const Place& c : places)
                if (is_in(q, a, b, c)) return true;
    return false;
}

TEST(FlatHull, ContainsWhatSomeTriangleContains) {
    std::mt19937 random(1);
    const auto any = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    for (int run = 0; run < (is_small() ? 30 : 300); ++run) {
        const int count = 1 + any(7), size = 2 + any(6);
        const double scale = std::ldexp(1, run % 5 * 100 - 200);
        std::vector<Place> places;
        for (int i = 0; i < count; ++i) {
            // Now and then all on one line.
            const int x = any(size), y = run % 3 == 0 ? 2 * x - 1 : any(size);
            places.push_back({x, y});
        }
        // Planes of several directions.
        const auto point = [&](const Place& p, double off) {
            const double x = p.x, y = p.y;
            const double of[4][3] = {
                {x, y, off}, {off, x, y}, {y, off, x}, {x + off, y - off, 2 * x - y + off}};
            return Points{of[run % 4][0] * scale, of[run % 4][1] * scale, of[run % 4][2] * scale};
        };
        Points xyz;
        for (const Place& p : places)
            for (const double x : point(p, 0)) xyz.push_back(x);
        Triangulation t(nullptr, nullptr, nullptr);
        const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
        t.insert(places.size(), axis, 3);
        FlatHull hull(t.mesh(), t.allocator());
        for (int k = 0; k < 30; ++k) {
            const Place q = {any(size + 2) - 1, any(size + 2) - 1};
            Points in = point(q, 0), off = point(q, k % 2 ? 1 : 0x1p-40);
            for (Points* at : {&in, &off})
                for (double& x : *at) x = std::ldexp(x, t.mesh().scale);
            EXPECT_EQ(hull.contains(in.data()), is_in_hull(q, places));
            EXPECT_FALSE(hull.contains(off.data()));
        }
    }
}

TEST(FlatHull, OfNothingIsEmpty) {
    Triangulation t(nullptr, nullptr, nullptr);
    const double q[3] = {0, 0, 0};
    EXPECT_FALSE(FlatHull(t.mesh(), t.allocator()).contains(q));
}

}  // namespace
}  // namespace mgdt
