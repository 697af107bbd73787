// SPDX-License-Identifier: MIT
// Points are taken out: the tetrahedra are those of a triangulation of the others alone.
#include <algorithm>
#include <cstring>
#include <new>

#include "core/removal_budget.hpp"
#include "histories.hpp"

namespace mgdt {
namespace {

using namespace histories;

class Removal : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override {
        if (!find_kernel(GetParam())) GTEST_SKIP() << "not on this processor";
    }
};

TEST_P(Removal, OneByOneDownToNothing) {
    Random random(1);
    for (const bool compact : {false, true})
        for (const Points& xyz : sets(random)) {
            const auto t = empty();
            t->set_kernel(*find_kernel(GetParam()));
            t->set_compact(compact);
            if (compact) t->hooks().large_link = 4;
            insert(*t, xyz);
            std::vector<std::uint32_t> order(xyz.size() / 3);
            for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
            std::shuffle(order.begin(), order.end(), random);
            for (std::size_t i = 0; i < order.size(); ++i) {
                remove(*t, {order[i]});
                if (order.size() - i < 12 || i % (is_smallest() ? 150
                                                  : is_small()  ? 40
                                                                : 10) ==
                                                 0) {
                    expect_as_fresh(*t, xyz);
                } else {
                    ASSERT_EQ(complaint(*t), "") << i;
                }
                if (HasFatalFailure()) return;
            }
            EXPECT_EQ(t->dimension(), -1);
            EXPECT_EQ(t->vertex_count(), 0u);
        }
}

TEST_P(Removal, BatchesAndInsertionsInTurns) {
    Random random(2);
    for (const std::size_t share : {0u, 16u})
        for (const Points& set : sets(random)) {
            const auto t = empty();
            t->hooks().vertices_per_rebuild = share;
            if (share != 0) t->hooks().large_link = 5;
            t->set_kernel(*find_kernel(GetParam()));
            Points xyz;
            for (std::size_t round = 0; round < 6; ++round) {
                insert(*t, set);
                xyz.insert(xyz.end(), set.begin(), set.end());
                std::vector<std::uint32_t> in = points_in(*t);
                std::shuffle(in.begin(), in.end(), random);
                in.resize(in.size() * (round + 1) / 6);
                remove(*t, in);
                expect_as_fresh(*t, xyz);
                if (HasFatalFailure()) return;
            }
        }
}

// Of each facet of a triangulation, seen from each side, with all its vertices as the link: the
// apex is the vertex opposite, or infinity, or left open; the last seldom where there are no ties.
TEST_P(Removal, ApexOfAFacet) {
    Random random(3);
    const Kernel& kernel = *find_kernel(GetParam());
    std::vector<Points> all = sets(random);
    const std::size_t with_ties = all.size();
    for (const std::size_t n : {4u, 5u, 6u, 7u, 8u, 9u, 16u, 33u})
        all.push_back(uniform_points(n, random));
    for (std::size_t set = 0; set < all.size(); ++set) {
        const auto t = empty();
        insert(*t, all[set]);
        const Mesh& mesh = t->mesh();
        if (mesh.has_extremes) continue;
        const std::size_t n = mesh.vertices.size(), size = (n + 3) / 4 * 4;
        if (size > HoleColumns::most) continue;
        Buffer<double> columns(t->allocator(), 3 * size);
        double *const x = columns.data(), *const y = x + size, *const z = y + size;
        HoleColumns vertices = {x, y, z, size, {}};
        for (std::size_t v = 0; v < size; ++v) {
            const bool is_skipped = v == infinite_vertex || v >= n;
            const double* const p = mesh.point(is_skipped ? 0 : static_cast<VertexId>(v));
            const double none = std::numeric_limits<double>::quiet_NaN();
            x[v] = is_skipped ? none : p[0];
            y[v] = is_skipped ? none : p[1];
            z[v] = is_skipped ? none : p[2];
            if (is_skipped) vertices.skipped[v / 64] |= std::uint64_t{1} << (v % 64);
        }
        std::size_t decided = 0, facets = 0;
        for (TetId id = 0; id < mesh.tetrahedra.size(); ++id) {
            const Tetrahedron& record = mesh.tetrahedra[id];
            if (record.is_dead()) continue;
            for (unsigned face = 0; face < 4; ++face) {
                if (record.is_ghost() && record.v[face] != infinite_vertex) continue;
                const unsigned char* const corner = outer_face[face];
                // (apex, a, b, c) is positively oriented.
                const std::uint32_t facet[3] = {record.v[corner[0]], record.v[corner[2]],
                                                record.v[corner[1]]};
                const ApexResult found = kernel.find_apex(vertices, facet);
                ++facets;
                if (found.number == no_apex) continue;
                ++decided;
                const VertexId apex = record.v[face];
                ASSERT_EQ(found.number, apex == infinite_vertex ? infinite_apex : apex);
                if (apex == infinite_vertex) continue;
                const Power own =
                    power(found.sphere, mesh.point(facet[0]), Query(mesh.point(apex)));
                EXPECT_FALSE(own.is_decided()) << own.value;
            }
        }
        if (std::strcmp(GetParam(), "baseline") != 0 && set >= with_ties) {
            EXPECT_GT(decided, facets * 9 / 10) << facets;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Each, Removal, testing::Values("baseline", "avx2", "avx512", "neon"),
                         [](const auto& info) { return std::string(info.param); });

TEST(RemovalAndThreads, InsertAfterRemoval) {
    Random random(3);
    const Points first = uniform_points(3000, random), second = uniform_points(6000, random);
    const auto t = empty(4);
    t->hooks().min_points_per_thread = 64;
    t->hooks().vertices_per_rebuild = 0;
    insert(*t, first);
    std::vector<std::uint32_t> some;
    for (std::uint32_t i = 0; i < 3000; i += 3) some.push_back(i);
    remove(*t, some);
    EXPECT_FALSE(t->mesh().guards_agree);
    insert(*t, second);
    EXPECT_TRUE(t->mesh().guards_agree);
    Points xyz = first;
    xyz.insert(xyz.end(), second.begin(), second.end());
    expect_as_fresh(*t, xyz);
}

// The hole of a vertex that all others are around, on the hull and inside it.
TEST(RemovalOfHub, CentreOfASphere) {
    Random random(4);
    const std::size_t n = is_smallest() ? 200 : is_small() ? 500 : 10000;
    for (const bool is_closed : {false, true}) {
        Points xyz = sphere(n, random, true);
        if (!is_closed)
            for (std::size_t i = 0; i < n; ++i) xyz[3 * i + 2] = std::abs(xyz[3 * i + 2]);
        const auto t = empty();
        t->hooks().vertices_per_rebuild = 0;
        insert(*t, xyz);
        const auto centre = static_cast<std::uint32_t>(n);
        remove(*t, {centre});
        EXPECT_GT(t->statistics().link_vertices, n * 9 / 10);
        expect_as_fresh(*t, xyz);
        insert(*t, {0, 0, 0});
        xyz.insert(xyz.end(), {0, 0, 0});
        // Moves that are made and that are not: a point is there already.
        for (const std::size_t to : {n, std::size_t{7}}) {
            Points place(&xyz[3 * to], &xyz[3 * to] + 3);
            if (to == n) place[0] = 0.125;
            move(*t, {centre + 1}, place);
            std::copy_n(place.data(), 3, &xyz[3 * (n + 1)]);
            expect_as_fresh(*t, xyz);
            if (HasFatalFailure()) return;
        }
    }
}

// A cone over a regular polygon: without its apex the link is flat, and so are all.
TEST(RemovalOfHub, ApexOverAPlane) {
    Points xyz;
    for (int i = 0; i < 300; ++i)
        xyz.insert(xyz.end(), {std::cos(i * 0.02), std::sin(i * 0.02), 0.0});
    xyz.insert(xyz.end(), {0, 0, 1, 0, 0, -1});
    const auto t = empty();
    insert(*t, xyz);
    remove(*t, {300});
    EXPECT_EQ(t->dimension(), 3);
    expect_as_fresh(*t, xyz);
    remove(*t, {301});
    EXPECT_EQ(t->dimension(), 2);
    expect_as_fresh(*t, xyz);
}

// All points are around each other: links as large as the set, each of which takes as long as all.
Points moment_curve(int n) {
    Points xyz;
    for (double i = 1; i <= n; ++i) xyz.insert(xyz.end(), {i, i * i, i * i * i});
    return xyz;
}

TEST(RemovalOfHubs, TriangulatesTheOthersAnew) {
    const int n = is_small() ? 200 : 400;
    const Points xyz = moment_curve(n);
    for (const bool moves : {false, true}) {
        const auto t = empty();
        insert(*t, xyz);
        std::vector<std::uint32_t> points;
        Points places, expected = xyz;
        for (std::uint32_t i = 3; i < static_cast<std::uint32_t>(n); i += 20) {
            points.push_back(i);
            for (std::size_t k = 3 * i; k < 3 * i + 3; ++k) {
                places.push_back(xyz[k] * 1.125);
                expected[k] = places.back();
            }
        }
        if (moves)
            move(*t, points, places);
        else
            remove(*t, points);
        EXPECT_EQ(t->statistics().rebuilds, 1u);
        EXPECT_LT(t->statistics().link_vertices, 4u * static_cast<unsigned>(n));
        expect_as_fresh(*t, moves ? expected : xyz);
    }
}

// Where there is no memory for that they go one by one.
TEST(RemovalOfHubs, IsPossibleInLittleMemory) {
    LimitedBlocks blocks{1000000};
    const Points xyz = moment_curve(150);
    Triangulation t(LimitedBlocks::take, LimitedBlocks::give_back, &blocks);
    insert(t, xyz);
    t.hooks().large_link = 1000;
    Buffer<std::uint32_t> points(t.allocator());
    points.reserve(8);
    for (std::uint32_t i = 0; i < 8; ++i) points.push_back(10 * i);
    t.allocator().set_limit(t.allocator().bytes() + t.allocator().bytes() / 4);
    t.remove(points);
    EXPECT_EQ(t.statistics().rebuilds, 0u);
    t.allocator().set_limit(0);
    expect_as_fresh(t, xyz);
}

TEST(RemovalBudgets, EndNearTheTimeOfARebuild) {
    // A tenth of uniform points stays below, single points always do.
    RemovalBudget uniform(67000, 10000);
    for (std::size_t left = 1000; left > 0; --left) {
        EXPECT_FALSE(uniform.is_exceeded_by(16, false, left));
        uniform.add(16, 0);
    }
    EXPECT_FALSE(RemovalBudget(20, 10).is_exceeded_by(9, false, 1));
    // A large part of all points around each of several: at once; around one: that is removed.
    EXPECT_TRUE(RemovalBudget(500000, 1000).is_exceeded_by(990, true, 50));
    EXPECT_FALSE(RemovalBudget(500000, 1000).is_exceeded_by(990, true, 1));
    // Links that turn out to be costly.
    RemovalBudget helix(1000000, 10000);
    std::size_t removed = 0;
    while (!helix.is_exceeded_by(300, true, 1000)) helix.add(300, 50000), ++removed;
    EXPECT_GT(removed, 5u);
    EXPECT_LT(removed, 30u);
}

// As an allocator: asks for a stop when the coordinates of a large link are copied.
struct StopAtLargeBlock {
    static inline Triangulation* asks = nullptr;
    static void* take(std::size_t size, std::size_t align, void* user) {
        if (asks && size > 70000) asks->stop().set();
        return LimitedBlocks::take(size, align, user);
    }
};

TEST(RemovalOfHub, StopsWhileTheLinkIsTriangulated) {
    Random random(14);
    const Points xyz = sphere(3000, random, true);
    LimitedBlocks blocks{1000000};
    Triangulation t(StopAtLargeBlock::take, LimitedBlocks::give_back, &blocks);
    insert(t, xyz);
    StopAtLargeBlock::asks = &t;
    std::string message;
    try {
        remove(t, {3000});
    } catch (const Error& error) {
        EXPECT_EQ(error.status, MGDT_ERR_CANCELLED);
        message = error.message;
    }
    StopAtLargeBlock::asks = nullptr;
    EXPECT_EQ(message, "cancelled after 0 of 1 points");
    expect_as_fresh(t, xyz);
    remove(t, {3000});
    expect_as_fresh(t, xyz);
}

TEST(RemovalAndProgress, WhatWasDoneBeforeACancellationStays) {
    Random random(6);
    const Points xyz = uniform_points(400, random);
    const auto t = empty();
    t->hooks().vertices_per_rebuild = 0;
    insert(*t, xyz);
    t->settings().progress = [](double fraction, void*) -> std::int32_t { return fraction >= 0.5; };
    std::vector<std::uint32_t> points;
    for (std::uint32_t i = 0; i < 200; ++i) points.push_back(i);
    try {
        remove(*t, points);
        ADD_FAILURE() << "not cancelled";
    } catch (const Error& error) {
        EXPECT_EQ(error.status, MGDT_ERR_CANCELLED);
        EXPECT_STREQ(error.message, "cancelled after 100 of 200 points");
    }
    EXPECT_EQ(t->vertex_count(), 300u);
    expect_as_fresh(*t, xyz);
}

// Each allocation fails in turn: the points before are out, the others are in.
TEST(RemovalWithoutMemory, LeavesATriangulation) {
    Random random(7);
    Points xyz = sphere(60, random, true);
    xyz.insert(xyz.end(), xyz.begin(), xyz.begin() + 30);  // repeats
    bool is_done = false;
    std::size_t failures = 0;
    for (std::size_t allowed = 0; !is_done; ++allowed) {
        LimitedBlocks blocks{1000000};
        Triangulation t(LimitedBlocks::take, LimitedBlocks::give_back, &blocks);
        t.hooks().large_link = 20;
        insert(t, xyz);
        Buffer<std::uint32_t> points(t.allocator());
        points.reserve(40);
        for (std::uint32_t i = 30; i < 70; ++i) points.push_back(i);
        std::string message;
        blocks.refuse_after(allowed);
        try {
            t.remove(points);
            is_done = true;
        } catch (const std::bad_alloc&) {
            ++failures;
        } catch (const Error& error) {
            ASSERT_EQ(error.status, MGDT_ERR_OUT_OF_MEMORY);
            message = error.message;
            ++failures;
        }
        blocks.refuse_after(1000000);
        std::size_t out = 0;
        for (const std::uint32_t i : points) out += t.point_map()[i] == infinite_vertex;
        ASSERT_EQ(out == 40, is_done);
        if (!message.empty()) {
            EXPECT_EQ(message, "out of memory after " + std::to_string(out) + " of 40 points");
        }
        expect_as_fresh(t, xyz);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(failures, 10u);
}

// Many at once are left out of a new triangulation. A request to stop, or a lack of memory for it,
// undoes that.
TEST(RemovalByRebuild, IsAllOrNothing) {
    Random random(8);
    const Points xyz = uniform_points(400, random);
    std::vector<std::uint32_t> points;
    for (std::uint32_t i = 0; i < 200; ++i) points.push_back(2 * i);
    const auto t = empty();
    insert(*t, xyz);
    t->settings().progress = [](double fraction, void*) -> std::int32_t { return fraction >= 0.5; };
    try {
        remove(*t, points);
        ADD_FAILURE() << "not cancelled";
    } catch (const Error& error) {
        EXPECT_EQ(error.status, MGDT_ERR_CANCELLED);
        EXPECT_STREQ(error.message, "cancelled after 0 of 200 points");
    }
    EXPECT_EQ(t->vertex_count(), 400u);
    expect_as_fresh(*t, xyz);
    t->settings().progress = nullptr;
    // Enough for the list of points alone.
    t->allocator().set_limit(t->allocator().bytes() + 40000);
    remove(*t, points);
    t->allocator().set_limit(0);
    EXPECT_EQ(t->statistics().rebuilds, 0u);
    EXPECT_EQ(t->vertex_count(), 200u);
    expect_as_fresh(*t, xyz);
    insert(*t, xyz);
    points.clear();
    for (std::uint32_t i = 400; i < 600; ++i) points.push_back(i);
    remove(*t, points);
    EXPECT_EQ(t->statistics().rebuilds, 1u);
    EXPECT_EQ(t->statistics().removed, 400u);
    Points both = xyz;
    both.insert(both.end(), xyz.begin(), xyz.end());
    expect_as_fresh(*t, both);
}

TEST(AbsentPoints, AreForgottenAndTheOthersKeepTheirOrder) {
    Random random(9);
    for (const Points& set : sets(random)) {
        const auto t = empty();
        insert(*t, set);
        insert(*t, set);
        std::vector<std::uint32_t> leaving = points_in(*t);
        std::shuffle(leaving.begin(), leaving.end(), random);
        leaving.resize(leaving.size() / 2);
        remove(*t, leaving);
        Points rest;
        for (const std::uint32_t i : points_in(*t))
            for (std::size_t k = 0; k < 3; ++k) rest.push_back(set[(3 * i + k) % set.size()]);
        t->forget_absent_points();
        EXPECT_EQ(t->point_map().size(), rest.size() / 3);
        EXPECT_EQ(points_in(*t).size(), rest.size() / 3);
        expect_as_fresh(*t, rest);
        insert(*t, set);
        rest.insert(rest.end(), set.begin(), set.end());
        expect_as_fresh(*t, rest);
        if (HasFatalFailure()) return;
    }
}

TEST(AbsentPoints, OfAnInsertionThatWasStopped) {
    const auto t = empty();
    insert(*t, {0, 0, 0});
    t->stop().set();
    EXPECT_THROW(insert(*t, {1e5, 1e-5, 3}), Error);
    EXPECT_EQ(t->point_map().size(), 2u);
    t->forget_absent_points();
    EXPECT_EQ(t->point_map().size(), 1u);
    expect_as_fresh(*t, {0, 0, 0});
}

TEST(RemovalArguments, AreRefusedWithTheirIndex) {
    Random random(5);
    const Points xyz = uniform_points(20, random);
    const auto t = empty();
    insert(*t, xyz);
    t->settings().index_base = 1;
    const auto message = [&](const std::vector<std::uint32_t>& points) -> std::string {
        try {
            remove(*t, points);
        } catch (const Error& error) {
            EXPECT_EQ(error.status, MGDT_ERR_INVALID_ARGUMENT);
            return error.message;
        }
        return {};
    };
    EXPECT_EQ(message({3, 20}), "there is no point 21: 20 were given, counted from 1");
    EXPECT_EQ(message({3, 4, 3}), "point 4 is to be removed twice");
    EXPECT_EQ(t->vertex_count(), 20u);
    EXPECT_EQ(message({3}), "");
    EXPECT_EQ(message({5, 3}), "point 4 is not in the triangulation");
    EXPECT_EQ(t->vertex_count(), 19u);
    expect_as_fresh(*t, xyz);
}

}  // namespace
}  // namespace mgdt
