// SPDX-License-Identifier: MIT
// What threads of a concurrent insertion do, decided without any thread.
#include "core/concurrent_policy.hpp"

#include <gtest/gtest.h>

namespace mgdt {
namespace {

using Advice = Contention::Advice;

TEST(ConcurrentPolicy, RoundsHaveAsManyThreadsAsPay) {
    const TestHooks hooks;  // 8,192 points per thread
    const ConcurrentPolicy policy(hooks, 8, 100000);
    const std::size_t tetrahedra = 700000, vertices = 100000;
    EXPECT_EQ(policy.threads_for_round(100000, tetrahedra, vertices), 8u);
    EXPECT_EQ(policy.threads_for_round(4 * 8192, tetrahedra, vertices), 4u);
    EXPECT_EQ(policy.threads_for_round(8192 + 8191, tetrahedra, vertices), 1u);
    // Others wait for an early round.
    EXPECT_EQ(policy.threads_for_round(2 * 2048, tetrahedra, vertices), 2u);
    EXPECT_EQ(policy.threads_for_round(2 * 2048 - 1, tetrahedra, vertices), 1u);
    // Long tetrahedra, and few of them.
    EXPECT_EQ(policy.threads_for_round(100000, 17 * vertices, vertices), 1u);
    EXPECT_EQ(policy.threads_for_round(100000, 3 * 1024, vertices), 3u);
    EXPECT_EQ(policy.threads_for_round(100000, 0, vertices), 1u);
}

TEST(ConcurrentPolicy, DeferredPointsHaveFewerThreadsIfTheyAreMany) {
    const TestHooks hooks;
    const ConcurrentPolicy policy(hooks, 16, 1000000);
    EXPECT_EQ(policy.threads_for_few(1023), 1u);
    EXPECT_EQ(policy.threads_for_few(5 * 1024), 5u);
    EXPECT_EQ(policy.threads_for_deferred(5 * 1024, 1000000), 5u);
    EXPECT_EQ(policy.threads_for_deferred(5 * 1024, 100000), 1u);
    EXPECT_EQ(policy.threads_for_deferred(3 * 8192, 100000), 3u);
}

TEST(ConcurrentPolicy, SmallSharesNeedNoDivisionByZero) {
    TestHooks hooks;
    for (const std::size_t share : {0u, 1u, 3u}) {
        hooks.min_points_per_thread = share;
        const ConcurrentPolicy policy(hooks, 4, 100);
        EXPECT_EQ(policy.threads_for_few(100), 4u);
        EXPECT_EQ(policy.threads_for_round(100, 700, 100), 4u);
    }
}

TEST(ConcurrentPolicy, ZonesAreUsedWhereFewPointsMeet) {
    TestHooks hooks;
    ConcurrentPolicy policy(hooks, 4, 100000);
    EXPECT_TRUE(policy.may_use_zones());
    EXPECT_TRUE(policy.is_border_short(1000, 8000));
    EXPECT_FALSE(policy.is_border_short(1001, 8000));
    policy.end_round(201, 10000);
    EXPECT_FALSE(policy.may_use_zones());
    policy.end_round(200, 10000);
    EXPECT_TRUE(policy.may_use_zones());
    hooks.zones = ZoneUse::never;
    EXPECT_FALSE(policy.may_use_zones());
    hooks.zones = ZoneUse::always;
    policy.end_round(9999, 10000);
    EXPECT_TRUE(policy.may_use_zones());
    EXPECT_TRUE(policy.is_border_short(8000, 8000));
}

TEST(ConcurrentPolicy, StopsForHubsAreLimitedInARound) {
    const TestHooks hooks;
    ConcurrentPolicy policy(hooks, 4, 100000);
    policy.begin_round();
    for (int k = 0; k < 16; ++k) {
        EXPECT_TRUE(policy.may_stop_for_hubs());
        policy.count_stop_for_hubs();
    }
    EXPECT_FALSE(policy.may_stop_for_hubs());
    policy.begin_round();
    EXPECT_TRUE(policy.may_stop_for_hubs());
}

TEST(ConcurrentPolicy, OneThreadGoesOnAloneIfItIsTwiceAsFastTwice) {
    const TestHooks hooks;
    ConcurrentPolicy policy(hooks, 4, 100000);
    policy.begin_list();
    const std::size_t attempts = policy.attempts_before_doubt();
    EXPECT_EQ(attempts, hooks.attempts_before_doubt);
    // 1,000 points took threads 1 second.
    EXPECT_FALSE(policy.compare(0.4, 1000, 1, 1000));
    EXPECT_EQ(policy.attempts_before_doubt(), attempts);
    EXPECT_TRUE(policy.compare(0.4, 1000, 1, 1000));
    EXPECT_FALSE(policy.compare(0.6, 1000, 1, 1000));
    EXPECT_EQ(policy.attempts_before_doubt(), 2 * attempts);  // it was in doubt too soon
    EXPECT_FALSE(policy.compare(0.1, 1000, 1, 1000));
    policy.begin_list();
    EXPECT_EQ(policy.attempts_before_doubt(), attempts);
    EXPECT_FALSE(policy.compare(0.1, 1000, 1, 1000));
    EXPECT_TRUE(policy.compare(0.1, 1000, 1, 1000));
}

TEST(Contention, FewFailuresAreNothing) {
    Contention contention;
    contention.begin(100000, 2, 1 << 20);
    for (int k = 0; k < 100; ++k) {
        contention.count(64, 16);
        EXPECT_EQ(contention.judge(), Advice::go_on);
    }
}

TEST(Contention, AThreadWaitsTwiceAsLongEachTimeAndLeaves) {
    Contention contention;
    contention.begin(100000, 2, 1 << 20);  // a judgement after 781 attempts
    contention.count(780, 780);
    EXPECT_EQ(contention.judge(), Advice::go_on);
    contention.count(1, 1);
    std::chrono::microseconds wait{100};
    for (int k = 0; k < 4; ++k, wait *= 2) {
        EXPECT_EQ(contention.judge(), Advice::wait) << k;
        EXPECT_EQ(contention.wait(), wait);
        EXPECT_EQ(contention.judge(), Advice::go_on) << "judged attempts count once";
        contention.count(781, 196);
    }
    EXPECT_EQ(contention.judge(), Advice::leave);
    // The last thread stays and asks again.
    contention.count(781, 781);
    EXPECT_EQ(contention.judge(), Advice::leave);
    // Success ends the row.
    contention.count(781, 195);
    EXPECT_EQ(contention.judge(), Advice::go_on);
    contention.count(781, 781);
    EXPECT_EQ(contention.judge(), Advice::wait);
    EXPECT_EQ(contention.wait(), std::chrono::microseconds(100));
}

TEST(Contention, DoubtsComeFirst) {
    Contention contention;
    contention.begin(1000, 2, 2048);
    contention.count(2047, 2047);
    EXPECT_EQ(contention.judge(), Advice::wait);
    contention.count(1, 1);
    EXPECT_EQ(contention.judge(), Advice::doubt);
    EXPECT_EQ(contention.judge(), Advice::go_on);
}

TEST(Contention, TetrahedraVisitedInVainCount) {
    Contention contention;
    contention.begin(1000000, 1, 2048);  // a judgement of its own after 15,625 attempts
    contention.count_given_up(64 * 2048);
    EXPECT_FALSE(contention.has_given_up_too_much());
    contention.count_given_up(1);
    EXPECT_TRUE(contention.has_given_up_too_much());
    // As many as 512 failures; a quarter of 2,048 attempts may fail.
    contention.count(2048, 0);
    EXPECT_EQ(contention.judge(), Advice::go_on);
    EXPECT_FALSE(contention.has_given_up_too_much());
    contention.count_given_up(256 * 513);
    contention.count(2048, 0);
    EXPECT_EQ(contention.judge(), Advice::doubt);
}

}  // namespace
}  // namespace mgdt
