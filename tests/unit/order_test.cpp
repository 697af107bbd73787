// SPDX-License-Identifier: MIT
// Every order scheme on every set.
#include "../support/limited_blocks.hpp"
#include "order_sets.hpp"

namespace {

using namespace order_test;
using mgdt_tests::LimitedBlocks;

class EveryScheme : public testing::TestWithParam<OrderScheme> {
  protected:
    static std::int32_t number() { return GetParam().number; }
};

INSTANTIATE_TEST_SUITE_P(Order, EveryScheme,
                         testing::ValuesIn(order_schemes().begin(), order_schemes().end()),
                         [](const auto& info) {
                             std::string name = info.param.name;
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST_P(EveryScheme, GivesAPermutationOfEverySet) {
    for (const std::size_t n : {0u, 1u, 2u, 3u, 4u, 7u, 25u, 300u, 3000u}) {
        for (const auto& [name, xyz] : all_sets(n)) {
            SCOPED_TRACE(name + ", " + std::to_string(n) + " points");
            const Result result = schedule(xyz, number());
            expect_sound(result, n);
            EXPECT_TRUE(result == schedule(xyz, number())) << "a second run differs";
        }
    }
}

// The table tells which parameters a scheme takes: they change some schedule, the others none.
TEST_P(EveryScheme, TakesTheParametersThatTheTableTells) {
    struct Case {
        const char* name;
        bool is_taken;
        void (*change)(OrderParameters&);
    };
    const OrderScheme& scheme = GetParam();
    const Case cases[] = {
        {"points per cell", scheme.takes_points_per_cell,
         [](OrderParameters& p) { p.points_per_cell = 40; }},
        {"threshold", scheme.takes_threshold, [](OrderParameters& p) { p.threshold = 50; }},
        {"separation", scheme.takes_separation,
         [](OrderParameters& p) { p.separation = Separation::none; }},
        {"round ratio", scheme.takes_round_ratio, [](OrderParameters& p) { p.round_ratio = 3; }},
        {"seed", scheme.takes_seed, [](OrderParameters& p) { p.seed = 7; }},
    };
    const Coordinates sets[] = {uniform(3000), noisy_line(3000)};
    for (const Case& c : cases) {
        bool has_effect = false;
        for (const Coordinates& xyz : sets)
            for (const Separation separation :
                 {Separation::none, Separation::passes, Separation::rounds}) {
                OrderParameters before;
                before.separation = separation;
                OrderParameters after = before;
                c.change(after);
                if (!(schedule(xyz, number(), before) == schedule(xyz, number(), after)))
                    has_effect = true;
            }
        EXPECT_EQ(has_effect, c.is_taken) << c.name;
    }
}

TEST_P(EveryScheme, TakesExtremeParameters) {
    const Coordinates sets[] = {uniform(700), noisy_line(700), integer_lattice(6)};
    for (const Coordinates& xyz : sets) {
        for (const double per_cell : {1.0, 1e6}) {
            for (const double threshold : {1.0, 1e9}) {
                for (const double ratio : {1.0000001, 1e6}) {
                    for (const Separation separation :
                         {Separation::none, Separation::passes, Separation::rounds}) {
                        OrderParameters parameters;
                        parameters.points_per_cell = per_cell;
                        parameters.threshold = threshold;
                        parameters.round_ratio = ratio;
                        parameters.separation = separation;
                        parameters.seed = ~std::uint64_t{0};
                        expect_sound(schedule(xyz, number(), parameters), xyz.size() / 3);
                    }
                }
            }
        }
    }
}

TEST_P(EveryScheme, ReadsSeparateArraysAndAnyStride) {
    const Coordinates xyz = uniform(500);
    Coordinates backwards(xyz.rbegin(), xyz.rend());  // z y x of the last point first
    PointSet points = point_set(xyz);
    const Result expected = schedule(points, number());
    for (int k = 0; k < 3; ++k) points.axis[k] = backwards.data() + backwards.size() - 1 - k;
    points.stride = -3;
    EXPECT_TRUE(schedule(points, number()) == expected);
}

TEST_P(EveryScheme, DoesNotDependOnThePowerOfTwoOfTheUnit) {
    const Coordinates xyz = uniform(2000);
    Coordinates small = xyz;
    for (double& x : small) x = std::ldexp(x, -700);
    EXPECT_TRUE(schedule(point_set(small, 0x1p700), number()) == schedule(xyz, number()));
    EXPECT_TRUE(schedule(point_set(small), number()) == schedule(xyz, number()));
}

TEST_P(EveryScheme, UnwindsWhereverMemoryEnds) {
    for (const Coordinates& xyz : {uniform(1500), noisy_line(1500)}) {
        bool complete = false;
        for (std::size_t allowed = 0; !complete; ++allowed) {
            ASSERT_LT(allowed, 1000u) << "never enough";
            LimitedBlocks blocks{allowed};
            {
                Allocator allocator(LimitedBlocks::take, LimitedBlocks::give_back, &blocks);
                try {
                    expect_sound(schedule(point_set(xyz), number(), {}, &allocator),
                                 xyz.size() / 3);
                    complete = true;
                } catch (const std::bad_alloc&) {
                }
                EXPECT_EQ(allocator.bytes(), 0u);
            }
            EXPECT_EQ(blocks.held, 0u);
            EXPECT_TRUE(!complete || allowed > 0);
        }
    }
}

TEST_P(EveryScheme, NeedsMemoryInProportion) {
    const Coordinates xyz = uniform(20000);
    Allocator allocator;
    schedule(point_set(xyz), number(), {}, &allocator);
    EXPECT_LT(allocator.peak(), 20000 * 40u);
}

}  // namespace
