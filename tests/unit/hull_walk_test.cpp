// SPDX-License-Identifier: MIT
// A walk from the hull beside a look at all balls.
#include "periodic/hull_walk.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "../support/small.h"
#include "core/triangulation.hpp"
#include "predicates/circumcenter.hpp"

namespace {

using namespace mgdt;

std::vector<std::vector<double>> sets() {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(0, 1);
    std::vector<std::vector<double>> all(5);
    for (int i = 0; i < 600; ++i) {
        const double x[3] = {place(random), place(random), place(random)};
        all[0].insert(all[0].end(), x, x + 3);
        // On a sphere, so that one ball has them all, and a thin layer.
        double size = 0;
        for (const double c : x) size += (c - 0.5) * (c - 0.5);
        for (const double c : x) all[1].push_back(0.5 + 0.45 * (c - 0.5) / std::sqrt(size));
        all[2].insert(all[2].end(), {x[0], x[1], 0.5 + 1e-6 * x[2]});
        // A lattice, which has many points on a sphere and hull facets in one plane, and one with a
        // void.
        const double y[3] = {i % 8 / 7.0, i / 8 % 8 / 7.0, i / 64 / 8.0};
        all[3].insert(all[3].end(), y, y + 3);
        if (std::hypot(y[0] - 0.3, y[1] - 0.5, y[2] - 0.5) > 0.3)
            all[4].insert(all[4].end(), y, y + 3);
    }
    return all;
}

struct Ball {
    double center[3], radius;
};

class HullWalk : public testing::TestWithParam<std::size_t> {
  protected:
    void SetUp() override {
        const double* const axis[3] = {points.data(), points.data() + 1, points.data() + 2};
        t.insert(points.size() / 3, axis, 3);
        for (TetId i = 0; i < mesh().tetrahedra.size(); ++i) {
            balls.push_back({});
            const Tetrahedron& tetrahedron = mesh().tetrahedra[i];
            if (tetrahedron.is_dead() || tetrahedron.is_ghost()) continue;
            const double* corners[4];
            for (unsigned k = 0; k < 4; ++k)
                corners[k] = points.data() + 3 * mesh().vertices[tetrahedron.v[k]].index;
            double offset[3], square = 0;
            center_offset(corners, offset);
            for (unsigned c = 0; c < 3; ++c) {
                balls[i].center[c] = corners[0][c] + offset[c];
                square += offset[c] * offset[c];
            }
            balls[i].radius = std::sqrt(square);
        }
    }
    const Mesh& mesh() const { return t.mesh(); }
    // How often each tetrahedron is visited.
    template <class Meets>
    std::vector<int> visits(const Meets& meets) {
        std::vector<int> count(mesh().tetrahedra.size());
        Allocator allocator;
        StopFlag cancelled;
        walk_from_hull(mesh(), allocator, cancelled.request(), meets, [&](TetId i) { ++count[i]; });
        return count;
    }

    std::vector<double> points = sets()[GetParam()];
    Triangulation t{nullptr, nullptr, nullptr};
    std::vector<Ball> balls;
};

// Outside of a box, of a prism without ends, and of a plate.
TEST_P(HullWalk, FindsWhatLeavesABox) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> place(-0.2, 1.2);
    std::size_t passed_over = 0;
    for (int i = 0; i < (is_small() ? 12 : 120); ++i) {
        const auto dimensions = static_cast<unsigned>(1 + random() % 3);
        double low[3], high[3];
        for (unsigned k = 0; k < 3; ++k) {
            low[k] = place(random);
            high[k] = place(random);
            if (high[k] < low[k]) std::swap(low[k], high[k]);
        }
        // Whether a ball that is larger by a share of the radius leaves it.
        const auto leaves = [&](TetId tetrahedron, double more) {
            const Ball& ball = balls[tetrahedron];
            const double radius = ball.radius * (1 + more);
            for (unsigned k = 0; k < dimensions; ++k)
                if (!(ball.center[k] - radius > low[k] && ball.center[k] + radius < high[k]))
                    return true;
            return false;
        };
        const std::vector<int> count = visits([&](TetId at) { return leaves(at, 1e-9); });
        for (TetId at = 0; at < count.size(); ++at) {
            const Tetrahedron& tetrahedron = mesh().tetrahedra[at];
            const bool is_live = !tetrahedron.is_dead();
            const bool may = is_live && (tetrahedron.is_ghost() || leaves(at, 1e-9));
            const bool has_to = is_live && (tetrahedron.is_ghost() || leaves(at, -1e-9));
            EXPECT_LE(count[at], may ? 1 : 0);
            EXPECT_GE(count[at], has_to ? 1 : 0);
            passed_over += is_live && !may ? 1 : 0;
        }
    }
    // All balls of points on a sphere or in a layer are large.
    EXPECT_TRUE(passed_over > 0 || GetParam() == 1 || GetParam() == 2);
}

// A set that does not go to infinity is not found: the test above can fail.
TEST_P(HullWalk, MissesWhatIsInside) {
    if (GetParam() != 0) return;
    const auto meets = [&](TetId tetrahedron) {
        const Ball& ball = balls[tetrahedron];
        return std::hypot(ball.center[0] - 0.5, ball.center[1] - 0.5, ball.center[2] - 0.5) <
               ball.radius + 0.01;
    };
    const std::vector<int> count = visits(meets);
    std::size_t missed = 0;
    for (TetId at = 0; at < count.size(); ++at) {
        const Tetrahedron& tetrahedron = mesh().tetrahedra[at];
        if (tetrahedron.is_dead() || tetrahedron.is_ghost()) continue;
        missed += meets(at) && count[at] == 0 ? 1 : 0;
    }
    EXPECT_GT(missed, 0u);
}

INSTANTIATE_TEST_SUITE_P(Sets, HullWalk, testing::Range(std::size_t{0}, std::size_t{5}));

}  // namespace
