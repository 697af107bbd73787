// SPDX-License-Identifier: MIT
// Points are taken out: the tetrahedra are those of a triangulation of the others alone.
#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <set>

#include "surgery.hpp"

namespace mgdt {
namespace {

using namespace surgery;

std::unique_ptr<Triangulation> empty(unsigned threads = 1) {
    auto t = std::make_unique<Triangulation>(nullptr, nullptr, nullptr);
    t->settings().threads = static_cast<std::int32_t>(threads);
    return t;
}

void insert(Triangulation& t, const Points& xyz) {
    const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
    t.insert(xyz.size() / 3, axis, 3);
}

void remove(Triangulation& t, const std::vector<std::uint32_t>& points) {
    Buffer<std::uint32_t> list(t.allocator());
    list.reserve(points.size());
    for (const std::uint32_t i : points) list.push_back(i);
    t.remove(list);
}

std::string complaint(const Triangulation& t, int level = 3) {
    Team team;
    try {
        check_triangulation(team, t.check_input(), t.allocator(), level, 0);
        return {};
    } catch (const Error& error) {
        return error.message;
    }
}

// The tetrahedra by the caller's indices, each from its least one on, in order.
std::set<std::array<std::uint32_t, 4>> tetrahedra(const Triangulation& t) {
    std::set<std::array<std::uint32_t, 4>> all;
    for (TetId id = 0; id < t.mesh().tetrahedra.size(); ++id) {
        const Tetrahedron& record = t.mesh().tetrahedra[id];
        if (record.is_dead() || record.is_ghost()) continue;
        std::array<std::uint32_t, 4> v;
        for (unsigned i = 0; i < 4; ++i) v[i] = t.mesh().vertices[record.v[i]].index;
        std::sort(v.begin(), v.end());
        all.insert(v);
    }
    return all;
}

// The triangulation of the points that are in, given with the others left out.
void expect_as_fresh(const Triangulation& t, const Points& xyz) {
    ASSERT_EQ(complaint(t), "");
    Points rest;
    std::vector<std::uint32_t> index;
    for (std::uint32_t i = 0; i < t.point_map().size(); ++i) {
        if (t.point_map()[i] == infinite_vertex) continue;
        rest.insert(rest.end(), xyz.begin() + 3 * i, xyz.begin() + 3 * i + 3);
        index.push_back(i);
    }
    const auto fresh = empty();
    insert(*fresh, rest);
    EXPECT_EQ(t.dimension(), fresh->dimension());
    EXPECT_EQ(t.vertex_count(), fresh->vertex_count());
    EXPECT_EQ(t.statistics().duplicates, fresh->statistics().duplicates);
    std::set<std::array<std::uint32_t, 4>> expected;
    for (std::array<std::uint32_t, 4> v : tetrahedra(*fresh)) {
        for (std::uint32_t& i : v) i = index[i];
        expected.insert(v);
    }
    EXPECT_EQ(tetrahedra(t), expected);
}

Points sphere(std::size_t n, Random& random, bool with_centre) {
    Points xyz;
    for (std::size_t i = 0; i < n; ++i) {
        double p[3], square = 0;
        for (double& x : p) x = uniform(random) - 0.5;
        for (const double x : p) square += x * x;
        for (const double x : p) xyz.push_back(x / std::sqrt(square));
    }
    if (with_centre) xyz.insert(xyz.end(), {0, 0, 0});
    return xyz;
}

// Ties everywhere, repeats, points in a plane, coordinates that no filter is proved for.
std::vector<Points> sets(Random& random) {
    std::vector<Points> all = {uniform_points(300, random), lattice(6), sphere(150, random, true)};
    Points repeats = lattice(3), flat = uniform_points(60, random),
           tiny = uniform_points(80, random);
    for (std::size_t i = 0; i < 40; ++i)
        for (std::size_t k = 0; k < 3; ++k) repeats.push_back(repeats[3 * (i % 27) + k]);
    for (std::size_t i = 0; i < 55; ++i) flat[3 * i + 2] = 0.25;
    for (std::size_t i = 0; i < tiny.size(); ++i) tiny[i] *= i % 7 == 0 ? 1e-170 : 1e-160;
    Points mixed = uniform_points(100, random);
    for (std::size_t i = 0; i < 3 * 20; ++i) mixed[i] *= 1e200;
    all.insert(all.end(), {repeats, flat, tiny, mixed});
    return all;
}

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
            insert(*t, xyz);
            std::vector<std::uint32_t> order(xyz.size() / 3);
            for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
            std::shuffle(order.begin(), order.end(), random);
            for (std::size_t i = 0; i < order.size(); ++i) {
                remove(*t, {order[i]});
                if (order.size() - i < 12 || i % 10 == 0) {
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
    for (const Points& set : sets(random)) {
        const auto t = empty();
        t->set_kernel(*find_kernel(GetParam()));
        Points xyz;
        for (std::size_t round = 0; round < 6; ++round) {
            insert(*t, set);
            xyz.insert(xyz.end(), set.begin(), set.end());
            std::vector<std::uint32_t> in;
            for (std::uint32_t i = 0; i < t->point_map().size(); ++i)
                if (t->point_map()[i] != infinite_vertex) in.push_back(i);
            std::shuffle(in.begin(), in.end(), random);
            in.resize(in.size() * (round + 1) / 6);
            remove(*t, in);
            expect_as_fresh(*t, xyz);
            if (HasFatalFailure()) return;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Each, Removal, testing::Values("baseline", "avx2", "avx512"),
                         [](const auto& info) { return std::string(info.param); });

TEST(RemovalAndThreads, InsertAfterRemoval) {
    Random random(3);
    const Points first = uniform_points(3000, random), second = uniform_points(6000, random);
    const auto t = empty(4);
    t->settings().points_a_thread = 64;
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

TEST(RemovalOfHub, CentreOfASphere) {
    Random random(4);
    const Points xyz = sphere(is_small() ? 500 : 3000, random, true);
    const auto t = empty();
    insert(*t, xyz);
    remove(*t, {static_cast<std::uint32_t>(xyz.size() / 3 - 1)});
    expect_as_fresh(*t, xyz);
}

TEST(RemovalAndProgress, WhatWasDoneBeforeACancellationStays) {
    Random random(6);
    const Points xyz = uniform_points(400, random);
    const auto t = empty();
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
    static std::size_t left;
    const auto alloc = [](std::size_t size, std::size_t align, void*) -> void* {
        if (left == 0) return nullptr;
        --left;
        return ::operator new(size, std::align_val_t(align), std::nothrow);
    };
    const auto release = [](void* p, std::size_t, std::size_t align, void*) {
        ::operator delete(p, std::align_val_t(align));
    };
    Random random(7);
    Points xyz = sphere(60, random, true);
    xyz.insert(xyz.end(), xyz.begin(), xyz.begin() + 30);  // repeats
    bool is_done = false;
    std::size_t failures = 0;
    for (std::size_t allowed = 0; !is_done; ++allowed) {
        left = 1000000;
        Triangulation t(alloc, release, nullptr);
        insert(t, xyz);
        Buffer<std::uint32_t> points(t.allocator());
        points.reserve(40);
        for (std::uint32_t i = 30; i < 70; ++i) points.push_back(i);
        left = allowed;
        try {
            t.remove(points);
            is_done = true;
        } catch (const std::bad_alloc&) {
            ++failures;
        }
        left = 1000000;
        std::size_t out = 0;
        while (out < 40 && t.point_map()[points[out]] == infinite_vertex) ++out;
        for (std::size_t i = out; i < 40; ++i)
            ASSERT_NE(t.point_map()[points[i]], infinite_vertex) << allowed << ' ' << i;
        expect_as_fresh(t, xyz);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(failures, 10u);
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
    EXPECT_EQ(message({3, 20}), "there is no point 21: 20 were given");
    EXPECT_EQ(message({3, 4, 3}), "point 4 is to be removed twice");
    EXPECT_EQ(t->vertex_count(), 20u);
    EXPECT_EQ(message({3}), "");
    EXPECT_EQ(message({5, 3}), "point 4 is not in the triangulation");
    EXPECT_EQ(t->vertex_count(), 19u);
    expect_as_fresh(*t, xyz);
}

}  // namespace
}  // namespace mgdt
