// SPDX-License-Identifier: MIT
// What a team makes is what one thread makes, whatever its size: lists by key, and schedules.
#include <stdexcept>

#include "../support/small.h"
#include "order_sets.hpp"
#include "parallel/disjoint_sets.hpp"
#include "parallel/team_lists.hpp"

namespace order_test {
namespace {

// The lists of so many keys, each item giving none to three values.
struct Lists {
    std::vector<std::int64_t> ends;
    std::vector<std::uint32_t> values;
    bool operator==(const Lists& other) const {
        return ends == other.ends && values == other.values;
    }
};

Lists lists(unsigned members, std::size_t items, std::size_t share, std::size_t keys) {
    Allocator allocator;
    Team team(members);
    Lists out;
    out.ends.resize(keys + 1);
    const auto each = [&](std::size_t begin, std::size_t end, auto f) {
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t k = 0; k < Random::at(1, i) % 4; ++k)
                f(Random::at(2, 4 * i + k) % keys, static_cast<std::uint32_t>(4 * i + k));
    };
    make_lists(
        team, allocator, items, share, keys, out.ends.data(), each,
        [&](std::size_t size) { out.values.resize(size); },
        [&](std::size_t place, std::uint32_t value) { out.values[place] = value; });
    return out;
}

TEST(Lists, AreThoseOfOneThread) {
    for (const std::size_t items : {0u, 1u, 7u, 100u, 1000u, 12345u}) {
        for (const std::size_t keys : {1u, 2u, 5u, 1000u}) {
            const Lists expected = lists(1, items, 1, keys);
            EXPECT_EQ(expected.ends.front(), 0);
            EXPECT_EQ(static_cast<std::size_t>(expected.ends.back()), expected.values.size());
            for (std::size_t k = 0; k < keys; ++k)
                for (std::int64_t i = expected.ends[k]; i < expected.ends[k + 1]; ++i) {
                    const std::uint32_t value = expected.values[static_cast<std::size_t>(i)];
                    EXPECT_EQ(Random::at(2, value) % keys, k);
                    if (i > expected.ends[k]) {
                        EXPECT_LT(expected.values[static_cast<std::size_t>(i - 1)], value);
                    }
                }
            for (const unsigned members : {2u, 3u, 16u, 20u})
                EXPECT_TRUE(lists(members, items, 1, keys) == expected)
                    << members << ' ' << items << ' ' << keys;
        }
    }
}

TEST(Team, ThrowsWhatTheFirstMemberThrew) {
    Team team(4);
    for (int round = 0; round < 10; ++round) {
        try {
            team.run(4, [](unsigned member) {
                if (member > 0) throw std::runtime_error(std::to_string(member));
            });
            ADD_FAILURE() << "nothing was thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), team.size() > 1 ? "1" : "");
        }
    }
}

// Long ways up, which all members shorten at once.
TEST(DisjointSets, AreJoinedByManyAtOnce) {
    const std::uint32_t n = is_small() ? 2000 : 30000, sets = 7;
    for (unsigned round = 0; round < (is_small() ? 5 : 100); ++round) {
        Allocator allocator;
        Team team(4);
        DisjointSets joined(allocator, n);
        team.run(4, [&](unsigned member) {
            for (std::uint32_t k = 0; k < n; ++k) {
                // Each member in an order of its own, all of them the same pairs.
                const std::uint32_t i = member % 2 ? n - 1 - k : (k * 7919u + member) % n;
                if (i >= sets) joined.join(i, i - sets);
            }
        });
        for (std::uint32_t i = 0; i < n; ++i) ASSERT_EQ(joined.least(i), i % sets) << round;
    }
}

// Sizes on both sides of those from which one more member gets a part, of points that lie evenly,
// that crowd, and that are few but come often.
TEST(Schedules, AreThoseOfOneThread) {
    constexpr std::size_t share = 65536;  // half of it for kd-trees
    std::vector<std::size_t> sizes = {2 * share};
    if (!is_small()) sizes = {share - 1, share, 2 * share - 1, 3 * share + 7};
    for (const std::size_t n : sizes) {
        Coordinates often = uniform(n);
        for (double& x : often) x = std::floor(8 * x);
        const std::map<std::string, Coordinates> sets = {
            {"uniform", uniform(n)}, {"line", noisy_line(n)}, {"often", often}};
        for (const auto& [set, xyz] : sets) {
            if (is_small() && set != "line") continue;
            for (const std::int32_t scheme :
                 {MGDT_ORDER_AUTO, MGDT_ORDER_BRIO, MGDT_ORDER_HILBERT, MGDT_ORDER_REGULAR_GRID,
                  MGDT_ORDER_KD_TREE, MGDT_ORDER_ENHANCED_KD_TREE}) {
                const Result expected = schedule(point_set(xyz), scheme);
                EXPECT_TRUE(schedule(point_set(xyz), scheme, {}, nullptr, 3) == expected)
                    << n << ' ' << set << ' ' << find_order_scheme(scheme)->name;
            }
        }
    }
}

// Fewer cells than regions that the members would take.
TEST(Schedules, OfFewCellsAreThoseOfOneThread) {
    const Coordinates xyz = noisy_line(100000);
    for (const double cells : {1.0, 2.0, 4.0, 8.0, 16.0, 32.0}) {
        OrderParameters parameters;
        parameters.points_per_cell = 100000 / cells;
        for (const std::int32_t scheme : {MGDT_ORDER_KD_TREE, MGDT_ORDER_ENHANCED_KD_TREE}) {
            const Result expected = schedule(point_set(xyz), scheme, parameters);
            EXPECT_TRUE(schedule(point_set(xyz), scheme, parameters, nullptr, 3) == expected)
                << cells << ' ' << find_order_scheme(scheme)->name;
        }
    }
}

}  // namespace
}  // namespace order_test
