// SPDX-License-Identifier: MIT
// The power of two by which a handle multiplies its coordinates: few of them stay outside the range
// in which filters are proved, however the others lie.
#include "mesh/scale.hpp"

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <vector>

#include "core/triangulation.hpp"
#include "point_families.hpp"
#include "unwatched.hpp"

namespace {

using families::Random;
using mgdt::ExponentRange;
using mgdt::Triangulation;

ExponentRange range_of(std::initializer_list<double> values) {
    ExponentRange range;
    for (const double x : values) range.add(x);
    return range;
}

void insert(Triangulation& t, const std::vector<double>& xyz) {
    const double* const axis[3] = {&xyz[0], &xyz[1], &xyz[2]};
    t.insert(xyz.size() / 3, axis, 3);
}

std::vector<double> uniform(Random& random, std::size_t n, double size = 1) {
    std::vector<double> xyz(3 * n);
    for (double& x : xyz) x = random.uniform(0.001, 1) * size;
    return xyz;
}

TEST(Scale, IsNormalWhereAllCoordinatesAre) {
    EXPECT_TRUE(mgdt::is_normal(range_of({0x1p-150, 0x1p149}), 0));
    EXPECT_FALSE(mgdt::is_normal(range_of({0x1p-151}), 0));
    EXPECT_FALSE(mgdt::is_normal(range_of({0x1p150}), 0));
    EXPECT_TRUE(mgdt::is_normal(range_of({0x1p-1000}), 1000));
    EXPECT_FALSE(mgdt::is_normal(range_of({0x1p-1000, 1}), 1000));
    EXPECT_FALSE(mgdt::is_normal(range_of({0x1p-1000, 1}), 0));
    // Multiplied, the first is no double any more.
    EXPECT_FALSE(mgdt::is_exact(range_of({0x1p-1000, 0x1p600}), -600));
    EXPECT_TRUE(mgdt::is_exact(range_of({0x1p-200, 0x1p600}), -600));
}

TEST(Scale, FindsThePowerOfTwoAboveAllNumbers) {
    const double none[3] = {0, 0, 0}, one[3] = {0.5, -1, 0}, below[1] = {0.75},
                 tiny[2] = {0x1p-1074, 0};
    EXPECT_EQ(mgdt::exponent_above(none, 3), 0);
    EXPECT_EQ(mgdt::exponent_above(one, 3), 1);
    EXPECT_EQ(mgdt::exponent_above(below, 1), 0);
    EXPECT_EQ(mgdt::exponent_above(tiny, 2), -1073);
}

TEST(Scale, FollowsMostOfTheCoordinates) {
    EXPECT_EQ(mgdt::choose_scale_of_most(range_of({1, 1e300}), 0), 0);
    EXPECT_EQ(mgdt::choose_scale_of_most(range_of({1, 1e300}), 30), 0);
    EXPECT_EQ(mgdt::choose_scale_of_most(range_of({1e300, 1e200}), 664), -664);
    EXPECT_EQ(mgdt::choose_scale_of_most(range_of({1e-300, 1e300}), 664), 0);  // not exact
}

// One point, or one point in ten, does not take the filters from the others.
TEST(Scale, LeavesMostDecisionsToTheFilters) {
    Random random(1);
    for (const double size : {1.0, 1e200}) {
        for (const std::size_t step : {1000u, 10u}) {
            std::vector<double> xyz = uniform(random, 2000, size);
            for (std::size_t i = 0; i < 2000; i += step) xyz[3 * i + 2] *= 1e100;
            Triangulation t(nullptr, nullptr, nullptr);
            insert(t, xyz);
            EXPECT_LT(t.counters().exact_calls, 20 * t.statistics().points_inserted);
        }
    }
    // Most points decide, whichever come first.
    Triangulation t(nullptr, nullptr, nullptr);
    insert(t, {0, 0, 0, 1e300, 0, 0, 0, 1e300, 0, 0, 0, 1e300});
    insert(t, uniform(random, 2000));
    EXPECT_EQ(t.mesh().scale, 0);
    EXPECT_LT(t.counters().exact_calls, 2 * t.statistics().points_inserted);
    mgdt::Team alone;
    mgdt::check_triangulation(alone, t.check_input(), t.allocator(), MGDT_CHECK_CANONICAL, 0,
                              Unwatched());
}

}  // namespace
