// SPDX-License-Identifier: MIT
// Schemes without cells: input, random, lexicographic, curves and rounds.
#include "../support/small.h"
#include "order/round_assignment.hpp"
#include "order/team_equal_runs.hpp"
#include "order/team_radix.hpp"
#include "order_sets.hpp"

namespace {

using namespace order_test;

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

// What one thread sorts by way of buckets too.
constexpr std::size_t many = std::size_t{1} << 19;

TEST(RadixSort, SortsAsAStableSortDoes) {
    Random random(5);
    std::vector<std::size_t> sizes = {0, 1, 2, 24, 25, 100, 5000};
    if (!is_small()) sizes.push_back(many + 1);
    for (const std::size_t n : sizes) {
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

// Keys above the index of a word, spread evenly, mostly in one small range, and all the same: by
// buckets, of which some are large, and without. Words of equal keys keep their order.
TEST(RadixSort, SortsManyWordsAsAStableSortDoes) {
    constexpr unsigned index_bits = 20;
    Random random(6);
    for (const std::size_t n : {std::size_t{70000}, many + 50000}) {
        if (is_small() && n > 70000) break;
        for (const double crowded : {0.0, 0.5, 0.9, 1.0}) {
            for (const unsigned kept : {3u, 12u, 44u}) {
                std::vector<std::uint64_t> words(n), scratch(n);
                const auto limit = static_cast<std::uint64_t>(crowded * 0x1p32);
                for (std::size_t i = 0; i < n; ++i) {
                    const std::uint64_t key =
                        (random.next() >> 32) < limit ? 77 + random.below(2) : random.next() >> 20;
                    words[i] = (key & ((std::uint64_t{1} << kept) - 1)) << index_bits | i;
                }
                std::vector<std::uint64_t> expected = words;
                std::sort(expected.begin(), expected.end());
                for (const unsigned members : {1u, 2u, 5u}) {
                    std::vector<std::uint64_t> a = words;
                    Allocator allocator;
                    Team team(members);
                    radix_sort(team, allocator, a.data(), scratch.data(), n, index_bits, 64);
                    ASSERT_TRUE(a == expected)
                        << n << ' ' << crowded << ' ' << kept << ' ' << members;
                }
            }
        }
    }
}

// Every run once, from the least length on, whatever the pieces that members take.
TEST(Runs, AreDealtWhole) {
    Random random(7);
    for (const unsigned longest : {1u, 10u, 5000u, 200000u}) {
        std::vector<std::uint32_t> items, begins;
        while (items.size() < 300000) {
            begins.push_back(static_cast<std::uint32_t>(items.size()));
            items.resize(items.size() + 1 + random.below(longest), begins.back());
        }
        begins.push_back(static_cast<std::uint32_t>(items.size()));
        for (const unsigned members : {1u, 2u, 7u}) {
            for (const std::size_t least : {1u, 6u}) {
                std::vector<std::uint32_t> changed = items, ends(items.size(), 0);
                Allocator allocator;
                Team team(members);
                Buffer<mgdt::Run> large(allocator);
                const auto each = [&](std::size_t begin, std::size_t end) {
                    ends[begin] += static_cast<std::uint32_t>(end);
                    for (std::size_t k = begin; k < end; ++k)
                        changed[k] = static_cast<std::uint32_t>(k);
                };
                for_each_run(
                    team, allocator, 0, items.size(), least,
                    [&](std::size_t i, std::size_t j) { return changed[i] == changed[j]; },
                    [&] { return each; }, large);
                EXPECT_TRUE(large.empty() || (members > 1 && longest == 200000)) << members;
                for (const mgdt::Run& run : large) each(run.begin, run.end);
                std::vector<std::uint32_t> expected(items.size(), 0);
                for (std::size_t r = 1; r < begins.size(); ++r)
                    if (begins[r] - begins[r - 1] >= least) expected[begins[r - 1]] = begins[r];
                EXPECT_TRUE(ends == expected) << longest << ' ' << members << ' ' << least;
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

TEST(Auto, EarlierRoundsTakeOneOfTwelveAlongTheCurveOfFewOneOfFour) {
    const std::size_t n = 12 * 12 * 4 * 4 * 32;
    const Coordinates xyz = uniform(n);
    const Result result = schedule(xyz, MGDT_ORDER_AUTO);
    EXPECT_EQ(result.rounds, (Order{0, 32, 128, 512, 6144}));
    Order place(n);
    const Order curve = schedule(xyz, MGDT_ORDER_HILBERT).order;
    for (std::uint32_t k = 0; k < n; ++k) place[curve[k]] = k;
    for (std::size_t round = 1; round < result.rounds.size(); ++round) {
        // One of each block of what is left along the curve, the first rounds in its order.
        const std::size_t end = result.rounds[round], of = n / end;
        std::vector<int> early(end, 0);
        for (std::size_t k = 0; k < end; ++k) ++early[place[result.order[k]] / of];
        EXPECT_EQ(std::count(early.begin(), early.end(), 1), static_cast<long>(end)) << end;
    }
    for (std::uint32_t k = 0; k < 32; ++k) EXPECT_EQ(place[result.order[k]] / (n / 32), k);
}

class DealAlongACurve : public ::testing::Test {
  protected:
    struct Sizes {
        std::size_t n, block, margin, middle;
    };
    static constexpr Sizes many = {20736, 12, 2, 8}, few = {2048, 4, 1, 2};

    // Keys a unit apart but for one point of every block, which is `alone` from the next.
    CurveOrder curve(const Sizes& sizes, std::uint64_t alone) {
        const std::size_t n = sizes.n;
        CurveOrder result{Buffer<std::uint64_t>(allocator_, n), bit_width(n - 1), 1};
        std::uint64_t key = 0;
        for (std::size_t k = 0; k < n; ++k) {
            key += is_alone(sizes, k) || (k > 0 && is_alone(sizes, k - 1)) ? alone : 1;
            result.words[k] = key << result.index_bits | k;
        }
        return result;
    }
    static bool is_alone(const Sizes& sizes, std::size_t k) {
        return k % sizes.block == sizes.margin + k / sizes.block * 5 % sizes.middle;
    }
    RoundAssignment rounds(const Sizes& sizes, std::uint64_t seed, const CurveOrder* curve) {
        return RoundAssignment(team_, allocator_, sizes.n, seed, curve);
    }

  private:
    Allocator allocator_;
    Team team_{2};
};

TEST_F(DealAlongACurve, TakesFirstWhoStandsAlone) {
    for (const Sizes& sizes : {many, few}) {
        const CurveOrder some_alone = curve(sizes, 64);
        for (std::uint64_t seed = 0; seed < 5; ++seed) {
            const RoundAssignment dealt = rounds(sizes, seed, &some_alone);
            const unsigned last = dealt.rounds() - 1;
            ASSERT_GE(last, 2U);
            for (std::size_t k = 0; k < sizes.n; ++k)
                ASSERT_EQ(dealt.round(k) < last, is_alone(sizes, k)) << sizes.n << ' ' << k;
        }
    }
}

TEST_F(DealAlongACurve, DrawsAmongThoseWhoStandAlike) {
    for (const Sizes& sizes : {many, few}) {
        const CurveOrder all_alike = curve(sizes, 2);  // less than a level apart
        const CurveOrder* const curves[] = {&all_alike, nullptr};
        for (const CurveOrder* along : curves) {
            const RoundAssignment dealt = rounds(sizes, 1, along);
            std::vector<std::size_t> taken(sizes.block, 0);
            for (std::size_t k = 0; k < sizes.n; ++k)
                taken[k % sizes.block] += dealt.round(k) < dealt.rounds() - 1 ? 1 : 0;
            // 1,728 draws among 8 places, 512 among 2.
            const std::size_t fair = sizes.n / sizes.block / sizes.middle;
            for (std::size_t k = 0; k < sizes.block; ++k) {
                const bool is_middle = k >= sizes.margin && k < sizes.margin + sizes.middle;
                EXPECT_GE(taken[k], is_middle ? fair * 3 / 4 : 0) << k;
                EXPECT_LE(taken[k], is_middle ? fair * 5 / 4 : 0) << k;
            }
        }
    }
}

}  // namespace
