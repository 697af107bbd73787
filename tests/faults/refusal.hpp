// SPDX-License-Identifier: MIT
// The N-th request refused, and every one from the N-th on, for every N that the call comes to.
#pragma once

#include "flows.hpp"

namespace faults {

inline void expect_out_of_memory(const mgdt_triangulation* t, mgdt_status status) {
    ASSERT_EQ(status, MGDT_ERR_OUT_OF_MEMORY) << property::error_of(t);
    ASSERT_NE(property::error_of(t).find("out of memory"), std::string::npos);
}

// In smaller sets every fourth, in the smallest every eleventh.
inline const std::int64_t step = is_smallest() ? 11 : is_small() ? 4 : 1;

struct Refusals {
    unsigned kinds;
    bool own_allocator;
    bool can_do_without;      // refusing all that is asked for may leave the call its success
    bool is_limited = false;  // with a limit that is never met, which has large blocks mapped
    std::int64_t tried = 0, failed = 0;

    void done_to(const Insertion& flow) {
        SCOPED_TRACE(flow.name);
        Story expected = flow.begin(own_allocator);
        expected.insert(flow.batch);
        const property::Keys geometry = expected.geometry();
        const Points extra = random_points(20, 77);
        expected.insert(extra);
        const property::Keys grown = expected.geometry();
        for (const bool all : {false, true})
            for (std::int64_t nth = 1; !testing::Test::HasFatalFailure(); nth += step) {
                SCOPED_TRACE((all ? "all from " : "only ") + std::to_string(nth));
                if (!once(flow, nth, all, geometry, extra, grown)) break;
            }
    }

    // Calls that insert nothing, on handles of n points: for every N on a new one, since a call may
    // find what an earlier one has made; or, where they are large, for the first few N and fewer
    // and fewer of those behind, on one that only forgets the numbers of its tetrahedra.
    void done_to(const Call& call, std::int64_t n, std::int32_t threads, bool canonical,
                 bool each_new) {
        SCOPED_TRACE(call.name);
        const Points xyz = random_points(static_cast<std::size_t>(n), 5);
        const auto begin = [&] {
            Story story(own_allocator, threads, 0, MGDT_ORDER_AUTO);
            if (is_limited) {
                EXPECT_EQ(mgdt_set_memory_limit(story.handle(), INT64_MAX / 2), MGDT_OK);
            }
            story.insert(xyz);
            return story;
        };
        Story story = begin();
        EXPECT_EQ(mgdt_set_canonical_output(story.handle(), canonical), MGDT_OK);
        Output output(story.handle()), expected(story.handle());
        ASSERT_EQ(call.make(story.handle(), expected), MGDT_OK);
        for (const bool all : {false, true}) {
            bool reached = true;
            for (std::int64_t nth = 1; reached; nth += each_new ? step : 3 * nth) {
                SCOPED_TRACE((all ? "all from " : "only ") + std::to_string(nth));
                if (each_new) story = begin();
                mgdt_triangulation* const t = story.handle();
                ASSERT_EQ(mgdt_set_canonical_output(t, canonical), MGDT_OK);
                fault_arm(kinds, nth, all ? INT64_MAX : nth + 1);
                const mgdt_status status = call.make(t, output);
                reached = fault_disarm() >= nth;
                if (status != MGDT_OK) expect_out_of_memory(t, status);
                tried += reached;
                failed += status != MGDT_OK;
                ASSERT_EQ(mgdt_point_count(t), n);
                ASSERT_EQ(mgdt_vertex_count(t), n);
                if (!each_new && status == MGDT_OK) continue;
                // The same call then gives what it gives where it was never refused.
                ASSERT_EQ(call.make(t, output), MGDT_OK);
                ASSERT_TRUE(output == expected);
            }
        }
        story.expect_valid();
    }

  private:
    // Whether the call came to the nth request.
    bool once(const Insertion& flow, std::int64_t nth, bool all, const property::Keys& geometry,
              const Points& extra, const property::Keys& grown) {
        bool reached = false;
        const std::int64_t balance = fault_balance();
        refuse(flow, nth, all, geometry, extra, grown, reached);
        EXPECT_EQ(fault_balance(), balance);
        return reached;
    }

    void refuse(const Insertion& flow, std::int64_t nth, bool all, const property::Keys& geometry,
                const Points& extra, const property::Keys& grown, bool& reached) {
        Story story = flow.begin(own_allocator);
        mgdt_triangulation* const t = story.handle();
        const Numbers before = story.exported();
        ASSERT_EQ(mgdt_set_canonical_output(t, 0), MGDT_OK);
        fault_arm(kinds, nth, all ? INT64_MAX : nth + 1);
        const mgdt_status status = mgdt_insert_points(t, count(flow.batch), flow.batch.data());
        reached = fault_disarm() >= nth;
        const bool counted = story.note(flow.batch);
        if (status != MGDT_OK) expect_out_of_memory(t, status);
        // The last requests of a call may be such that it can do without.
        if (all && nth == 1 && !can_do_without) {
            ASSERT_NE(status, MGDT_OK);
        }
        story.expect_valid();
        if (!counted) {
            ASSERT_EQ(story.exported(), before);
        } else if (!flow.holds) {
            // What was in is in.
            const Numbers map = property::point_map(t);
            for (std::size_t i = 0; i < flow.before.size() / 3; ++i) ASSERT_GE(map[i], 0) << i;
        }
        if (status != MGDT_OK) {
            if (flow.holds) story.insert(flow.before);
            story.insert(flow.batch);
        }
        ASSERT_EQ(story.geometry(), geometry);
        story.insert(extra);
        story.expect_valid();
        ASSERT_EQ(story.geometry(), grown);
        tried += reached;
        failed += status != MGDT_OK;
    }
};

}  // namespace faults
