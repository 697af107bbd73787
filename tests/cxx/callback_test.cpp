// SPDX-License-Identifier: MIT
// The callbacks for progress and sizes: any callable, exceptions through it, and cancelling.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

#include "../support/aligned.h"
#include "random_points.hpp"

using namespace cxx_test;
using mgdt::Triangulation;

namespace {

struct Observer {
    bool hear(double fraction) {
        last = fraction;
        ++calls;
        return false;
    }
    double last = -1;
    long calls = 0;
};

long free_calls = 0;
void count_call(double) {
    ++free_calls;
}

// An exception of no standard class.
struct Stop {
    int call;
};

}  // namespace

TEST(CxxProgress, AnythingThatCanBeCalled) {
    const auto points = points_in_cube(size(5000));
    Observer observer;
    const auto with = [&points](auto&& callable) {
        Triangulation t;
        t.set_progress(std::forward<decltype(callable)>(callable));
        t.insert(points);
        t.check();
        EXPECT_EQ(t.vertex_count(), std::int64_t(points.size()));
    };
    with([&](double fraction) { observer.hear(fraction); });
    EXPECT_EQ(observer.last, 1);
    EXPECT_GE(observer.calls, 5);
    long before = observer.calls;
    with(std::bind(&Observer::hear, &observer, std::placeholders::_1));
    EXPECT_GT(observer.calls, before);
    before = observer.calls;
    with(std::function<bool(double)>([&](double f) { return observer.hear(f); }));
    EXPECT_GT(observer.calls, before);
    before = observer.calls;
    // One that cannot be copied, whose result is an integer, with a float for an argument.
    with([owned = std::make_unique<Observer*>(&observer)](float f) {
        return (*owned)->hear(f) ? 1 : 0;
    });
    EXPECT_GT(observer.calls, before);
    with(&count_call);
    with(count_call);
    EXPECT_GE(free_calls, 10);
    // It may have state, which is kept between calls.
    with([calls = 0](double) mutable { return ++calls < 0; });
}

TEST(CxxProgress, ReplacedAndTakenOff) {
    const auto points = points_in_cube(size(5000));
    auto life = std::make_shared<int>(0);
    Triangulation t;
    t.set_progress([life](double) { ++*life; });
    EXPECT_EQ(life.use_count(), 2);
    t.insert(points);
    const int heard = *life;
    EXPECT_GT(heard, 0);
    long second = 0;
    t.set_progress([&second](double) { ++second; });
    EXPECT_EQ(life.use_count(), 1);
    t.insert(points_in_cube(size(5000), 2));
    EXPECT_EQ(*life, heard);
    EXPECT_GT(second, 0);
    const long before = second;
    t.clear_progress();
    t.insert(points_in_cube(size(5000), 3));
    EXPECT_EQ(second, before);
    t.clear_progress();
    {
        Triangulation u;
        u.set_progress([life](double) {});
        EXPECT_EQ(life.use_count(), 2);
    }
    EXPECT_EQ(life.use_count(), 1);
}

TEST(CxxProgress, CancelsByItsResult) {
    const auto points = points_in_cube(size(20000));
    Triangulation t;
    t.set_progress([](double fraction) { return fraction > 0.3; });
    try {
        t.insert(points);
        FAIL() << "no exception";
    } catch (const mgdt::Cancelled& cancelled) {
        EXPECT_EQ(cancelled.status(), MGDT_ERR_CANCELLED);
        EXPECT_STRNE(cancelled.what(), "");
    }
    EXPECT_EQ(t.point_count(), std::int64_t(points.size()));
    EXPECT_LT(t.vertex_count(), t.point_count());
    t.check();
    t.clear_progress();
    t.insert(points);
    EXPECT_EQ(t.vertex_count(), std::int64_t(points.size()));
    t.check();
}

TEST(CxxProgress, ExceptionsPassUnchanged) {
    const auto points = points_in_cube(size(20000));
    // The last call of an insertion is among them.
    long calls = 0;
    {
        Triangulation t;
        t.set_progress([&calls](double) { ++calls; });
        t.insert(points);
    }
    ASSERT_GE(calls, 5);
    for (const long at : {1l, 2l, calls / 2, calls - 1, calls}) {
        Triangulation t;
        long call = 0;
        t.set_progress([&](double) {
            if (++call == at) throw Stop{int(call)};
        });
        try {
            t.insert(points);
            ADD_FAILURE() << "no exception at call " << at;
        } catch (const Stop& stop) {
            EXPECT_EQ(stop.call, at);
        }
        t.check();
        // Nothing of it is left: the object works, with the same callback.
        t.insert(points);
        EXPECT_EQ(t.vertex_count(), std::int64_t(points.size()));
        t.check();
    }

    Triangulation t;
    t.set_progress([](double) -> bool { throw std::out_of_range("mine"); });
    for (int k = 0; k < 2; ++k) {
        try {
            t.insert(points);
            ADD_FAILURE() << "no exception";
        } catch (const std::out_of_range& error) {
            EXPECT_STREQ(error.what(), "mine");
        }
    }
    t.clear_progress();
    t.insert(points);
    t.check();
    // With that setting, calls that read throw what the callback throws, even at the last report.
    t.set_read_progress(true);
    for (const double from : {0., 1.}) {
        t.set_progress([from](double fraction) {
            if (fraction >= from) throw std::out_of_range("mine");
        });
        EXPECT_THROW(t.check(), std::out_of_range);
        EXPECT_THROW((void)t.gabriel_edges(), std::out_of_range);
        EXPECT_THROW(mgdt::Voronoi{t}, std::out_of_range);
    }
    t.set_progress([](double) { return true; });
    EXPECT_THROW(t.check(), mgdt::Cancelled);
    EXPECT_THROW(mgdt::Voronoi{t}, mgdt::Cancelled);
    t.set_read_progress(false);
    t.check();
}

// What a callback calls of its own object is refused, and harms nothing.
TEST(CxxProgress, ItsOwnObjectIsBusy) {
    const auto points = points_in_cube(size(5000));
    Triangulation t;
    long calls = 0, refused = 0;
    const auto count = [&refused](auto&& call) {
        try {
            call();
        } catch (const mgdt::Busy& busy) {
            EXPECT_EQ(busy.status(), MGDT_ERR_BUSY);
            EXPECT_NE(std::string(busy.what()).find("busy in mgdt_insert_points"),
                      std::string::npos);
            ++refused;
        }
    };
    t.set_progress([&](double) {
        ++calls;
        count([&] { t.insert({{0.5, 0.5, 0.5}}); });
        count([&] { t.clear(); });
        count([&] { t.set_threads(2); });
        count([&] { t.set_progress([](double) {}); });
        count([&] { t.clear_progress(); });
        count([&] { t.check(); });
        count([&] { (void)t.statistic(mgdt::Statistic::memory_bytes); });
        count([&] { (void)t.locate({0.5, 0.5, 0.5}); });
        EXPECT_EQ(t.release(), nullptr);
        EXPECT_TRUE(t);
        EXPECT_EQ(t.vertex_count(), 0);
    });
    t.insert(points);
    EXPECT_GE(calls, 5);
    EXPECT_EQ(refused, 8 * calls);
    EXPECT_EQ(t.vertex_count(), std::int64_t(points.size()));
    t.check();
    // Unless it is caught, the exception ends the insertion as any other does.
    t.set_progress([&t](double) { t.clear(); });
    EXPECT_THROW(t.insert(points_in_cube(size(5000), 2)), mgdt::Busy);
    t.check();
}

// Callbacks of the C interface must not throw. If one does, no exception passes through the
// library: one of the progress callback cancels, one of the allocator is memory that is refused.
TEST(CCallbacks, ExceptionsGoNoFurther) {
    const auto points = points_in_cube(size(20000));
    const auto n = std::int64_t(points.size());
    struct User {
        long calls, at;
        double thrown_at;
    } user{0, 0, 0};
    for (const std::int32_t threads : {1, 3}) {
        for (const long at : {1l, 2l, 20l}) {
            mgdt_triangulation* t = nullptr;
            ASSERT_EQ(mgdt_create(&t), MGDT_OK);
            ASSERT_EQ(mgdt_set_threads(t, threads), MGDT_OK);
            user = {0, at, 1};
            const mgdt_progress_fn progress = [](double fraction, void* u) -> std::int32_t {
                User& self = *static_cast<User*>(u);
                if (++self.calls < self.at) return 0;
                self.thrown_at = fraction;
                throw Stop{int(self.at)};
            };
            ASSERT_EQ(mgdt_set_progress(t, progress, &user), MGDT_OK);
            const mgdt_status status = mgdt_insert_points(t, n, points.data()->data());
            EXPECT_GE(user.calls, 1);
            EXPECT_EQ(status, user.thrown_at < 1 ? MGDT_ERR_CANCELLED : MGDT_OK);
            EXPECT_EQ(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
            ASSERT_EQ(mgdt_set_progress(t, nullptr, nullptr), MGDT_OK);
            EXPECT_EQ(mgdt_insert_points(t, n, points.data()->data()), MGDT_OK);
            EXPECT_EQ(mgdt_vertex_count(t), n);
            mgdt_destroy(t);
        }
    }

    struct Memory {
        long left;
        static void* take(std::size_t bytes, std::size_t align, void* user) {
            if (static_cast<Memory*>(user)->left-- == 0) throw Stop{0};
            return allocate_aligned(bytes, align);
        }
        static void give(void* p, std::size_t, std::size_t, void*) {
            free_aligned(p);
            throw Stop{1};
        }
    };
    for (long k = 0; k < 12; ++k) {
        Memory memory{k};
        mgdt_triangulation* t = nullptr;
        const mgdt_status made =
            mgdt_create_with_allocator(Memory::take, Memory::give, &memory, &t);
        if (made != MGDT_OK) {
            EXPECT_EQ(made, MGDT_ERR_OUT_OF_MEMORY);
            EXPECT_EQ(t, nullptr);
            continue;
        }
        const mgdt_status status = mgdt_insert_points(t, 1000, points.data()->data());
        EXPECT_TRUE(status == MGDT_OK || status == MGDT_ERR_OUT_OF_MEMORY) << status;
        EXPECT_EQ(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK);
        mgdt_destroy(t);
    }
}

TEST(CxxProgress, CancelFromElsewhere) {
    const auto points = points_in_cube(size(20000));
    Triangulation t;
    t.cancel();
    EXPECT_THROW(t.insert(points), mgdt::Cancelled);

    // From within, and from another thread while the call is on its way.
    t.clear();
    t.set_progress([&t](double) { t.cancel(); });
    EXPECT_THROW(t.insert(points), mgdt::Cancelled);

    t.clear();
    std::atomic<int> state{0};
    t.set_progress([&state](double) {
        int expected = 0;
        if (state.compare_exchange_strong(expected, 1))
            while (state.load() != 2) std::this_thread::yield();
    });
    std::thread other([&] {
        while (state.load() != 1) std::this_thread::yield();
        t.cancel();
        state = 2;
    });
    EXPECT_THROW(t.insert(points), mgdt::Cancelled);
    other.join();
    t.check();
    t.clear_progress();
    t.insert(points);
    EXPECT_EQ(t.vertex_count(), std::int64_t(points.size()));
}

TEST(CxxThreads, ConstFunctionsRunAtOnce) {
    const auto points = points_in_cube(size(5000));
    const auto asked = points_in_cube(size(2000), 9);
    const Triangulation t = triangulated(points);
    const auto expected = t.locate_with_weights(asked);
    std::atomic<int> different{0};
    std::vector<std::thread> threads;
    for (int k = 0; k < 4; ++k)
        threads.emplace_back([&] {
            const auto found = t.locate_with_weights(asked);
            if (found.tetrahedra != expected.tetrahedra || found.weights != expected.weights)
                ++different;
            if (t.tetrahedra<std::int32_t>().size() != t.tetrahedra().size()) ++different;
            if (status_of([&] { (void)t.locate({NAN, 0, 0}); }) != MGDT_ERR_NOT_FINITE) ++different;
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(different.load(), 0);
}

namespace {

// A tetrahedron as a mesh.
mgdt::Mesh one_tetrahedron() {
    mgdt::Mesh mesh;
    mesh.set_points(std::vector<mgdt::Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    mesh.set_tetrahedra(std::vector<std::int64_t>{0, 1, 2, 3});
    mesh.build();
    return mesh;
}

}  // namespace

TEST(CxxSizeFunction, ThrowsThroughTheCall) {
    mgdt::Mesh mesh = one_tetrahedron();
    mesh.set_size_function([](const mgdt::Point&) -> double { throw Stop{7}; });
    try {
        mesh.refine();
        ADD_FAILURE() << "nothing thrown";
    } catch (const Stop& stop) {
        EXPECT_EQ(stop.call, 7);
    }
    EXPECT_EQ(mesh.statistic(mgdt::MeshStatistic::tetrahedra), 1);
    mesh.set_size_function([](const mgdt::Point&) { return -1; });
    EXPECT_THROW(mesh.refine(), mgdt::Error);
}

TEST(CxxSizeFunction, GoesWithTheMesh) {
    long calls = 0;
    mgdt::Mesh mesh = one_tetrahedron();
    mesh.set_size_function([&calls, much = std::string(100, 'x')](const mgdt::Point& p) {
        EXPECT_EQ(much.size(), 100u);
        ++calls;
        return 0.1 + 0.1 * p[2];
    });
    mgdt::Mesh moved = std::move(mesh), other;
    swap(moved, other);
    other.refine();
    EXPECT_GT(calls, 100);
    EXPECT_GT(other.statistic(mgdt::MeshStatistic::inserted_points), 20);
    mgdt_mesh* const handle = other.release();
    mgdt_size_fn fn = nullptr;
    EXPECT_EQ(mgdt_mesh_get_size_function(handle, &fn, nullptr), MGDT_OK);
    EXPECT_EQ(fn, nullptr);
    mgdt_mesh_destroy(handle);
}
