// SPDX-License-Identifier: MIT
// The system refuses: malloc, mmap and mremap, page advice, threads. With interpose.c linked.
#include <thread>

#include "refusal.hpp"

namespace faults {
namespace {

// What a handle with an allocator of its own still asks of the system: with one thread nothing;
// with more, what a team shares, and what starting each of them takes.
TEST(System, NothingPassesByTheAllocator) {
    for (const Insertion& flow : insertions()) {
        SCOPED_TRACE(flow.name);
        Story story = flow.begin(true);
        fault_arm(0, 0, 0);
        const mgdt_status status =
            mgdt_insert_points(story.handle(), count(flow.batch), flow.batch.data());
        fault_disarm();
        EXPECT_EQ(status, MGDT_OK);
        EXPECT_EQ(fault_requests(fault_map) + fault_requests(fault_advice), 0);
        EXPECT_LE(fault_requests(fault_malloc), 4 * (flow.threads - 1));
        EXPECT_EQ(fault_requests(fault_thread), flow.threads - 1);
    }
    for (const std::int32_t threads : {1, 2}) {
        const std::int64_t n = threads == 1 || is_small() ? 600 : 21000;
        Story story(true, threads, 0, MGDT_ORDER_AUTO);
        story.insert(random_points(static_cast<std::size_t>(n), 5));
        Output output(story.handle());
        for (const Call& call : calls) {
            SCOPED_TRACE(call.name);
            fault_arm(0, 0, 0);
            const mgdt_status status = call.make(story.handle(), output);
            fault_disarm();
            EXPECT_EQ(status, MGDT_OK);
            EXPECT_EQ(fault_requests(fault_map) + fault_requests(fault_advice), 0);
            EXPECT_LE(fault_requests(fault_malloc), 4 * (threads - 1));
            EXPECT_LE(fault_requests(fault_thread), threads - 1);
        }
    }
}

// With the default allocator. Where threads cannot be had a call does without.
TEST(System, RefusesMemoryToInsertions) {
    std::int64_t failed = 0;
    for (const Insertion& flow : insertions()) {
        Refusals refusals{fault_malloc, false, flow.threads > 1};
        refusals.done_to(flow);
        EXPECT_GT(refusals.tried, flow.one_by_one ? 1 : 2) << flow.name;
        failed += refusals.failed;
    }
    EXPECT_GT(failed, 50);
}

TEST(System, RefusesMemoryToCalls) {
    for (const Call& call : calls) {
        Refusals refusals{fault_malloc, false, false};
        refusals.done_to(call, 600, 1, true, true);
        if (call.asks_for_memory) {
            EXPECT_GT(refusals.failed, 0) << call.name;
        }
    }
}

// What bypasses the handle's allocator when threads start: refused, a call does with fewer.
TEST(System, RefusesWhatThreadsTake) {
    for (const Insertion& flow : insertions()) {
        if (flow.threads == 1) continue;
        Refusals refusals{fault_malloc, true, true};
        refusals.done_to(flow);
        EXPECT_GT(refusals.tried, 2) << flow.name;
        EXPECT_EQ(refusals.failed, 0) << flow.name;
    }
}

TEST(System, RefusesThreads) {
    int flows = 0;
    for (const Insertion& flow : insertions()) {
        if (flow.threads == 1) continue;
        ++flows;
        Refusals refusals{fault_thread, true, true};
        refusals.done_to(flow);
        EXPECT_GE(refusals.tried, 2 * (flow.threads - 1)) << flow.name;
        EXPECT_EQ(refusals.failed, 0) << flow.name;
        for (std::int32_t nth = 1; nth < flow.threads; ++nth) {
            Story story = flow.begin(true);
            fault_arm(fault_thread, nth, INT64_MAX);
            EXPECT_EQ(mgdt_insert_points(story.handle(), count(flow.batch), flow.batch.data()),
                      MGDT_OK);
            fault_disarm();
            double threads = 0;
            EXPECT_EQ(mgdt_get_stat(story.handle(), MGDT_STAT_THREADS, &threads), MGDT_OK);
            EXPECT_EQ(threads, nth);
        }
    }
    EXPECT_GT(flows, 1);
    const std::int64_t n = is_small() ? 700 : 21000;
    for (const Call& call : calls) {
        Refusals refusals{fault_thread, true, true};
        refusals.done_to(call, n, 2, true, false);
        EXPECT_EQ(refusals.failed, 0) << call.name;
    }
}

// Blocks that grow to 1 MiB are mapped pages; others of that size are the C library's.
Insertion large(std::int32_t threads) {
    Insertion flow;
    flow.name = "large, " + std::to_string(threads) + " threads";
    flow.before = random_points(4000, 5);
    flow.batch = random_points(4000, 6);
    flow.threads = threads;
    flow.share = 1000;
    return flow;
}

TEST(System, RefusesPages) {
    for (const std::int32_t threads : {1, 2}) {
        Refusals refusals{fault_map, false, false};
        refusals.done_to(large(threads));
        EXPECT_GE(refusals.failed, 1);
    }
    constexpr std::int64_t n = 12000;
    for (const unsigned what : {fault_map, fault_malloc}) {
        std::int64_t tried = 0;
        for (const Call& call : calls) {
            Refusals refusals{what, false, true, what == fault_map};
            refusals.done_to(call, n, 1, true, false);
            tried += refusals.tried;
        }
        EXPECT_GT(tried, 0);
    }
}

TEST(System, RefusesAdviceOnPages) {
    Refusals refusals{fault_advice, false, true};
    refusals.done_to(large(1));
    EXPECT_GE(refusals.tried, 2);
    EXPECT_EQ(refusals.failed, 0);
}

TEST(System, RefusesTheHandleItself) {
    mgdt_triangulation* t = reinterpret_cast<mgdt_triangulation*>(&t);
    const std::int64_t balance = fault_balance();
    fault_arm(fault_malloc, 1, INT64_MAX);
    const mgdt_status status = mgdt_create(&t);
    fault_disarm();
    EXPECT_EQ(status, MGDT_ERR_OUT_OF_MEMORY);
    EXPECT_EQ(t, nullptr);
    EXPECT_EQ(fault_balance(), balance);
}

// The shim stands in the way indeed.
TEST(System, IsInterposed) {
    fault_arm(fault_malloc | fault_thread, 1, INT64_MAX);
    void* volatile p = std::malloc(10);
    bool refused = false;
    try {
        std::thread([] {}).join();
    } catch (const std::exception&) {
        refused = true;
    }
    fault_disarm();
    EXPECT_EQ(p, nullptr);
    EXPECT_TRUE(refused);
}

}  // namespace
}  // namespace faults
