// SPDX-License-Identifier: MIT
// The thread rule: const calls on one handle from many threads at once, different handles in
// different threads, and mgdt_cancel() from another thread.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <random>
#include <thread>
#include <vector>

#include "../support/aligned.h"
#include "handle.hpp"
#include "mgdt/mgdt.hpp"

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
    const std::vector<double> xyz = random_points(is_small() ? 200 : 3000, 1),
                              queries = random_points(is_small() ? 50 : 500, 2);
    for (int k = 0; k < 4; ++k) {
        const property::Handle t = property::create();
        ASSERT_EQ(mgdt_set_canonical_output(t.get(), k % 2), MGDT_OK);
        ASSERT_EQ(mgdt_set_compact(t.get(), k / 2), MGDT_OK);
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
    const std::vector<double> xyz = random_points(is_small() ? 300 : 10000, 3);
    std::vector<property::Keys> keys(4);
    std::vector<std::thread> threads;
    for (std::size_t k = 0; k < keys.size(); ++k)
        threads.emplace_back([&, k] {
            const property::Handle t = property::create();
            EXPECT_EQ(mgdt_set_order_scheme(t.get(), order_schemes[2 * k + 2]), MGDT_OK);
            EXPECT_EQ(
                property::insert(t.get(), xyz, property::equal_batches(xyz.size() / 3, k + 1)),
                MGDT_OK);
            keys[k] = property::keys(property::tetrahedra(t.get()));
        });
    for (std::thread& thread : threads) thread.join();
    for (const property::Keys& k : keys) EXPECT_TRUE(k == keys[0]);
}

// What const calls make once, the list of tetrahedra and the neighbours of vertices, the threads
// race for. A box is built by two threads.
TEST(Threads, ConstCallsOnAPeriodicBox) {
    const std::vector<double> xyz = random_points(is_small() ? 300 : 20000, 12);
    const double cube[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    mgdt::Periodic p(mgdt::Points(cube, 3));
    p.set_option(mgdt::PeriodicOption::threads, 2);
    p.insert(xyz);
    p.build();
    const auto look_at = [&] {
        std::vector<std::vector<std::int64_t>> seen;
        for (const mgdt::PeriodicArray array :
             {mgdt::PeriodicArray::neighbors, mgdt::PeriodicArray::tetrahedra,
              mgdt::PeriodicArray::vertex_neighbors, mgdt::PeriodicArray::tetrahedron_shifts})
            seen.push_back(p.array(array));
        double sum = 0;
        for (const double v : p.cell_measures(mgdt::Measure::volume)) sum += v;
        EXPECT_NEAR(sum, 1, 1e-12);
        seen.push_back({static_cast<std::int64_t>(
            p.voronoi().doubles(mgdt::VoronoiDoubles::cell_volumes).size())});
        return seen;
    };
    std::vector<std::vector<std::vector<std::int64_t>>> views(3);
    std::vector<std::thread> threads;
    for (auto& view : views) threads.emplace_back([&] { view = look_at(); });
    for (std::thread& thread : threads) thread.join();
    const auto expected = look_at();
    for (const auto& view : views) EXPECT_TRUE(view == expected);
}

TEST(Threads, CancelABuildInABox) {
    // On a line, so that the halo is predicted from a sample.
    std::vector<double> xyz = random_points(is_smallest() ? 2000 : is_small() ? 5000 : 50000, 13);
    for (std::size_t i = 0; i < xyz.size(); ++i)
        xyz[i] = i % 3 == 0 ? static_cast<double>(i) / static_cast<double>(xyz.size()) : 0.5;
    const double cube[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    mgdt::Periodic p(mgdt::Points(cube, 3));
    p.insert(xyz);
    std::atomic<bool> started{false};
    p.set_progress([&](double) {
        started = true;
        return true;
    });
    std::thread other([&] {
        while (!started) std::this_thread::yield();
        p.cancel();
    });
    EXPECT_THROW(p.build(), mgdt::Cancelled);
    other.join();
    EXPECT_EQ(p.statistic(mgdt::PeriodicStatistic::vertices), 0);
}

// The stop comes from another thread once the insertion reports its first progress.
TEST(Threads, CancelFromAnotherThread) {
    const std::vector<double> xyz = random_points(is_smallest() ? 8000
                                                  : is_small()  ? 20000
                                                                : 300000,
                                                  4);
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

// What breaks the thread rule while an insertion runs is refused.
TEST(Threads, CallsThatBreakTheRuleAreRefused) {
    const std::vector<double> xyz = random_points(is_smallest() ? 8000
                                                  : is_small()  ? 20000
                                                                : 60000,
                                                  11);
    const auto n = static_cast<std::int64_t>(xyz.size() / 3);
    const property::Handle t = property::create();
    ASSERT_EQ(mgdt_set_threads(t.get(), 2), MGDT_OK);
    // The insertion waits in its callback until the other thread has called.
    struct Meeting {
        std::atomic<int> state{0};
        static std::int32_t hear(double, void* user) {
            Meeting& self = *static_cast<Meeting*>(user);
            int expected = 0;
            if (self.state.compare_exchange_strong(expected, 1))
                while (self.state != 2) std::this_thread::yield();
            return 0;
        }
    } meeting;
    ASSERT_EQ(mgdt_set_progress(t.get(), Meeting::hear, &meeting), MGDT_OK);
    std::thread other([&] {
        while (meeting.state != 1) std::this_thread::yield();
        std::int64_t found = -7;
        EXPECT_EQ(mgdt_insert_points(t.get(), n, xyz.data()), MGDT_ERR_BUSY);
        EXPECT_NE(property::error_of(t.get()).find("busy in mgdt_insert_points()"),
                  std::string::npos);
        EXPECT_EQ(mgdt_set_threads(t.get(), 1), MGDT_ERR_BUSY);
        EXPECT_EQ(mgdt_clear(t.get()), MGDT_ERR_BUSY);
        EXPECT_EQ(mgdt_nearest_vertex(t.get(), xyz.data(), &found), MGDT_ERR_BUSY);
        EXPECT_EQ(mgdt_check(t.get(), MGDT_CHECK_CANONICAL), MGDT_ERR_BUSY);
        EXPECT_EQ(mgdt_vertex_count(t.get()), 0);
        EXPECT_EQ(found, -7);
        mgdt_destroy(t.get());
        meeting.state = 2;
        // And at any moment of the rest.
        while (mgdt_set_index_base(t.get(), 0) == MGDT_ERR_BUSY) std::this_thread::yield();
    });
    EXPECT_EQ(mgdt_insert_points(t.get(), n, xyz.data()), MGDT_OK);
    other.join();
    EXPECT_EQ(mgdt_check(t.get(), MGDT_CHECK_CANONICAL), MGDT_OK);
}

// The same in a call that reads for long, which waits in its allocator until the other has called.
TEST(Threads, ChangesDuringALongReadingCallAreRefused) {
    const std::vector<double> xyz = random_points(1000, 12);
    struct Memory {
        std::atomic<int> state{0};  // 1: the next request waits, 2: it does, 3: it may go on
        static void* take(std::size_t bytes, std::size_t align, void* user) {
            Memory& self = *static_cast<Memory*>(user);
            int expected = 1;
            if (self.state.compare_exchange_strong(expected, 2))
                while (self.state != 3) std::this_thread::yield();
            return allocate_aligned(bytes, align);
        }
        static void give(void* p, std::size_t, std::size_t, void*) { free_aligned(p); }
    } memory;
    mgdt_triangulation* made = nullptr;
    ASSERT_EQ(mgdt_create_with_allocator(Memory::take, Memory::give, &memory, &made), MGDT_OK);
    const property::Handle t(made);
    ASSERT_EQ(mgdt_insert_points(made, 1000, xyz.data()), MGDT_OK);
    const std::int64_t vertices = mgdt_vertex_count(made);
    for (int k = 0; k < 2; ++k) {
        memory.state = 1;
        std::thread reader([&] {
            std::int64_t found[2];
            EXPECT_EQ(k == 0 ? mgdt_check(made, MGDT_CHECK_CANONICAL)
                             : mgdt_locate_points(made, 2, xyz.data(), found, nullptr),
                      MGDT_OK);
        });
        while (memory.state != 2) std::this_thread::yield();
        EXPECT_EQ(mgdt_set_seed(made, 1), MGDT_ERR_BUSY);
        EXPECT_EQ(mgdt_insert_points(made, 1000, xyz.data()), MGDT_ERR_BUSY);
        EXPECT_NE(property::error_of(made).find("busy in calls that read it"), std::string::npos);
        mgdt_destroy(made);
        // Other calls that read are welcome.
        std::int64_t found = -7;
        EXPECT_EQ(mgdt_nearest_vertex(made, xyz.data(), &found), MGDT_OK);
        EXPECT_EQ(mgdt_vertex_count(made), vertices);
        memory.state = 3;
        reader.join();
        EXPECT_EQ(mgdt_set_seed(made, 2), MGDT_OK);
    }
    EXPECT_EQ(mgdt_check(made, MGDT_CHECK_CANONICAL), MGDT_OK);
}

// Everything that can be exported, one after the other.
std::vector<std::int64_t> everything(const mgdt_triangulation* t) {
    std::vector<std::int64_t> all;
    const auto append = [&](const std::vector<std::int64_t>& part) {
        all.insert(all.end(), part.begin(), part.end());
    };
    append(property::tetrahedra(t));
    append(property::neighbors(t));
    append(property::hull_facets(t));
    append(property::edges(t));
    append(property::point_map(t));
    std::vector<std::int64_t> offsets(static_cast<std::size_t>(mgdt_point_count(t)) + 1),
        list(static_cast<std::size_t>(mgdt_vertex_tetrahedra_count(t)));
    EXPECT_EQ(
        mgdt_get_vertex_tetrahedra(t, static_cast<std::int64_t>(offsets.size()), offsets.data(),
                                   static_cast<std::int64_t>(list.size()), list.data()),
        MGDT_OK);
    append(offsets);
    append(list);
    list.resize(static_cast<std::size_t>(mgdt_vertex_neighbors_count(t)));
    EXPECT_EQ(
        mgdt_get_vertex_neighbors(t, static_cast<std::int64_t>(offsets.size()), offsets.data(),
                                  static_cast<std::int64_t>(list.size()), list.data()),
        MGDT_OK);
    append(offsets);
    append(list);
    for (const auto get : {mgdt_get_gabriel_edges, mgdt_get_spanning_tree}) {
        std::int64_t edges = 0;
        EXPECT_EQ(get(t, static_cast<std::int64_t>(list.size()), list.data(), &edges), MGDT_OK);
        list.resize(static_cast<std::size_t>(2 * edges));
        append(list);
        list.resize(static_cast<std::size_t>(mgdt_vertex_neighbors_count(t)));
    }
    std::vector<double> reals(4 * static_cast<std::size_t>(mgdt_tetrahedron_count(t)));
    EXPECT_EQ(mgdt_get_circumcenters(t, mgdt_tetrahedron_count(t), reals.data(),
                                     reals.data() + 3 * mgdt_tetrahedron_count(t)),
              MGDT_OK);
    {
        const double a[3] = {-0.1, 0.2, 0.3}, b[3] = {1.1, 0.7, 0.4};
        const auto room = static_cast<std::size_t>(mgdt_tetrahedron_count(t));
        std::vector<std::int64_t> way(room);
        std::vector<double> parameters(room + 1);
        std::int64_t passed = 0;
        EXPECT_EQ(mgdt_traverse_segment(t, a, b, static_cast<std::int64_t>(room), way.data(),
                                        parameters.data(), &passed),
                  MGDT_OK);
        way.resize(static_cast<std::size_t>(passed));
        append(way);
        reals.insert(reals.end(), parameters.begin(), parameters.begin() + passed);
    }
    std::vector<double> ratios(static_cast<std::size_t>(mgdt_tetrahedron_count(t)));
    EXPECT_EQ(mgdt_get_tetrahedron_measures(t, MGDT_TETRAHEDRON_RADIUS_RATIO,
                                            mgdt_tetrahedron_count(t), ratios.data()),
              MGDT_OK);
    reals.insert(reals.end(), ratios.begin(), ratios.end());
    for (const std::int32_t dimension : {1, 2}) {
        const std::int64_t size =
            dimension == 1 ? mgdt_edge_count(t) : 4 * mgdt_tetrahedron_count(t);
        std::vector<double> x(static_cast<std::size_t>(size));
        EXPECT_EQ(mgdt_get_alphas(t, dimension, size, x.data()), MGDT_OK);
        reals.insert(reals.end(), x.begin(), x.end());
    }
    for (const std::int32_t measure : {MGDT_MEASURE_VOLUME, MGDT_MEASURE_FACES}) {
        std::vector<double> x(static_cast<std::size_t>(mgdt_point_count(t)));
        EXPECT_EQ(mgdt_get_cell_measures(t, measure, 0, nullptr, mgdt_point_count(t), x.data()),
                  MGDT_OK);
        reals.insert(reals.end(), x.begin(), x.end());
    }
    std::vector<double> values(static_cast<std::size_t>(mgdt_point_count(t)));
    for (std::size_t k = 0; k < values.size(); ++k) values[k] = std::sin(static_cast<double>(k));
    std::vector<double> gradients(3 * values.size());
    EXPECT_EQ(mgdt_get_gradients(t, 1, values.data(), gradients.data()), MGDT_OK);
    reals.insert(reals.end(), gradients.begin(), gradients.end());
    for (const double x : reals) {
        std::int64_t bits;
        std::memcpy(&bits, &x, sizeof bits);
        all.push_back(bits);
    }
    return all;
}

// The exports of one handle have the same bytes whatever the number of threads, those of canonical
// output also if the handle was filled by others. Each array gets several threads in one set or
// another: the hull those of the sphere, the point map those of points that come often.
TEST(Threads, ExportsAreThoseOfOne) {
    const bool small = is_small();
    std::vector<double> sphere = random_points(small ? 1000 : 90000, 7),
                        often = random_points(small ? 1000 : 530000, 8);
    for (std::size_t i = 0; i < sphere.size(); i += 3) {
        double* const p = &sphere[i];
        for (int k = 0; k < 3; ++k) p[k] += 1e-3 * static_cast<double>(i % 1009) - 0.5 - 1e-4;
        const double length = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        for (int k = 0; k < 3; ++k) p[k] /= length;
    }
    for (double& x : often) x = std::floor(16 * x);
    const std::vector<double> sets[] = {random_points(small ? 10000 : 45000, 9), sphere, often};
    for (const std::vector<double>& xyz : sets) {
        const auto n = static_cast<std::int64_t>(xyz.size() / 3);
        const property::Handle of_one = property::create(), of_three = property::create();
        ASSERT_EQ(mgdt_insert_points(of_one.get(), n, xyz.data()), MGDT_OK);
        std::vector<std::int64_t> expected;
        for (int canonical = 0; canonical < 2; ++canonical) {
            for (const std::int32_t threads : {1, 3}) {
                ASSERT_EQ(mgdt_set_threads(of_one.get(), threads), MGDT_OK);
                // Forgets the numbers too, so that these threads make them.
                ASSERT_EQ(mgdt_set_canonical_output(of_one.get(), canonical), MGDT_OK);
                if (threads == 1)
                    expected = everything(of_one.get());
                else
                    EXPECT_TRUE(everything(of_one.get()) == expected) << n << ' ' << canonical;
            }
        }
        ASSERT_EQ(mgdt_set_canonical_output(of_three.get(), 1), MGDT_OK);
        ASSERT_EQ(mgdt_set_threads(of_three.get(), 3), MGDT_OK);
        ASSERT_EQ(mgdt_insert_points(of_three.get(), n, xyz.data()), MGDT_OK);
        EXPECT_TRUE(everything(of_three.get()) == expected) << n;
    }
}

// Sorted by the lesser index and then the greater, in canonical output; each once in any.
TEST(Threads, EdgesAreSortedAndOnce) {
    const std::vector<double> xyz = random_points(is_small() ? 500 : 20000, 10);
    for (int canonical = 0; canonical < 2; ++canonical) {
        const property::Handle t = property::create();
        ASSERT_EQ(mgdt_set_canonical_output(t.get(), canonical), MGDT_OK);
        ASSERT_EQ(
            mgdt_insert_points(t.get(), static_cast<std::int64_t>(xyz.size() / 3), xyz.data()),
            MGDT_OK);
        using Edge = std::pair<std::int64_t, std::int64_t>;
        std::vector<Edge> edges, expected;
        const std::vector<std::int64_t> flat = property::edges(t.get());
        for (std::size_t i = 0; i < flat.size(); i += 2) edges.emplace_back(flat[i], flat[i + 1]);
        if (canonical == 1) {
            EXPECT_TRUE(std::is_sorted(edges.begin(), edges.end()));
        }
        std::sort(edges.begin(), edges.end());
        for (const property::Key& key : property::keys(property::tetrahedra(t.get())))
            for (std::size_t a = 0; a < 4; ++a)
                for (std::size_t b = a + 1; b < 4; ++b) expected.emplace_back(key[a], key[b]);
        std::sort(expected.begin(), expected.end());
        expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
        EXPECT_TRUE(edges == expected);
    }
}

// Locations by several threads are those of one, on the same handle.
TEST(Threads, LocationsAreThoseOfOne) {
    const std::vector<double> xyz = random_points(is_smallest() ? 4000
                                                  : is_small()  ? 9000
                                                                : 60000,
                                                  5),
                              queries = random_points(20000, 6);
    const auto queried = static_cast<std::int64_t>(queries.size() / 3);
    const property::Handle t = property::create();
    ASSERT_EQ(mgdt_insert_points(t.get(), static_cast<std::int64_t>(xyz.size() / 3), xyz.data()),
              MGDT_OK);
    std::vector<std::int64_t> found;
    std::vector<double> weights;
    for (const std::int32_t threads : {4, 1}) {
        ASSERT_EQ(mgdt_set_threads(t.get(), threads), MGDT_OK);
        std::vector<std::int64_t> places(static_cast<std::size_t>(queried));
        std::vector<double> shares(4 * places.size());
        ASSERT_EQ(
            mgdt_locate_points(t.get(), queried, queries.data(), places.data(), shares.data()),
            MGDT_OK);
        if (threads == 4) {
            found = places;
            weights = shares;
        }
        // A place on a facet, which has a weight of 0, may be found on either side of it.
        for (std::size_t i = 0; i < places.size(); ++i) {
            const auto least = [&](const std::vector<double>& w) {
                return *std::min_element(&w[4 * i], &w[4 * i] + 4);
            };
            if (found[i] == places[i]) {
                EXPECT_TRUE(std::equal(&weights[4 * i], &weights[4 * i] + 4, &shares[4 * i])) << i;
            } else {
                EXPECT_TRUE(least(weights) <= 0 && least(shares) <= 0) << i;
            }
        }
        EXPECT_EQ(mgdt_check(t.get(), MGDT_CHECK_CANONICAL), MGDT_OK);
    }
}

}  // namespace
