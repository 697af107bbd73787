// SPDX-License-Identifier: MIT
// Insertion by several threads: whatever they meet, the tetrahedra are those of one thread.
// The sets are tiny and a thread gets a point or two, so that threads meet all the time; yields
// where blocks are taken and given back move the meetings about.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <random>
#include <thread>
#include <vector>

#include "../support/aligned.h"
#include "../support/points.hpp"
#include "../support/schemes.hpp"
#include "../support/small.h"
#include "core/triangulation.hpp"
#include "platform/error.hpp"
#include "query/check.hpp"
#include "query/export.hpp"
#include "unwatched.hpp"

namespace mgdt {
namespace {

// Each thread yields at one call in so many, not the same ones in any two rounds.
std::atomic<unsigned> yield_one_in{0};
std::atomic<unsigned> pauses{0};
void pause() {
    const unsigned one_in = yield_one_in;
    if (one_in != 0 && pauses.fetch_add(1, std::memory_order_relaxed) % one_in == 0)
        std::this_thread::yield();
}

using mgdt_tests::Points;

// A few points whose coordinates are drawn from a few values, or from many.
Points random_points(std::mt19937_64& random, std::size_t n, unsigned values) {
    Points xyz(3 * n);
    for (double& x : xyz) x = static_cast<double>(random() % values);
    return xyz;
}

void insert(Triangulation& t, const Points& xyz) {
    const double* axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
    t.insert(xyz.size() / 3, axis, 3);
}

// The tetrahedra and the point map, the same for the same set of points.
std::vector<std::int64_t> outcome(const Triangulation& t) {
    std::vector<std::int64_t> all(4 * t.mesh().finite_count() + t.point_map().size());
    Allocator allocator;
    Team team;
    const Numbering numbering(allocator, t.mesh(), true, team);
    const MeshView view{team, t.mesh(), &numbering, allocator, 0, true};
    export_tetrahedra(view, all.data());
    export_point_map(view, t.point_map(), all.data() + 4 * t.mesh().finite_count());
    return all;
}

void expect_valid(const Triangulation& t) {
    Team team(2);
    try {
        check_triangulation(team, t.check_input(), t.allocator(), MGDT_CHECK_CANONICAL, 0,
                            Unwatched());
    } catch (const Error& error) {
        FAIL() << error.message;
    }
}

constexpr ZoneUse zone_uses[] = {ZoneUse::never, ZoneUse::where_few_meet, ZoneUse::always};

TEST(Zones, SameAsOneThread) {
    std::mt19937_64 random(20);
    const unsigned rounds = is_small() ? 60 : 4000;
    std::uint64_t met = 0;
    for (unsigned round = 0; round < rounds; ++round) {
        SCOPED_TRACE("round " + std::to_string(round));
        const std::size_t n = 20 + random() % (round % 16 == 0 ? 1500 : 150);
        static constexpr unsigned values[] = {3, 5, 17, 1000000};
        const Points xyz = random_points(random, n, values[random() % 4]);
        const std::int32_t scheme = order_schemes[round % order_schemes.size()];
        Triangulation alone(nullptr, nullptr, nullptr), together(nullptr, nullptr, nullptr);
        alone.settings().scheme = scheme;
        insert(alone, xyz);
        Settings& settings = together.settings();
        settings.scheme = scheme;
        settings.threads = static_cast<std::int32_t>(2 + random() % (round % 64 == 0 ? 30 : 7));
        TestHooks& hooks = together.hooks();
        hooks.min_points_per_thread = 1 + random() % 20;
        hooks.attempts_before_doubt = 1 + random() % 100;
        hooks.zones = zone_uses[random() % 3];
        hooks.pause = pause;
        yield_one_in = random() % 3 == 0 ? 0 : 1 + static_cast<unsigned>(random() % 9);
        // In one batch, or in two.
        const std::size_t split = round % 3 == 0 ? 3 * (random() % n) : 0;
        insert(together, Points(xyz.begin(), xyz.begin() + static_cast<std::ptrdiff_t>(split)));
        insert(together, Points(xyz.begin() + static_cast<std::ptrdiff_t>(split), xyz.end()));
        ASSERT_EQ(outcome(together), outcome(alone)) << mgdt_order_scheme_name(scheme);
        ASSERT_EQ(together.vertex_count(), alone.vertex_count());
        ASSERT_EQ(together.statistics().points_inserted, alone.statistics().points_inserted);
        ASSERT_EQ(together.statistics().duplicates, alone.statistics().duplicates);
        if (round % 8 == 0) expect_valid(together);
        met += together.statistics().deferred;
    }
    // The test is about threads that meet.
    EXPECT_GT(met, rounds);
}

// One vertex has an edge to most of the others, so that every cavity beside it needs the same few
// facets: an apex above a plane and one below, or the centre of a sphere.
TEST(Zones, ShareTheWorkAroundAHub) {
    std::mt19937_64 random(24);
    const std::size_t n = is_small() ? 1500 : 20000;
    std::normal_distribution<double> normal;
    for (const bool is_sphere : {false, true}) {
        SCOPED_TRACE(is_sphere ? "sphere" : "plane");
        Points xyz;
        for (std::size_t i = 0; i < n; ++i) {
            double p[3] = {normal(random), normal(random), is_sphere ? normal(random) : 0};
            const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
            for (const double x : p) xyz.push_back(is_sphere ? x / r : x);
        }
        if (is_sphere)
            xyz.insert(xyz.end(), {0, 0, 0});
        else
            xyz.insert(xyz.end(), {0, 0, 2, 0, 0, -2});
        Triangulation serial(nullptr, nullptr, nullptr), concurrent(nullptr, nullptr, nullptr);
        insert(serial, xyz);
        concurrent.settings().threads = 4;
        concurrent.hooks().min_points_per_thread = 16;
        concurrent.hooks().attempts_before_doubt = n;
        insert(concurrent, xyz);
        ASSERT_EQ(outcome(concurrent), outcome(serial));
        // Neither do the threads leave the points to one of them, nor does the hub come so late
        // that what was built without it is removed again. On few points, or where a tool runs one
        // thread at a time, the meetings tell nothing.
        if (is_small()) continue;
        EXPECT_LT(concurrent.statistics().inserted_alone, n / 4);
        const auto tested = [](const Triangulation& t) {
            return static_cast<double>(t.counters().conflict_tests);
        };
        EXPECT_LT(tested(concurrent), 2 * tested(serial));
    }
}

// Each of the points given last is mapped to the vertex at its place.
void expect_places(const Triangulation& t, const Points& xyz) {
    const std::size_t n = xyz.size() / 3, first = t.point_map().size() - n;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            ASSERT_EQ(t.mesh().point(t.point_map()[first + i])[k],
                      std::ldexp(xyz[3 * i + k], t.mesh().scale))
                << i;
}

// Where repeats are few, the last vertices take their places one by one; where many, in a turn
// through all tetrahedra. The second batch repeats points of the first too. The smallest ones are
// scaled.
TEST(Zones, RepeatsLeaveNoGaps) {
    std::mt19937_64 random(25);
    const std::size_t n = is_small() ? 3000 : 30000;
    for (const unsigned values : {1000000u, 40u}) {
        Points xyz = random_points(random, n, values);
        for (int i = 0; i < 8; ++i)
            std::copy_n(&xyz[3 * (random() % n)], 3, &xyz[3 * (random() % n)]);
        for (double& x : xyz) x *= values == 40 ? 1 : 0x1p-300;
        const auto middle = xyz.begin() + static_cast<std::ptrdiff_t>(3 * (n / 3));
        Triangulation expected(nullptr, nullptr, nullptr);
        insert(expected, xyz);
        for (const bool is_compact : {false, true})
            for (const std::int32_t threads : {1, 3}) {
                Triangulation t(nullptr, nullptr, nullptr);
                t.set_compact(is_compact);
                t.settings().threads = threads;
                t.hooks().min_points_per_thread = 100;
                t.hooks().zones = is_compact ? ZoneUse::where_few_meet : ZoneUse::always;
                insert(t, Points(xyz.begin(), middle));
                insert(t, Points(middle, xyz.end()));
                ASSERT_GT(t.statistics().duplicates, 0u);
                ASSERT_EQ(outcome(t), outcome(expected));
                expect_places(t, xyz);
                expect_valid(t);
            }
    }
}

// Two skew lines have n^2 tetrahedra; a point between them digs a cavity larger than a thread has
// room for at first, while others insert at other such pairs.
TEST(Zones, LargeCavities) {
    std::mt19937_64 random(24);
    const unsigned rounds = is_small() ? 1 : 6;
    for (unsigned round = 0; round < rounds; ++round) {
        Points lines, between;
        for (int pair = 0; pair < 40; ++pair) {
            const double x = 200 * (pair % 7), y = 200 * (pair / 7);
            // One of the cavities has more vertices than the matrices of stars.
            const int n = pair == 0 && !is_small() ? 140 : 24;
            for (int i = 0; i < n; ++i) {
                const double place = 24.0 * i / n;
                lines.insert(lines.end(), {x + place - 11.7, y, -8});
                lines.insert(lines.end(), {x, y + place - 11.3, 8});
            }
            const Points off = random_points(random, 1, 1000);
            between.insert(between.end(), {x + off[0] / 1000, y + off[1] / 1000, off[2] / 1000});
        }
        Triangulation alone(nullptr, nullptr, nullptr), together(nullptr, nullptr, nullptr);
        together.settings().threads = 2 + static_cast<std::int32_t>(round % 3);
        together.hooks().min_points_per_thread = 10;
        together.hooks().max_tetrahedra_per_vertex = 1000000;
        together.hooks().zones = zone_uses[round % 3];
        for (Triangulation* t : {&alone, &together}) {
            insert(*t, lines);
            insert(*t, between);
        }
        ASSERT_EQ(outcome(together), outcome(alone));
        expect_valid(together);
    }
}

// Every point of an axis is joined to all of a ring: threads want the same tetrahedra, stop, and
// compare with one alone, many times.
TEST(Zones, ThreadsInEachOthersWay) {
    const int on_axis = is_small() ? 300 : 4000;
    Points xyz;
    for (int i = 0; i < on_axis; ++i) xyz.insert(xyz.end(), {0, 0, 1e-3 * i - 1e-7 * i * i});
    for (int i = 0; i < 40; ++i)
        xyz.insert(xyz.end(), {100 * std::cos(0.157 * i), 100 * std::sin(0.157 * i), 1e-3 * i});
    Triangulation alone(nullptr, nullptr, nullptr);
    insert(alone, xyz);
    for (const ZoneUse use : zone_uses)
        for (const std::size_t share : {1u, 8u, 64u}) {
            Triangulation together(nullptr, nullptr, nullptr);
            together.settings().threads = 4;
            together.hooks().min_points_per_thread = share;
            together.hooks().attempts_before_doubt = share;
            together.hooks().max_tetrahedra_per_vertex = 1000000;
            together.hooks().zones = use;
            insert(together, xyz);
            ASSERT_EQ(outcome(together), outcome(alone)) << share;
            expect_valid(together);
        }
}

// The storage has to grow while threads insert, many times.
TEST(Zones, StorageGrows) {
    std::mt19937_64 random(21);
    const std::size_t n = is_small() ? 400 : 3000;
    // On the moment curve every two neighbours are joined to all others: n^2 / 2 tetrahedra.
    Points xyz;
    for (std::size_t i = 0; i < n / 4; ++i) {
        const double x = static_cast<double>(i);
        for (const double c : {x, x * x, x * x * x}) xyz.push_back(c);
    }
    Triangulation alone(nullptr, nullptr, nullptr);
    insert(alone, xyz);
    for (const ZoneUse use : zone_uses) {
        Triangulation together(nullptr, nullptr, nullptr);
        together.settings().threads = 4;
        together.hooks().min_points_per_thread = 8;
        together.hooks().max_tetrahedra_per_vertex = 1000000;
        together.hooks().zones = use;
        insert(together, xyz);
        EXPECT_EQ(outcome(together), outcome(alone));
        expect_valid(together);
    }
}

// Each two neighbours on the curve are joined to all others: threads would only wait.
TEST(Zones, LongTetrahedraAreLeftToOneThread) {
    Points xyz;
    for (int i = 0; i < 400; ++i)
        for (const int c : {i, i * i, i * i * i}) xyz.push_back(c);
    Triangulation t(nullptr, nullptr, nullptr);
    t.settings().threads = 4;
    t.hooks().min_points_per_thread = 8;
    insert(t, xyz);
    EXPECT_GE(t.statistics().inserted_alone, 300u);  // the last round
    expect_valid(t);
}

// Most points are where others are, so that threads would meet at the same few tetrahedra.
TEST(Zones, FewPlacesAreLeftToOneThread) {
    std::mt19937_64 random(25);
    Points xyz;
    for (int i = 0; i < 3 * 20000; ++i) xyz.push_back(static_cast<double>(random() % 3));
    Triangulation t(nullptr, nullptr, nullptr);
    t.settings().threads = 4;
    t.hooks().min_points_per_thread = 1000;
    insert(t, xyz);
    EXPECT_EQ(t.statistics().deferred, 0u);
    EXPECT_GE(t.statistics().inserted_alone, 19000u);
    expect_valid(t);
}

// Cancelled or out of memory, at any moment: a valid triangulation of the points that got in, and
// the rest can be given again.
void expect_rest_can_follow(Triangulation& t, const Points& xyz) {
    expect_valid(t);
    std::size_t in = 0;
    for (const VertexId v : t.point_map()) in += v != infinite_vertex;
    EXPECT_EQ(in, t.statistics().points_inserted + t.statistics().duplicates);
    Triangulation alone(nullptr, nullptr, nullptr);
    insert(alone, xyz);
    insert(t, xyz);
    EXPECT_EQ(t.vertex_count(), alone.vertex_count());
    EXPECT_EQ(t.mesh().finite_count(), alone.mesh().finite_count());
    expect_valid(t);
    expect_places(t, xyz);
}

void settle_for_threads(Triangulation& t, std::int32_t threads) {
    t.settings().threads = threads;
    t.hooks().min_points_per_thread = 16;
}

TEST(Zones, Cancelled) {
    std::mt19937_64 random(22);
    Points xyz = random_points(random, is_small() ? 600 : 4000, 1000000);
    std::copy_n(&xyz[0], 3, &xyz[3 * 500]);
    for (int stop = 1; stop < 100; stop += is_small() ? 40 : 4) {
        SCOPED_TRACE(stop);
        Triangulation t(nullptr, nullptr, nullptr);
        settle_for_threads(t, 4);
        t.hooks().zones = stop % 8 == 1 ? ZoneUse::always : ZoneUse::never;
        struct Count {
            int left;
            std::thread::id caller;
            bool is_elsewhere;
        } count{stop, std::this_thread::get_id(), false};
        t.settings().progress_user = &count;
        t.settings().progress = [](double, void* user) -> std::int32_t {
            Count& c = *static_cast<Count*>(user);
            c.is_elsewhere = c.is_elsewhere || std::this_thread::get_id() != c.caller;
            return --c.left == 0;
        };
        mgdt_status status = MGDT_OK;
        try {
            insert(t, xyz);
        } catch (const Error& error) {
            status = error.status;
        }
        // A request that comes with the last report has nothing to stop.
        EXPECT_TRUE(status == MGDT_ERR_CANCELLED || count.left >= 0);
        EXPECT_FALSE(count.is_elsewhere);
        t.settings().progress = nullptr;
        expect_rest_can_follow(t, xyz);
    }
}

// Every allocation after the k-th fails, for k = 1, 2, ... until none is left to fail.
std::atomic<long> allocations_left{0};
void* scarce(std::size_t size, std::size_t align, void*) {
    if (allocations_left.fetch_sub(1) <= 0) return nullptr;
    return allocate_aligned(size, align);
}
void give_back(void* p, std::size_t, std::size_t, void*) {
    free_aligned(p);
}

// Lets that happen while xyz is inserted upon what is there.
void expect_to_survive_scarcity(const Points& there, const Points& xyz, ZoneUse zones) {
    Points all = there;
    all.insert(all.end(), xyz.begin(), xyz.end());
    bool is_done = false;
    for (long k = 0; !is_done; k += is_small() ? 9 : 1) {
        SCOPED_TRACE(k);
        ASSERT_LT(k, 100000);
        allocations_left = 1000000;
        Triangulation t(scarce, give_back, nullptr);
        settle_for_threads(t, 3);
        t.hooks().zones = zones;
        insert(t, there);
        allocations_left = k;
        try {
            insert(t, xyz);
            is_done = true;
        } catch (const std::bad_alloc&) {
        }
        allocations_left = 1000000;
        expect_rest_can_follow(t, all);
    }
}

TEST(Zones, OutOfMemory) {
    std::mt19937_64 random(23);
    const Points first = random_points(random, 40, 1000000);  // space is spanned before
    Points xyz = random_points(random, is_small() ? 200 : 800, 1000000);
    std::copy_n(&xyz[0], 3, &xyz[3 * (is_small() ? 100 : 400)]);
    expect_to_survive_scarcity(first, xyz, ZoneUse::where_few_meet);
}

// The batch that the mesh begins with, which zones are for.
TEST(Zones, OutOfMemoryInZones) {
    std::mt19937_64 random(26);
    const Points xyz = random_points(random, is_small() ? 200 : 800, 1000000);
    expect_to_survive_scarcity({}, xyz, ZoneUse::always);
}

// In each kernel the same as one thread: a lattice, whose conflicts are ties at the border of zones
// as well; points of which some are beyond the range in which the filters are proved.
TEST(Zones, TiesAndExtremes) {
    std::mt19937_64 random(27);
    Points lattice;
    const int n = is_small() ? 10 : 24;
    for (int x = 0; x < n; ++x)
        for (int y = 0; y < n; ++y)
            for (int z = 0; z < n; ++z)
                for (const int c : {x, y, z}) lattice.push_back(c);
    Points extremes = random_points(random, is_small() ? 1000 : 8000, 1000000);
    for (std::size_t i = 0; i < extremes.size(); i += 50) extremes[i] *= 0x1p-400;
    for (const Points& xyz : {lattice, extremes}) {
        Triangulation alone(nullptr, nullptr, nullptr);
        insert(alone, xyz);
        for (const char* isa : {"baseline", "avx2", "avx512", "neon"}) {
            const Kernel* const kernel = find_kernel(isa);
            if (!kernel) continue;
            for (const std::int32_t threads : {2, 3, 7}) {
                Triangulation t(nullptr, nullptr, nullptr);
                t.set_kernel(*kernel);
                settle_for_threads(t, threads);
                t.hooks().zones = ZoneUse::always;
                insert(t, xyz);
                EXPECT_EQ(outcome(t), outcome(alone)) << isa;
                expect_valid(t);
            }
        }
    }
}

// More threads than the system gives, than there are cores, than there are points.
TEST(Zones, ManyThreads) {
    std::mt19937_64 random(24);
    const Points xyz = random_points(random, 300, 1000);
    Triangulation alone(nullptr, nullptr, nullptr);
    insert(alone, xyz);
    for (const std::int32_t threads : {0, 16, 64, 254, 1000}) {
        if (is_small() && threads > 16 && threads < 1000) continue;
        Triangulation t(nullptr, nullptr, nullptr);
        t.settings().threads = threads;
        t.hooks().min_points_per_thread = 1;
        insert(t, xyz);
        EXPECT_EQ(outcome(t), outcome(alone));
        EXPECT_LE(t.statistics().threads, 254);
    }
}

}  // namespace
}  // namespace mgdt
