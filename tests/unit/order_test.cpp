// SPDX-License-Identifier: MIT
// Every order scheme on every set.
#include "order_sets.hpp"

namespace {

using namespace order_test;

class EveryScheme : public testing::TestWithParam<std::int32_t> {};

INSTANTIATE_TEST_SUITE_P(Order, EveryScheme, testing::ValuesIn([] {
                             std::vector<std::int32_t> all;
                             for (const auto& scheme : schemes) all.push_back(scheme.first);
                             return all;
                         }()),
                         [](const auto& info) {
                             std::string name = schemes.at(info.param);
                             std::replace(name.begin(), name.end(), '-', '_');
                             return name;
                         });

TEST_P(EveryScheme, GivesAPermutationOfEverySet) {
    for (const std::size_t n : {0u, 1u, 2u, 3u, 4u, 7u, 25u, 300u, 3000u}) {
        for (const auto& [name, xyz] : all_sets(n)) {
            SCOPED_TRACE(name + ", " + std::to_string(n) + " points");
            const Result result = schedule(xyz, GetParam());
            expect_sound(result, n);
            EXPECT_TRUE(result == schedule(xyz, GetParam())) << "a second run differs";
        }
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
                        expect_sound(schedule(xyz, GetParam(), parameters), xyz.size() / 3);
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
    const Result expected = schedule(points, GetParam());
    for (int k = 0; k < 3; ++k) points.axis[k] = backwards.data() + backwards.size() - 1 - k;
    points.stride = -3;
    EXPECT_TRUE(schedule(points, GetParam()) == expected);
}

TEST_P(EveryScheme, DoesNotDependOnThePowerOfTwoOfTheUnit) {
    const Coordinates xyz = uniform(2000);
    Coordinates small = xyz;
    for (double& x : small) x = std::ldexp(x, -700);
    EXPECT_TRUE(schedule(point_set(small, 0x1p700), GetParam()) == schedule(xyz, GetParam()));
    EXPECT_TRUE(schedule(point_set(small), GetParam()) == schedule(xyz, GetParam()));
}

struct Source {
    long left;  // allocations until the source refuses
    std::size_t blocks = 0;

    static void* allocate(std::size_t size, std::size_t align, void* user) {
        Source& source = *static_cast<Source*>(user);
        if (source.left == 0) return nullptr;
        --source.left;
        ++source.blocks;
        return ::operator new(size, std::align_val_t(align));
    }
    static void release(void* p, std::size_t, std::size_t align, void* user) {
        --static_cast<Source*>(user)->blocks;
        ::operator delete(p, std::align_val_t(align));
    }
};

TEST_P(EveryScheme, UnwindsWhereverMemoryEnds) {
    for (const Coordinates& xyz : {uniform(1500), noisy_line(1500)}) {
        bool complete = false;
        for (long allowed = 0; !complete; ++allowed) {
            ASSERT_LT(allowed, 1000) << "never enough";
            Source source{allowed};
            {
                Allocator allocator(Source::allocate, Source::release, &source);
                try {
                    expect_sound(schedule(point_set(xyz), GetParam(), {}, &allocator),
                                 xyz.size() / 3);
                    complete = true;
                } catch (const std::bad_alloc&) {
                }
                EXPECT_EQ(allocator.bytes(), 0u);
            }
            EXPECT_EQ(source.blocks, 0u);
            EXPECT_TRUE(!complete || allowed > 0);
        }
    }
}

TEST_P(EveryScheme, NeedsMemoryInProportion) {
    const Coordinates xyz = uniform(20000);
    Allocator allocator;
    schedule(point_set(xyz), GetParam(), {}, &allocator);
    EXPECT_LT(allocator.peak(), 20000 * 40u);
}

}  // namespace
