// SPDX-License-Identifier: MIT
// The thread rule: const calls on one handle from many threads at once, different handles in
// different threads, and mgdt_cancel() from another thread.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <random>
#include <thread>
#include <vector>

#include "handle.hpp"

namespace {

std::vector<double> random_points(std::size_t n, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    std::vector<double> xyz(3 * n);
    for (double& x : xyz) x = std::floor(std::ldexp(double(random() >> 40), -24) * 64) / 64;
    return xyz;
}

// What one thread sees of a handle.
struct View {
    std::vector<std::int64_t> tetrahedra, neighbors, hull, edges, map, nearest;
    bool operator==(const View& o) const {
        return tetrahedra == o.tetrahedra && neighbors == o.neighbors && hull == o.hull &&
               edges == o.edges && map == o.map && nearest == o.nearest;
    }
};

View look(const mgdt_triangulation* t, const std::vector<double>& queries) {
    View view = {property::tetrahedra(t), property::neighbors(t), property::hull_facets(t),
                 property::edges(t),      property::point_map(t), {}};
    const std::size_t n = queries.size() / 3;
    std::vector<std::int64_t> found(n);
    std::vector<double> weights(4 * n);
    EXPECT_EQ(mgdt_locate_points(t, static_cast<std::int64_t>(n), queries.data(), found.data(),
                                 weights.data()),
              MGDT_OK);
    for (std::size_t i = 0; i < n; ++i) {
        std::int64_t vertex = -1;
        EXPECT_EQ(mgdt_nearest_vertex(t, &queries[3 * i], &vertex), MGDT_OK);
        view.nearest.push_back(vertex);
    }
    EXPECT_EQ(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
    EXPECT_EQ(mgdt_set_index_base(nullptr, 1), MGDT_ERR_NULL_POINTER);
    return view;
}

TEST(Threads, ConstCallsOnOneHandle) {
    const std::vector<double> xyz = random_points(property::small() ? 200 : 3000, 1),
                              queries = random_points(property::small() ? 50 : 500, 2);
    for (int canonical = 0; canonical < 2; ++canonical) {
        const property::Handle t = property::create();
        ASSERT_EQ(mgdt_set_canonical_output(t.get(), canonical), MGDT_OK);
        ASSERT_EQ(
            mgdt_insert_points(t.get(), static_cast<std::int64_t>(xyz.size() / 3), xyz.data()),
            MGDT_OK);
        // The threads come first: what a const call would compute once and keep, they race for.
        std::vector<View> views(4);
        std::vector<std::thread> threads;
        for (View& view : views) threads.emplace_back([&] { view = look(t.get(), queries); });
        for (std::thread& thread : threads) thread.join();
        const View expected = look(t.get(), queries);
        for (const View& view : views) EXPECT_TRUE(view == expected);
    }
}

TEST(Threads, DifferentHandles) {
    const std::vector<double> xyz = random_points(property::small() ? 300 : 10000, 3);
    std::vector<property::Keys> keys(4);
    std::vector<std::thread> threads;
    for (std::size_t k = 0; k < keys.size(); ++k)
        threads.emplace_back([&, k] {
            const property::Handle t = property::create();
            EXPECT_EQ(mgdt_set_order_scheme(t.get(), property::schemes[2 * k + 2]), MGDT_OK);
            EXPECT_EQ(
                property::insert(t.get(), xyz, property::equal_batches(xyz.size() / 3, k + 1)),
                MGDT_OK);
            keys[k] = property::keys(property::tetrahedra(t.get()));
        });
    for (std::thread& thread : threads) thread.join();
    for (const property::Keys& k : keys) EXPECT_TRUE(k == keys[0]);
}

// The stop comes from another thread once the insertion reports its first progress.
TEST(Threads, CancelFromAnotherThread) {
    const std::vector<double> xyz = random_points(property::small() ? 20000 : 300000, 4);
    const property::Handle t = property::create();
    std::atomic<bool> started{false};
    const mgdt_progress_fn tell = [](double, void* user) -> std::int32_t {
        static_cast<std::atomic<bool>*>(user)->store(true);
        return 0;
    };
    ASSERT_EQ(mgdt_set_progress(t.get(), tell, &started), MGDT_OK);
    std::thread other([&] {
        while (!started) std::this_thread::yield();
        mgdt_cancel(t.get());
    });
    const mgdt_status status =
        mgdt_insert_points(t.get(), static_cast<std::int64_t>(xyz.size() / 3), xyz.data());
    other.join();
    EXPECT_EQ(status, MGDT_ERR_CANCELLED);
    EXPECT_EQ(mgdt_check(t.get(), MGDT_CHECK_CANONICAL), MGDT_OK) << property::error_of(t.get());
}

// Exports and locations by several threads are those of one, on the same handle.
TEST(Threads, OfOneCall) {
    const std::vector<double> xyz = random_points(property::small() ? 9000 : 60000, 5),
                              queries = random_points(20000, 6);
    const auto queried = static_cast<std::int64_t>(queries.size() / 3);
    for (int canonical = 0; canonical < 2; ++canonical) {
        const property::Handle t = property::create();
        ASSERT_EQ(mgdt_set_canonical_output(t.get(), canonical), MGDT_OK);
        ASSERT_EQ(mgdt_set_threads(t.get(), 4), MGDT_OK);
        ASSERT_EQ(
            mgdt_insert_points(t.get(), static_cast<std::int64_t>(xyz.size() / 3), xyz.data()),
            MGDT_OK);
        std::vector<std::int64_t> tetrahedra, neighbors, found;
        std::vector<double> weights;
        for (const std::int32_t threads : {4, 1}) {
            ASSERT_EQ(mgdt_set_threads(t.get(), threads), MGDT_OK);
            std::vector<std::int64_t> places(static_cast<std::size_t>(queried));
            std::vector<double> shares(4 * places.size());
            ASSERT_EQ(
                mgdt_locate_points(t.get(), queried, queries.data(), places.data(), shares.data()),
                MGDT_OK);
            if (threads == 4) {
                tetrahedra = property::tetrahedra(t.get());
                neighbors = property::neighbors(t.get());
                found = places;
                weights = shares;
            }
            EXPECT_TRUE(tetrahedra == property::tetrahedra(t.get()));
            EXPECT_TRUE(neighbors == property::neighbors(t.get()));
            // A place on a facet may be found on either side of it.
            for (std::size_t i = 0; i < places.size(); ++i) {
                double on_boundary = 1;
                for (std::size_t k = 4 * i; k < 4 * i + 4; ++k)
                    on_boundary = std::min(on_boundary, std::min(weights[k], shares[k]));
                EXPECT_TRUE(found[i] == places[i] || on_boundary < 1e-12) << i;
            }
            EXPECT_EQ(mgdt_check(t.get(), MGDT_CHECK_CANONICAL), MGDT_OK);
        }
    }
}

}  // namespace
