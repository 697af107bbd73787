// SPDX-License-Identifier: MIT
// Every order scheme on friendly, flat, repeated and extreme sets, and what each one promises of
// the order itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <new>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "mgdt/mgdt.h"
#include "order/curve_sort.hpp"
#include "order/grid.hpp"
#include "order/hilbert_curve.hpp"
#include "order/kd_partition.hpp"
#include "order/lattice.hpp"
#include "order/radix.hpp"
#include "order/random.hpp"
#include "order/rounds.hpp"
#include "order/schedule.hpp"

namespace {

using namespace mgdt;

using Coordinates = std::vector<double>;
using Order = std::vector<std::uint32_t>;

PointSet point_set(const Coordinates& xyz, double scale = 1) {
    PointSet points;
    points.stride = 3;
    points.size = xyz.size() / 3;
    points.scale = scale;
    for (int k = 0; k < 3; ++k) {
        points.axis[k] = xyz.empty() ? nullptr : xyz.data() + k;
        points.low[k] = points.high[k] = points.size > 0 ? points.coordinate(0, k) : 0;
        for (std::size_t i = 0; i < points.size; ++i) {
            points.low[k] = std::min(points.low[k], points.coordinate(i, k));
            points.high[k] = std::max(points.high[k], points.coordinate(i, k));
        }
    }
    return points;
}

struct Result {
    Order order, rounds, hints;
    unsigned levels = 0;

    bool operator==(const Result& other) const {
        return order == other.order && rounds == other.rounds && hints == other.hints &&
               levels == other.levels;
    }
};

Result schedule(const PointSet& points, std::int32_t scheme, const OrderParameters& parameters = {},
                Allocator* allocator = nullptr) {
    Allocator own;
    Schedule out(allocator ? *allocator : own);
    make_schedule(points, scheme, parameters, out);
    Result result;
    result.order.assign(out.order.begin(), out.order.end());
    result.rounds.assign(out.rounds.begin(), out.rounds.end());
    result.hints.assign(out.hints.begin(), out.hints.end());
    result.levels = out.levels;
    return result;
}

Result schedule(const Coordinates& xyz, std::int32_t scheme,
                const OrderParameters& parameters = {}) {
    return schedule(point_set(xyz), scheme, parameters);
}

const std::map<std::int32_t, std::string> schemes = {
    {MGDT_ORDER_AUTO, "auto"},
    {MGDT_ORDER_INPUT, "input"},
    {MGDT_ORDER_RANDOM, "random"},
    {MGDT_ORDER_LEXICOGRAPHIC, "lexicographic"},
    {MGDT_ORDER_BRIO, "brio"},
    {MGDT_ORDER_HILBERT, "hilbert"},
    {MGDT_ORDER_REGULAR_GRID, "regular-grid"},
    {MGDT_ORDER_KD_TREE, "kd-tree"},
    {MGDT_ORDER_ENHANCED_KD_TREE, "enhanced-kd-tree"},
    {MGDT_ORDER_MULTI_GRID, "multi-grid"},
};

double unit(Random& random) {
    return static_cast<double>(random.next() >> 11) * 0x1p-53;
}

Coordinates generate(std::size_t n, const std::function<void(std::size_t, Random&, double*)>& f) {
    Random random(12345 + n);
    Coordinates xyz(3 * n);
    for (std::size_t i = 0; i < n; ++i) f(i, random, &xyz[3 * i]);
    return xyz;
}

Coordinates uniform(std::size_t n) {
    return generate(n, [](std::size_t, Random& r, double* p) {
        for (int k = 0; k < 3; ++k) p[k] = unit(r);
    });
}

Coordinates integer_lattice(std::size_t side) {
    return generate(side * side * side, [side](std::size_t i, Random&, double* p) {
        p[0] = static_cast<double>(i % side);
        p[1] = static_cast<double>(i / side % side);
        p[2] = static_cast<double>(i / side / side);
    });
}

// A long thin line with a little noise, where points crowd in few cells of any grid.
Coordinates noisy_line(std::size_t n) {
    return generate(n, [](std::size_t, Random& r, double* p) {
        const double t = unit(r);
        for (int k = 0; k < 3; ++k) p[k] = t + 1e-4 * (unit(r) - 0.5);
    });
}

std::map<std::string, Coordinates> all_sets(std::size_t n) {
    using F = std::function<void(std::size_t, Random&, double*)>;
    const double most = std::numeric_limits<double>::max();
    const double tiny = std::numeric_limits<double>::denorm_min();
    const std::map<std::string, F> makers = {
        {"one point repeated",
         [](std::size_t, Random&, double* p) { p[0] = 1, p[1] = -0.5, p[2] = 1e300; }},
        {"zeros of both signs",
         [](std::size_t i, Random&, double* p) {
             for (int k = 0; k < 3; ++k) p[k] = (i >> k) & 1 ? 0.0 : -0.0;
         }},
        {"along x", [](std::size_t, Random& r, double* p) { p[0] = unit(r), p[1] = 3, p[2] = -1; }},
        {"body diagonal", [](std::size_t, Random& r, double* p) { p[0] = p[1] = p[2] = unit(r); }},
        {"coplanar",
         [](std::size_t, Random& r, double* p) { p[0] = unit(r), p[1] = 7, p[2] = unit(r); }},
        {"largest doubles",
         [most](std::size_t, Random& r, double* p) {
             for (int k = 0; k < 3; ++k) p[k] = (2 * unit(r) - 1) * most;
         }},
        {"both largest doubles in x",
         [most](std::size_t i, Random& r, double* p) {
             p[0] = i % 2 ? most : -most, p[1] = unit(r), p[2] = 0;
         }},
        {"few subnormals",
         [tiny](std::size_t, Random& r, double* p) {
             for (int k = 0; k < 3; ++k) p[k] = tiny * static_cast<double>(r.below(3));
         }},
        {"many subnormals",
         [tiny](std::size_t, Random& r, double* p) {
             for (int k = 0; k < 3; ++k) p[k] = tiny * static_cast<double>(r.below(1u << 30));
         }},
        {"subnormals beside a constant 1e300",
         [tiny](std::size_t, Random& r, double* p) {
             p[0] = tiny * static_cast<double>(r.below(100)), p[1] = 1e300, p[2] = -1e300;
         }},
        {"1e300 and 1e-300",
         [](std::size_t i, Random& r, double* p) {
             for (int k = 0; k < 3; ++k) p[k] = (unit(r) - 0.5) * (i % 3 ? 1e-300 : 1e300);
         }},
        {"1e6 : 1 : 1e-6",
         [](std::size_t, Random& r, double* p) {
             p[0] = 1e6 * unit(r), p[1] = unit(r), p[2] = 1e-6 * unit(r);
         }},
        {"repeated lattice",
         [](std::size_t, Random& r, double* p) {
             for (int k = 0; k < 3; ++k) p[k] = r.below(5);
         }},
        {"exponential cluster",
         [](std::size_t, Random& r, double* p) {
             for (int k = 0; k < 3; ++k) {
                 p[k] = std::ldexp(unit(r), -static_cast<int>(r.below(2000)) + 900);
             }
         }},
        {"two far crowds",
         [](std::size_t i, Random& r, double* p) {
             for (int k = 0; k < 3; ++k) p[k] = static_cast<double>(i % 2) + 1e-12 * unit(r);
         }},
        {"moment curve",
         [](std::size_t, Random& r, double* p) {
             const double t = unit(r);
             p[0] = t, p[1] = t * t, p[2] = t * t * t;
         }},
    };
    std::map<std::string, Coordinates> sets;
    for (const auto& [name, maker] : makers) sets[name] = generate(n, maker);
    sets["uniform"] = uniform(n);
    sets["noisy line"] = noisy_line(n);
    return sets;
}

void expect_sound(const Result& result, std::size_t n) {
    ASSERT_EQ(result.order.size(), n);
    Order sorted = result.order;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(sorted[i], i);

    ASSERT_FALSE(result.rounds.empty());
    EXPECT_EQ(result.rounds[0], 0u);
    for (std::size_t r = 1; r < result.rounds.size(); ++r) {
        ASSERT_LT(result.rounds[r - 1], result.rounds[r]);
        ASSERT_LT(result.rounds[r], n);
    }
    if (result.hints.empty()) return;
    ASSERT_EQ(result.hints.size(), n);
    for (std::size_t k = 0; k < n; ++k) {
        const std::uint32_t hint = result.hints[k];
        ASSERT_TRUE(hint == no_hint || hint < k) << hint << " at " << k;
    }
}

double path_length(const Coordinates& xyz, const Order& order) {
    double length = 0;
    for (std::size_t k = 1; k < order.size(); ++k) {
        const double* a = &xyz[3 * std::size_t{order[k - 1]}];
        const double* b = &xyz[3 * std::size_t{order[k]}];
        length += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    return length;
}

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
                    for (const bool separation : {false, true}) {
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

TEST(Random, IsSplitmix64) {
    Random random(1234567);  // the published test vector
    EXPECT_EQ(random.next(), 6457827717110365317u);
    EXPECT_EQ(random.next(), 3203168211198807973u);
    EXPECT_EQ(Random::at(1234567, 1), 3203168211198807973u);
}

TEST(Random, DrawsBelowTheBound) {
    Random random(1);
    unsigned seen[7] = {};
    for (int i = 0; i < 7000; ++i) {
        const std::uint32_t x = random.below(7);
        ASSERT_LT(x, 7u);
        ++seen[x];
    }
    for (const unsigned count : seen) EXPECT_NEAR(count, 1000, 150);
    EXPECT_EQ(random.below(1), 0u);
}

TEST(RadixSort, SortsAsAStableSortDoes) {
    Random random(5);
    for (const std::size_t n : {0u, 1u, 2u, 24u, 25u, 100u, 5000u}) {
        for (const unsigned kept : {0u, 1u, 9u, 33u, 64u}) {  // bits in which keys differ
            std::vector<KeyedIndex> a(n), scratch(n);
            const std::uint64_t mask =
                kept == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << kept) - 1;
            for (std::size_t i = 0; i < n; ++i) {
                a[i] = {0xABCD000000000000u ^ (random.next() & mask),
                        static_cast<std::uint32_t>(i)};
            }
            std::vector<KeyedIndex> expected = a;
            std::stable_sort(expected.begin(), expected.end(),
                             [](auto& x, auto& y) { return x.key < y.key; });
            radix_sort(a.data(), scratch.data(), n, 0, 64);
            for (std::size_t i = 0; i < n; ++i) {
                ASSERT_EQ(a[i].key, expected[i].key);
                ASSERT_EQ(a[i].index, expected[i].index);
            }
        }
    }
}

TEST(Input, KeepsTheOrder) {
    const Result result = schedule(uniform(50), MGDT_ORDER_INPUT);
    for (std::uint32_t i = 0; i < 50; ++i) EXPECT_EQ(result.order[i], i);
}

TEST(RandomOrder, ShufflesByTheSeed) {
    OrderParameters parameters;
    std::set<Order> orders;
    double first = 0;
    for (parameters.seed = 0; parameters.seed < 200; ++parameters.seed) {
        const Order order = schedule(uniform(30), MGDT_ORDER_RANDOM, parameters).order;
        first += order[0];
        orders.insert(order);
    }
    EXPECT_EQ(orders.size(), 200u);
    EXPECT_NEAR(first / 200, 14.5, 2.5);  // four standard deviations of the mean
}

TEST(Lexicographic, SortsByXThenYThenZThenIndex) {
    for (auto& [name, xyz] : all_sets(3000)) {
        SCOPED_TRACE(name);
        const Order order = schedule(xyz, MGDT_ORDER_LEXICOGRAPHIC).order;
        for (std::size_t k = 1; k < order.size(); ++k) {
            const double* a = &xyz[3 * std::size_t{order[k - 1]}];
            const double* b = &xyz[3 * std::size_t{order[k]}];
            const auto key = [](const double* p, std::uint32_t i) {
                return std::make_tuple(p[0], p[1], p[2], i);
            };
            ASSERT_LT(key(a, order[k - 1]), key(b, order[k]));
        }
    }
}

TEST(HilbertCurve, VisitsEveryCellInUnitSteps) {
    for (const unsigned steps : {1u, 2u}) {
        const std::uint32_t side = 1u << (3 * steps);
        std::vector<std::uint32_t> at(std::size_t{side} * side * side, no_hint);
        for (std::uint32_t cell = 0; cell < at.size(); ++cell) {
            unsigned state = HilbertCurve::first_state;
            const std::uint64_t key = hilbert_curve.key(cell / side / side, cell / side % side,
                                                        cell % side, steps, state);
            ASSERT_LT(key, at.size());
            ASSERT_EQ(at[key], no_hint) << "two cells with one key";
            at[key] = cell;
        }
        for (std::size_t k = 1; k < at.size(); ++k) {
            int distance = 0;
            for (const std::uint32_t d : {side * side, side, 1u}) {
                distance += std::abs(static_cast<int>(at[k - 1] / d % side) -
                                     static_cast<int>(at[k] / d % side));
            }
            ASSERT_EQ(distance, 1) << "after key " << k - 1;
        }
    }
}

// Three steps and one step with the state that two steps lead to are the same curve.
TEST(HilbertCurve, GoesOnInsideACell) {
    Random random(3);
    for (int i = 0; i < 1000; ++i) {
        const std::uint32_t x = random.below(512), y = random.below(512), z = random.below(512);
        unsigned whole = 0, upper = 0;
        const std::uint64_t key = hilbert_curve.key(x, y, z, 3, whole);
        std::uint64_t parts = hilbert_curve.key(x >> 3, y >> 3, z >> 3, 2, upper);
        parts = parts << 9 | hilbert_curve.key(x & 7, y & 7, z & 7, 1, upper);
        EXPECT_EQ(parts, key);
        EXPECT_EQ(upper, whole);
    }
}

TEST(Hilbert, FollowsALatticeInUnitSteps) {
    for (const std::size_t side : {8u, 16u}) {
        const Coordinates xyz = integer_lattice(side);
        const Result result = schedule(xyz, MGDT_ORDER_HILBERT);
        EXPECT_DOUBLE_EQ(path_length(xyz, result.order), static_cast<double>(xyz.size() / 3 - 1));
        EXPECT_EQ(result.levels, 1u);
    }
}

TEST(Hilbert, ResolvesCrowdsHoweverSmall) {
    // A lattice that is one cell of any curve over the whole set, since a second one is far away.
    const Coordinates lattice = integer_lattice(8);
    Coordinates xyz = {1e300, 1e300, 1e300};
    for (const double x : lattice) xyz.push_back(1e-250 * x);
    const Result result = schedule(xyz, MGDT_ORDER_HILBERT);
    EXPECT_GT(result.levels, 1u);
    Order crowd;
    for (const std::uint32_t i : result.order) {
        if (i > 0) crowd.push_back(i - 1);
    }
    EXPECT_DOUBLE_EQ(path_length(lattice, crowd), 511);
}

TEST(Hilbert, KeepsPathsShort) {
    // A path through n random points of the unit cube cannot be much shorter than 0.7 n^(2/3).
    const Coordinates xyz = uniform(10000);
    EXPECT_LT(path_length(xyz, schedule(xyz, MGDT_ORDER_HILBERT).order),
              1.2 * std::pow(10000, 2.0 / 3));
}

TEST(Brio, RoundsGrowByTheRatioAndFollowTheCurve) {
    const Coordinates xyz = uniform(40000);
    OrderParameters parameters;
    for (const double ratio : {1.5, 7.5, 30.0}) {
        parameters.round_ratio = ratio;
        const Result result = schedule(xyz, MGDT_ORDER_BRIO, parameters);
        ASSERT_GT(result.rounds.size(), 1u);
        EXPECT_LE(result.rounds[1], 100u);
        const double before = result.rounds.back();
        EXPECT_NEAR((40000 - before) / before, ratio, 0.1 * ratio);

        Order place(40000);
        const Order curve = schedule(xyz, MGDT_ORDER_HILBERT).order;
        for (std::uint32_t k = 0; k < 40000; ++k) place[curve[k]] = k;
        std::size_t turns = 0;
        for (std::size_t k = 1; k < 40000; ++k) {
            turns += place[result.order[k]] < place[result.order[k - 1]];
        }
        EXPECT_EQ(turns, result.rounds.size() - 1);
    }
}

TEST(Brio, RoundsComeFromTheSeed) {
    OrderParameters parameters;
    const Coordinates xyz = uniform(2000);
    const Result zero = schedule(xyz, MGDT_ORDER_BRIO, parameters);
    parameters.seed = 1;
    EXPECT_NE(schedule(xyz, MGDT_ORDER_BRIO, parameters).order, zero.order);
}

TEST(Brio, SmallSetsHaveOneRound) {
    const Coordinates xyz = uniform(60);
    const Result result = schedule(xyz, MGDT_ORDER_BRIO);
    EXPECT_EQ(result.rounds, Order{0});
    EXPECT_EQ(result.order, schedule(xyz, MGDT_ORDER_HILBERT).order);
}

TEST(Auto, EarlierRoundsTakeOneOfEightAlongTheCurve) {
    const std::size_t n = 8 * 8 * 64 * 8;
    const Coordinates xyz = uniform(n);
    const Result result = schedule(xyz, MGDT_ORDER_AUTO);
    EXPECT_EQ(result.rounds, (Order{0, 64, 512, 4096}));
    Order place(n);
    const Order curve = schedule(xyz, MGDT_ORDER_HILBERT).order;
    for (std::uint32_t k = 0; k < n; ++k) place[curve[k]] = k;
    for (std::uint32_t k = 0; k < 64; ++k) {
        EXPECT_EQ(place[result.order[k]] / 512, k);
    }
    std::vector<int> early(n / 8, 0);
    for (std::size_t k = 0; k < 4096; ++k) ++early[place[result.order[k]] / 8];
    EXPECT_EQ(std::count(early.begin(), early.end(), 1), static_cast<long>(n / 8));
}

TEST(Grid, DivisionsAreThePapers) {
    // alpha = cbrt(N / (n Rx Ry Rz)), NINT(alpha R): 2 x 4 x 3 cells as in Figure 12.
    const Coordinates xyz = {0, 0, 0, 2, 4, 3};
    const PointSet points = point_set(xyz);
    const Grid grid(points, box_of(points), 192, 8);
    EXPECT_EQ(grid.count()[0], 2u);
    EXPECT_EQ(grid.count()[1], 4u);
    EXPECT_EQ(grid.count()[2], 3u);
    EXPECT_EQ(grid.cells(), 24u);
}

TEST(Grid, FlatAndThinBoxesGetAsManyCells) {
    const double most = std::numeric_limits<double>::max();
    const double sizes[][3] = {
        {1, 1, 0},      {0, 1, 0},    {0, 0, 0},       {1e300, 1, 1e-300},
        {1, 1e-9, 1},   {1e-4, 1, 1}, {most, most, 1}, {5e-324, 1e-323, 5e-324},
        {1, 1e-2, 0.1}, {3, 5, 4}};
    for (const auto& size : sizes) {
        Coordinates xyz(6);
        for (int k = 0; k < 3; ++k)
            xyz[static_cast<std::size_t>(k)] = -size[k],
            xyz[3 + static_cast<std::size_t>(k)] = size[k];
        const PointSet points = point_set(xyz);
        for (const double n : {1e1, 1e4, 1e6, 4e9}) {
            const Grid grid(points, box_of(points), static_cast<std::size_t>(n), 8);
            const double wanted = std::min(n / 8, 0x1p29);
            EXPECT_LE(static_cast<double>(grid.cells()), 4 * wanted);
            if (std::max({size[0], size[1], size[2]}) > 0) {
                EXPECT_GE(static_cast<double>(grid.cells()), wanted / 4);
            }
            EXPECT_EQ(grid.path(points, 0), 0u);
            std::uint32_t cell[3];
            grid.locate(points, 1, cell);
            for (int k = 0; k < 3; ++k) {
                EXPECT_EQ(cell[k], size[k] > 0 ? grid.count()[k] - 1 : 0);
            }
        }
    }
}

void expect_serpentine(const Coordinates& xyz, std::size_t n, const double* from) {
    const PointSet points = point_set(xyz);
    const Grid grid(points, box_of(points), n, 1, from);
    ASSERT_EQ(grid.cells(), points.size);
    std::vector<std::size_t> at(points.size, points.size);
    for (std::size_t i = 0; i < points.size; ++i) {
        const std::uint32_t place = grid.path(points, i);
        ASSERT_LT(place, at.size());
        ASSERT_EQ(at[place], points.size) << "two points in a cell";
        at[place] = i;
    }
    for (std::size_t k = 1; k < at.size(); ++k) {
        std::uint32_t a[3], b[3];
        grid.locate(points, at[k - 1], a);
        grid.locate(points, at[k], b);
        int distance = 0;
        for (int d = 0; d < 3; ++d) distance += std::abs(static_cast<int>(a[d] - b[d]));
        ASSERT_EQ(distance, 1) << "after place " << k - 1;
    }
    if (!from) return;
    std::uint32_t first[3];
    grid.locate(points, at[0], first);
    for (int d = 0; d < 3; ++d) {
        EXPECT_EQ(first[d],
                  from[d] > 0.5 * (points.low[d] + points.high[d]) ? grid.count()[d] - 1 : 0);
    }
}

TEST(Grid, PathIsSerpentineFromTheCornerNextToTheLastPoint) {
    for (const std::size_t side : {2u, 3u, 4u, 5u}) {
        const Coordinates xyz = integer_lattice(side);
        expect_serpentine(xyz, xyz.size() / 3, nullptr);
        for (int corner = 0; corner < 8; ++corner) {
            const double from[3] = {corner & 1 ? 99.0 : -99.0, corner & 2 ? 99.0 : -99.0,
                                    corner & 4 ? 99.0 : -99.0};
            expect_serpentine(xyz, xyz.size() / 3, from);
        }
    }
}

TEST(RegularGrid, GoesFromCellToCellNextToIt) {
    const Coordinates xyz = uniform(20000);
    const PointSet points = point_set(xyz);
    OrderParameters parameters;
    parameters.points_per_cell = 27;  // no cell is empty
    const Result result = schedule(points, MGDT_ORDER_REGULAR_GRID, parameters);
    EXPECT_EQ(result.levels, 1u);
    const Grid grid(points, box_of(points), points.size, 27);
    std::set<std::uint32_t> cells;
    for (std::size_t k = 0; k < points.size; ++k) cells.insert(grid.path(points, k));
    ASSERT_EQ(cells.size(), grid.cells());
    for (std::size_t k = 1; k < points.size; ++k) {
        std::uint32_t a[3], b[3];
        grid.locate(points, result.order[k - 1], a);
        grid.locate(points, result.order[k], b);
        int distance = 0;
        for (int d = 0; d < 3; ++d) distance += std::abs(static_cast<int>(a[d] - b[d]));
        ASSERT_LE(distance, 1);
        ASSERT_TRUE(distance == 1 || result.order[k - 1] < result.order[k]);
    }
}

TEST(KdTree, SandwichesThePapersExample) {
    // 20 points, 2 levels: cell 4, pivot 2, cell 5, pivot 1, cell 6, pivot 3, cell 7 with 5, 4, 4
    // and 4 points (Figure 10). In x they are 0..19 shuffled, in y a permutation of the same.
    Coordinates xyz;
    for (int i = 0; i < 20; ++i) {
        xyz.push_back(i * 7 % 20);
        xyz.push_back(i * 7 % 20 * 3 % 20 * 0.9);
        xyz.push_back(0);
    }
    OrderParameters parameters;
    parameters.points_per_cell = 5;
    const Result result = schedule(xyz, MGDT_ORDER_KD_TREE, parameters);
    EXPECT_EQ(result.levels, 2u);
    const auto x = [&](std::size_t k) { return xyz[3 * std::size_t{result.order[k]}]; };
    const auto y = [&](std::size_t k) { return xyz[3 * std::size_t{result.order[k]} + 1]; };
    EXPECT_EQ(x(10), 10);                                          // pivot 1
    for (std::size_t k = 0; k < 10; ++k) EXPECT_LT(x(k), 10);      // regions 4, 5
    for (std::size_t k = 11; k < 20; ++k) EXPECT_GT(x(k), 10);     // regions 6, 7
    for (std::size_t k = 0; k < 5; ++k) EXPECT_LT(y(k), y(5));     // cell 4, pivot 2
    for (std::size_t k = 6; k < 10; ++k) EXPECT_GT(y(k), y(5));    // cell 5
    for (std::size_t k = 11; k < 15; ++k) EXPECT_LT(y(k), y(15));  // cell 6, pivot 3
    for (std::size_t k = 16; k < 20; ++k) EXPECT_GT(y(k), y(15));  // cell 7
    for (const auto& [begin, end] : {std::pair(0, 5), {6, 10}, {11, 15}, {16, 20}}) {
        EXPECT_TRUE(std::is_sorted(result.order.begin() + begin, result.order.begin() + end));
    }
}

TEST(KdTree, CellsHoldAboutTheNumberAskedFor) {
    EXPECT_EQ(kd_levels(20, 5, false), 2u);
    EXPECT_EQ(kd_levels(20, 10, false), 1u);
    EXPECT_EQ(kd_levels(1000, 10, false), 7u);
    EXPECT_EQ(kd_levels(1999, 1000, true), 0u);
    EXPECT_EQ(kd_levels(4000, 1000, true), 2u);
    EXPECT_EQ(kd_levels(5, 10, false), 0u);

    const Coordinates xyz = noisy_line(5000);
    const PointSet points = point_set(xyz);
    Allocator allocator;
    Buffer<KdPoint> sorted = kd_points(points, allocator);
    std::vector<std::size_t> sizes;
    kd_partition(sorted.data(), 0, 5000, box_of(points), 9,
                 [&](std::size_t begin, std::size_t end) { sizes.push_back(end - begin); });
    EXPECT_EQ(sizes.size(), 512u);
    EXPECT_EQ(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}), 5000 - 511u);
    EXPECT_LE(*std::max_element(sizes.begin(), sizes.end()) -
                  *std::min_element(sizes.begin(), sizes.end()),
              1u);
}

TEST(EnhancedKdTree, SandwichesGrids) {
    const Coordinates xyz = uniform(8000);
    const Result enhanced = schedule(xyz, MGDT_ORDER_ENHANCED_KD_TREE);
    OrderParameters parameters;
    parameters.points_per_cell = 1000;
    const Result plain = schedule(xyz, MGDT_ORDER_KD_TREE, parameters);
    EXPECT_EQ(plain.levels, 3u);
    EXPECT_EQ(enhanced.levels, 4u);
    // The pivots are where they are in the plain tree, and so are the sets between them.
    Order pivots;
    std::function<void(std::uint32_t, std::uint32_t, unsigned)> divide =
        [&](std::uint32_t begin, std::uint32_t end, unsigned level) {
            if (level == 0) {
                const auto sorted = [&](const Order& order) {
                    Order part(order.begin() + begin, order.begin() + end);
                    std::sort(part.begin(), part.end());
                    return part;
                };
                EXPECT_EQ(sorted(enhanced.order), sorted(plain.order));
                return;
            }
            const std::uint32_t pivot = begin + (end - begin) / 2;
            pivots.push_back(pivot);
            divide(begin, pivot, level - 1);
            divide(pivot + 1, end, level - 1);
        };
    divide(0, 8000, 3);
    for (const std::uint32_t k : pivots) EXPECT_EQ(enhanced.order[k], plain.order[k]);
    EXPECT_LT(path_length(xyz, enhanced.order), 0.4 * path_length(xyz, plain.order));
}

TEST(EnhancedKdTree, OfOneCellIsARegularGrid) {
    const Coordinates xyz = uniform(1500);
    EXPECT_EQ(schedule(xyz, MGDT_ORDER_ENHANCED_KD_TREE).order,
              schedule(xyz, MGDT_ORDER_REGULAR_GRID).order);
}

TEST(MultiGrid, WithoutCrowdsIsTheRegularGrid) {
    const Coordinates xyz = uniform(5000);
    OrderParameters parameters;
    parameters.separation = false;
    const Result multi = schedule(xyz, MGDT_ORDER_MULTI_GRID, parameters);
    EXPECT_TRUE(multi == schedule(xyz, MGDT_ORDER_REGULAR_GRID, parameters));
    parameters.points_per_cell = 2;
    parameters.threshold = 6;  // now there are crowds
    EXPECT_NE(schedule(xyz, MGDT_ORDER_MULTI_GRID, parameters).order,
              schedule(xyz, MGDT_ORDER_REGULAR_GRID, parameters).order);
}

TEST(MultiGrid, RefinesACrowdedCellInPlace) {
    Coordinates xyz = uniform(3000);
    const Coordinates crowd = uniform(1000);
    for (const double x : crowd) xyz.push_back(0.5 + 1e-6 * x);
    OrderParameters parameters;
    parameters.separation = false;
    const PointSet points = point_set(xyz);
    const Result multi = schedule(points, MGDT_ORDER_MULTI_GRID, parameters);
    const Result single = schedule(points, MGDT_ORDER_REGULAR_GRID, parameters);
    EXPECT_EQ(multi.levels, 3u);  // the crowd is alone in one cell of the second grid
    // The points of each cell of the first grid stand where they stood, in another order where
    // there are more than 200.
    const Grid grid(points, box_of(points), points.size, 8);
    std::size_t refined = 0;
    for (std::size_t begin = 0; begin < points.size;) {
        const std::uint32_t cell = grid.path(points, single.order[begin]);
        std::size_t end = begin;
        while (end < points.size && grid.path(points, single.order[end]) == cell) ++end;
        Order before(single.order.begin() + static_cast<long>(begin),
                     single.order.begin() + static_cast<long>(end));
        Order after(multi.order.begin() + static_cast<long>(begin),
                    multi.order.begin() + static_cast<long>(end));
        if (end - begin > 200) {
            EXPECT_NE(after, before);
            std::sort(after.begin(), after.end());  // the input's order is that of one cell
            ++refined;
        }
        EXPECT_EQ(after, before);
        begin = end;
    }
    EXPECT_GE(refined, 1u);
    // Inside the crowd the order is that of its own regular grid, from some corner on.
    Order inside;
    for (const std::uint32_t i : multi.order) {
        if (i >= 3000) inside.push_back(i - 3000);
    }
    const Order alone = schedule(crowd, MGDT_ORDER_REGULAR_GRID, parameters).order;
    EXPECT_NEAR(path_length(crowd, inside) / path_length(crowd, alone), 1, 0.1);
}

TEST(MultiGrid, StopsWherePointsCannotBeSeparated) {
    OrderParameters parameters;
    parameters.threshold = 1;
    const Coordinates same =
        generate(5000, [](std::size_t, Random&, double* p) { p[0] = p[1] = p[2] = 0.25; });
    EXPECT_LE(schedule(same, MGDT_ORDER_MULTI_GRID, parameters).levels, 1u);
    // One point in each binade: a grid over any of them splits off but a few.
    const Coordinates exponential = generate(2000, [](std::size_t i, Random&, double* p) {
        p[0] = p[1] = p[2] = std::ldexp(1.0, 1000 - static_cast<int>(i));
    });
    parameters.points_per_cell = 1;
    const Result result = schedule(exponential, MGDT_ORDER_MULTI_GRID, parameters);
    expect_sound(result, 2000);
    EXPECT_LE(result.levels, 64u);
}

TEST(MultiGrid, SeparationTakesOnePointFromACellAtATime) {
    const Coordinates xyz = uniform(20000);
    const PointSet points = point_set(xyz);
    const Grid grid(points, box_of(points), points.size, 8);
    const Result result = schedule(points, MGDT_ORDER_MULTI_GRID);
    ASSERT_EQ(result.levels, 1u);
    std::vector<std::uint32_t> taken(grid.cells(), 0), total(grid.cells(), 0);
    for (std::size_t i = 0; i < points.size; ++i) ++total[grid.path(points, i)];

    std::size_t first_pass_rounds = 0;
    bool first_pass = true;
    for (std::size_t r = 0; r < result.rounds.size(); ++r) {
        const std::size_t begin = result.rounds[r];
        const std::size_t end = r + 1 < result.rounds.size() ? result.rounds[r + 1] : points.size;
        // Once a point is second in its cell, every cell has given its first.
        const std::uint32_t rank = taken[grid.path(points, result.order[begin])];
        if (rank > 0) first_pass = false;
        first_pass_rounds += first_pass;
        if (!first_pass) {
            for (std::size_t c = 0; c < total.size(); ++c) {
                ASSERT_EQ(taken[c], std::min(total[c], rank));
            }
        }
        std::uint32_t before = 0;
        for (std::size_t k = begin; k < end; ++k) {
            const std::uint32_t cell = grid.path(points, result.order[k]);
            ASSERT_TRUE(k == begin || cell > before) << "not once along the path";
            before = cell;
            ASSERT_EQ(taken[cell]++, rank);
            if (rank == 0) {
                ASSERT_EQ(result.hints[k], no_hint);
            } else {
                ASSERT_EQ(grid.path(points, result.order[result.hints[k]]), cell);
            }
        }
    }
    EXPECT_GT(first_pass_rounds, 1u);
    EXPECT_LE(result.rounds[1], 100u);
    const std::uint32_t fullest = *std::max_element(total.begin(), total.end());
    EXPECT_EQ(result.rounds.size(), first_pass_rounds + fullest - 1);
}

TEST(MultiGrid, HintsAreTheNearestOfTheCell) {
    // One cell: every point is in it, so up to the ninth the hint is the nearest of all before.
    const Coordinates xyz = uniform(9);
    OrderParameters parameters;
    parameters.points_per_cell = 100;
    const Result result = schedule(xyz, MGDT_ORDER_MULTI_GRID, parameters);
    ASSERT_EQ(result.hints[0], no_hint);
    for (std::size_t k = 1; k < 9; ++k) {
        const auto distance = [&](std::size_t j) {
            const double* a = &xyz[3 * std::size_t{result.order[j]}];
            const double* b = &xyz[3 * std::size_t{result.order[k]}];
            return std::fabs(a[0] - b[0]) + std::fabs(a[1] - b[1]) + std::fabs(a[2] - b[2]);
        };
        for (std::size_t j = 0; j < k; ++j) EXPECT_LE(distance(result.hints[k]), distance(j));
    }
}

}  // namespace
