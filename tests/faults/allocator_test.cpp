// SPDX-License-Identifier: MIT
// The handle's allocator refuses: every request of every call.
#include <cmath>

#include "refusal.hpp"

namespace faults {
namespace {

class EveryInsertion : public testing::TestWithParam<Insertion> {};

TEST_P(EveryInsertion, RunsOutOfMemory) {
    Refusals refusals{fault_handle, true, false};
    refusals.done_to(GetParam());
    EXPECT_GT(refusals.tried, 1);
    EXPECT_GT(refusals.failed, 0);
    EXPECT_EQ(handle_errors(), 0);
}

std::string name_of(const std::string& text) {
    std::string name;
    for (const char c : text) name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
    return name;
}

INSTANTIATE_TEST_SUITE_P(Allocator, EveryInsertion, testing::ValuesIn(insertions()),
                         [](const auto& info) { return name_of(info.param.name); });

class EveryCall : public testing::TestWithParam<Call> {};

// 600 points have a location tree.
TEST_P(EveryCall, RunsOutOfMemory) {
    const std::int64_t balance = fault_balance();
    Refusals refusals{fault_handle, true, false};
    for (const bool canonical : {false, true})
        refusals.done_to(GetParam(), 600, 1, canonical, true);
    if (GetParam().asks_for_memory) {
        EXPECT_GT(refusals.failed, 0);
    }
    EXPECT_EQ(handle_errors(), 0);
    EXPECT_EQ(fault_balance(), balance);
}

// A diagram in a box takes too many requests to refuse each of them.
TEST(Allocator, RefusesADiagramInABox) {
    const std::int64_t balance = fault_balance();
    const double box[24] = {1, 0,  0, 2, -1, 0, 0, 1, 0, 1, 0,  2,
                            0, -1, 0, 1, 0,  0, 1, 2, 0, 0, -1, 1};
    {
        Story story(true, 1, 0, MGDT_ORDER_AUTO);
        story.insert(random_points(60, 5));
        mgdt_voronoi* v = nullptr;
        std::int64_t nth = 1, failed = 0;
        for (;; nth += 1 + nth / 4) {
            fault_arm(fault_handle, nth, INT64_MAX);
            const mgdt_status status = mgdt_voronoi_create(story.handle(), 6, box, &v);
            fault_disarm();
            if (status == MGDT_OK) break;
            expect_out_of_memory(story.handle(), status);
            EXPECT_EQ(v, nullptr);
            ++failed;
        }
        EXPECT_GT(failed, 10);
        mgdt_voronoi_destroy(v);
    }
    EXPECT_EQ(fault_balance(), balance);
}

// Leaving out faces changes nothing if memory is refused.
TEST(Allocator, RefusesToLeaveFacesOut) {
    const std::int64_t balance = fault_balance();
    {
        Story story(true, 1, 0, MGDT_ORDER_AUTO);
        story.insert(random_points(100, 5));
        mgdt_voronoi* v = nullptr;
        ASSERT_EQ(mgdt_voronoi_create(story.handle(), 0, nullptr, &v), MGDT_OK);
        std::int64_t before = 0, after = 0;
        EXPECT_EQ(mgdt_voronoi_get_size(v, MGDT_VORONOI_ARRAY_FACE_CORNERS, &before), MGDT_OK);
        for (std::int64_t nth = 1; nth <= 2; ++nth) {
            fault_arm(fault_handle, nth, INT64_MAX);
            EXPECT_EQ(mgdt_voronoi_drop_small_faces(v, 0.01, 0), MGDT_ERR_OUT_OF_MEMORY);
            fault_disarm();
            EXPECT_EQ(mgdt_voronoi_get_size(v, MGDT_VORONOI_ARRAY_FACE_CORNERS, &after), MGDT_OK);
            EXPECT_EQ(before, after);
        }
        EXPECT_EQ(mgdt_voronoi_drop_small_faces(v, 0.01, 0), MGDT_OK);
        EXPECT_EQ(mgdt_voronoi_get_size(v, MGDT_VORONOI_ARRAY_FACE_CORNERS, &after), MGDT_OK);
        EXPECT_LT(after, before);
        mgdt_voronoi_destroy(v);
    }
    EXPECT_EQ(fault_balance(), balance);
}

// The star of a vertex with many neighbours takes memory to go around.
TEST(Allocator, RunsOutOfMemoryAroundAHub) {
    Points xyz = random_points(600, 5);
    for (std::size_t i = 0; i < 600; ++i) {
        // On a sphere about the first.
        double* const p = &xyz[3 * i];
        const double d[3] = {p[0] - 0.5, p[1] - 0.5, p[2] - 0.5};
        const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        for (int k = 0; k < 3; ++k) p[k] = i == 0 ? 0 : d[k] / length;
    }
    Story story(true, 1, 0, MGDT_ORDER_AUTO);
    story.insert(xyz);
    const double q[3] = {0.01, 0.01, 0.01};
    std::int64_t vertex = -1;
    fault_arm(fault_handle, 1, INT64_MAX);
    const mgdt_status status = mgdt_nearest_vertex(story.handle(), q, &vertex);
    fault_disarm();
    expect_out_of_memory(story.handle(), status);
    EXPECT_EQ(mgdt_nearest_vertex(story.handle(), q, &vertex), MGDT_OK);
    EXPECT_EQ(vertex, 0);
}

class EveryCallOnThreads : public testing::TestWithParam<Call> {};

// Enough points for two threads in every call.
TEST_P(EveryCallOnThreads, RunsOutOfMemory) {
    Refusals refusals{fault_handle, true, false};
    refusals.done_to(GetParam(), is_small() ? 700 : 21000, 2, true, false);
    if (GetParam().asks_for_memory) {
        EXPECT_GT(refusals.failed, 0);
    }
    EXPECT_EQ(handle_errors(), 0);
}

INSTANTIATE_TEST_SUITE_P(Allocator, EveryCall, testing::ValuesIn(calls),
                         [](const auto& info) { return name_of(info.param.name); });

// All but the last, mgdt_reserve(), which needs no threads.
INSTANTIATE_TEST_SUITE_P(Allocator, EveryCallOnThreads,
                         testing::ValuesIn(std::begin(calls), std::end(calls) - 1),
                         [](const auto& info) { return name_of(info.param.name); });

TEST(Allocator, RefusesTheHandleItself) {
    mgdt_triangulation* t = reinterpret_cast<mgdt_triangulation*>(&t);
    const std::int64_t balance = fault_balance();
    for (std::int64_t nth = 1;; ++nth) {
        fault_arm(fault_handle, nth, nth + 1);
        const mgdt_status status =
            mgdt_create_with_allocator(handle_take, handle_give, nullptr, &t);
        const std::int64_t requests = fault_disarm();
        if (status == MGDT_OK) {
            EXPECT_GT(nth, 1);
            EXPECT_LT(requests, nth);
            break;
        }
        EXPECT_EQ(status, MGDT_ERR_OUT_OF_MEMORY);
        EXPECT_EQ(t, nullptr);
        EXPECT_EQ(fault_balance(), balance);
    }
    // Promises no such error.
    const Points xyz = random_points(100, 1);
    EXPECT_EQ(mgdt_insert_points(t, count(xyz), xyz.data()), MGDT_OK);
    fault_arm(fault_handle, 1, INT64_MAX);
    EXPECT_EQ(mgdt_clear(t), MGDT_OK);
    fault_disarm();
    EXPECT_EQ(mgdt_point_count(t), 0);
    mgdt_destroy(t);
    EXPECT_EQ(fault_balance(), balance);
}

}  // namespace
}  // namespace faults
