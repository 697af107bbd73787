// SPDX-License-Identifier: MIT
// Cancelled at every call of the progress callback, for every order scheme and number of threads,
// in one batch and in several: a valid triangulation of what got in, and inserting the rest gives
// what would have been.
#include "flows.hpp"

namespace faults {
namespace {

struct Watch {
    std::int64_t calls = 0, stop_at = 0;
    static std::int32_t observe(double, void* user) {
        Watch* const w = static_cast<Watch*>(user);
        return ++w->calls == w->stop_at;
    }
};

struct Way {
    std::int32_t scheme, threads;
    std::size_t batches;
};

std::vector<Way> ways() {
    std::vector<Way> all;
    for (const std::int32_t scheme : property::schemes)
        for (const std::int32_t threads : {1, 2, 3})
            for (const std::size_t batches : {std::size_t{1}, std::size_t{3}})
                if (batches == 1 || threads != 2) all.push_back({scheme, threads, batches});
    return all;
}

class Cancelled : public testing::TestWithParam<Way> {};

TEST_P(Cancelled, AtEveryCallback) {
    const Way& way = GetParam();
    // The calling thread looks at the request between pieces of 64 points.
    const std::size_t n = way.threads > 1 ? 900 : is_small() ? 90 : 240;
    // The first points of the several batches are flat.
    Points xyz = joined(random_points(n / 2, 11, 6), random_points(n - n / 2, 12));
    if (way.batches > 1)
        for (std::size_t i = 0; i < n / 3; ++i) xyz[3 * i + 2] = 0;
    std::vector<Points> batches;
    for (std::size_t k = 0; k < way.batches; ++k)
        batches.emplace_back(
            xyz.begin() + static_cast<std::ptrdiff_t>(n * k / way.batches * 3),
            xyz.begin() + static_cast<std::ptrdiff_t>(n * (k + 1) / way.batches * 3));
    Story expected(false, 1, 0, MGDT_ORDER_AUTO);
    expected.insert(xyz);
    const property::Keys geometry = expected.geometry();

    const std::int64_t step = is_small() ? 17 : 1;
    std::int64_t cancelled = 0;
    for (std::int64_t stop_at = 1;; stop_at += step) {
        SCOPED_TRACE(stop_at);
        Story story(false, way.threads, 64, way.scheme);
        mgdt_triangulation* const t = story.handle();
        Watch watch;
        watch.stop_at = stop_at;
        ASSERT_EQ(mgdt_set_progress(t, Watch::observe, &watch), MGDT_OK);
        bool stopped = false;
        for (const Points& batch : batches) {
            const std::int64_t before = mgdt_point_count(t);
            const mgdt_status status = mgdt_insert_points(t, count(batch), batch.data());
            ASSERT_TRUE(story.note(batch));
            if (status == MGDT_OK) continue;
            ASSERT_EQ(status, MGDT_ERR_CANCELLED);
            ASSERT_FALSE(stopped);
            stopped = true;
            ASSERT_NE(property::error_of(t).find("cancelled"), std::string::npos);
            story.expect_valid();
            // What was in is in.
            const Numbers map = property::point_map(t);
            for (std::int64_t i = 0; i < before; ++i)
                ASSERT_GE(map[static_cast<std::size_t>(i)], 0);
            // The rest, that is, those that the map says are not in.
            Points rest;
            for (std::size_t i = 0; i < batch.size() / 3; ++i)
                if (map[static_cast<std::size_t>(before) + i] < 0)
                    rest.insert(rest.end(), batch.begin() + static_cast<std::ptrdiff_t>(3 * i),
                                batch.begin() + static_cast<std::ptrdiff_t>(3 * i + 3));
            story.insert(rest);
        }
        story.expect_valid();
        ASSERT_EQ(story.geometry(), geometry);
        if (watch.calls < stop_at) break;
        cancelled += stopped;
    }
    EXPECT_GT(cancelled, is_small() ? 0 : way.threads > 1 ? 0 : 20);
}

INSTANTIATE_TEST_SUITE_P(Ways, Cancelled, testing::ValuesIn(ways()), [](const auto& info) {
    std::string name = mgdt_order_scheme_name(info.param.scheme);
    std::replace(name.begin(), name.end(), '-', '_');
    return name + "_threads_" + std::to_string(info.param.threads) + "_batches_" +
           std::to_string(info.param.batches);
});

}  // namespace
}  // namespace faults
