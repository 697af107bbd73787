// SPDX-License-Identifier: MIT
// Points move: the tetrahedra are those of a triangulation of the points where they are.
#include <algorithm>
#include <cstdio>
#include <limits>
#include <new>

#include "histories.hpp"

namespace mgdt {
namespace {

using namespace histories;

// Moves points and notes it in xyz.
void move_to(Triangulation& t, Points& xyz, const std::vector<std::uint32_t>& points,
             const Points& places) {
    move(t, points, places);
    for (std::size_t k = 0; k < points.size(); ++k)
        std::copy_n(&places[3 * k], 3, &xyz[3 * points[k]]);
}

class Motion : public testing::TestWithParam<const char*> {
  protected:
    void SetUp() override {
        if (!find_kernel(GetParam())) GTEST_SKIP() << "not on this processor";
    }
};

// A little, far, onto each other, away from each other, out of the hull and into a plane.
TEST_P(Motion, AnyHistory) {
    Random random(1);
    for (const std::size_t share : {0u, 16u})
        for (Points xyz : sets(random)) {
            const auto t = empty();
            t->set_kernel(*find_kernel(GetParam()));
            t->set_compact(share == 0);
            t->hooks().vertices_per_rebuild = share;
            if (share == 0) t->hooks().large_link = 16;
            insert(*t, xyz);
            const std::size_t n = xyz.size() / 3;
            for (std::size_t round = 0; round < 12; ++round) {
                std::vector<std::uint32_t> points = points_in(*t);
                std::shuffle(points.begin(), points.end(), random);
                points.resize(round < 3 ? 1 : points.size() * round / 12);
                Points places;
                for (const std::uint32_t i : points) {
                    const std::size_t other = static_cast<std::size_t>(random()) % n;
                    for (std::size_t k = 0; k < 3; ++k) {
                        const double x = xyz[3 * i + k], y = xyz[3 * other + k];
                        const double to[6] = {x + 0.01 * (y - x), y,  k == 2 ? 0.25 : x,
                                              x + 3 * (y - x),    -x, x};
                        places.push_back(to[(round + (i % 5 == 0)) % 6]);
                    }
                }
                move_to(*t, xyz, points, places);
                expect_as_fresh(*t, xyz);
                if (HasFailure()) return;
                if (round == 6) {
                    remove(*t, {points[0]});
                    insert(*t, {xyz[0], xyz[1], xyz[2] + 1});
                    xyz.insert(xyz.end(), {xyz[0], xyz[1], xyz[2] + 1});
                }
            }
            EXPECT_GT(t->statistics().moved, 0u);
        }
}

INSTANTIATE_TEST_SUITE_P(Each, Motion, testing::Values("baseline", "avx2", "avx512", "neon"),
                         [](const auto& info) { return std::string(info.param); });

TEST(MotionAndDimension, PointsLeaveSpaceAndComeBack) {
    Points xyz = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0, 1, 1, 0};
    const auto t = empty();
    insert(*t, xyz);
    EXPECT_EQ(t->dimension(), 3);
    move_to(*t, xyz, {3}, {3, 2, 0});
    EXPECT_EQ(t->dimension(), 2);
    expect_as_fresh(*t, xyz);
    move_to(*t, xyz, {2, 4, 5, 3}, {5, 0, 0, 6, 0, 0, 6, 0, 0, 1, 0, 0});
    EXPECT_EQ(t->dimension(), 1);
    EXPECT_EQ(t->vertex_count(), 4u);
    expect_as_fresh(*t, xyz);
    move_to(*t, xyz, {0, 1, 2, 3, 4, 5}, Points(18, 7.0));
    EXPECT_EQ(t->dimension(), 0);
    expect_as_fresh(*t, xyz);
    move_to(*t, xyz, {5, 1, 3}, {0, 0, 0, 1, 0, 0, 0, 1, 0.5});
    EXPECT_EQ(t->dimension(), 3);
    expect_as_fresh(*t, xyz);
}

// All points go to one place and back, some of them at a time.
TEST(MotionOfEqualPoints, JoinAndPart) {
    Random random(2);
    const Points from = uniform_points(200, random);
    Points xyz = from;
    const auto t = empty();
    t->hooks().vertices_per_rebuild = 0;
    insert(*t, xyz);
    for (const bool back : {false, true})
        for (std::uint32_t first = 0; first < 150; first += 30) {
            std::vector<std::uint32_t> points;
            Points places;
            for (std::uint32_t i = first; i < first + 30; ++i) {
                points.push_back(back ? 149 - i : i);
                for (std::size_t k = 0; k < 3; ++k)
                    places.push_back(from[3 * (back ? points.back() : 170) + k]);
            }
            move_to(*t, xyz, points, places);
            expect_as_fresh(*t, xyz);
            if (HasFatalFailure()) return;
        }
    EXPECT_EQ(xyz, from);
    EXPECT_EQ(t->vertex_count(), 200u);
}

// Points at a few places leave, move and come one by one, between calls with several points.
TEST(MotionOfEqualPoints, OneByOne) {
    Random random(11);
    const Points places = lattice(3);
    const auto some_place = [&] { return 3 * (random() % (places.size() / 3)); };
    Points xyz;
    const auto t = empty();
    t->hooks().vertices_per_rebuild = 0;
    const auto come = [&](std::size_t n) {
        Points more;
        for (std::size_t i = 0; i < n; ++i) {
            const auto at = static_cast<std::ptrdiff_t>(some_place());
            more.insert(more.end(), places.begin() + at, places.begin() + at + 3);
        }
        insert(*t, more);
        xyz.insert(xyz.end(), more.begin(), more.end());
    };
    come(150);
    std::size_t shared = 0;
    for (int step = 0; step < 500; ++step) {
        std::vector<std::uint32_t> in = points_in(*t);
        std::shuffle(in.begin(), in.end(), random);
        shared += in.size() - t->vertex_count();
        const std::size_t several = step % 25 == 24 ? 5 : 1;
        switch (random() % 4) {
            case 0:
                come(several);
                break;
            case 1:
            case 2:
                in.resize(several);
                remove(*t, in);
                break;
            default: {
                in.resize(several);
                Points to;
                for (std::size_t i = 0; i < several; ++i) {
                    const auto at = static_cast<std::ptrdiff_t>(some_place());
                    to.insert(to.end(), places.begin() + at, places.begin() + at + 3);
                }
                move_to(*t, xyz, in, to);
            }
        }
        if (t->point_map().size() % 100 == 99) come(20);
        if (step % 10 != 0) continue;
        expect_as_fresh(*t, xyz);
        for (const std::uint32_t i : points_in(*t)) {
            const Vertex& vertex = t->mesh().vertices[t->point_map()[i]];
            ASSERT_TRUE(std::equal(vertex.x, vertex.x + 3, &xyz[3 * i]));
            ASSERT_LE(vertex.index, i);
        }
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(shared, 10000u);
}

// Each allocation fails in turn: the points before have moved, the others have not.
TEST(MotionWithoutMemory, LeavesEachPointInOnePlace) {
    Random random(7);
    Points given = sphere(60, random, true);
    given.insert(given.end(), given.begin(), given.begin() + 90);  // repeats
    const Points far = uniform_points(60, random);
    bool is_done = false;
    std::size_t failures = 0, within = 0;
    for (std::size_t allowed = 0; !is_done; ++allowed) {
        LimitedBlocks blocks{1000000};
        Triangulation t(LimitedBlocks::take, LimitedBlocks::give_back, &blocks);
        t.hooks().vertices_per_rebuild = 0;
        Points xyz = given, places = far;
        insert(t, xyz);
        Buffer<std::uint32_t> points(t.allocator());
        points.reserve(60);
        // Onto the centre, to where there is no point, and onto each other.
        for (std::uint32_t i = 20; i < 80; ++i) {
            points.push_back(i);
            double* const place = &places[3 * (i - 20)];
            if (i % 7 == 0) std::fill_n(place, 3, 0.0);
            if (i % 7 == 1) std::copy_n(&far[0], 3, place);
        }
        t.shrink();
        std::string message;
        blocks.refuse_after(allowed);
        try {
            t.move(points, places.data());
            is_done = true;
        } catch (const std::bad_alloc&) {
            ++failures;
        } catch (const Error& error) {
            ASSERT_EQ(error.status, MGDT_ERR_OUT_OF_MEMORY);
            message = error.message;
            ++failures;
        }
        blocks.refuse_after(1000000);
        std::size_t done = 0;
        const auto is_at = [&](std::uint32_t i, const double* place) {
            const VertexId v = t.point_map()[i];
            return v != infinite_vertex && std::equal(place, place + 3, t.mesh().point(v));
        };
        while (done < 60 && is_at(points[done], &places[3 * done])) {
            std::copy_n(&places[3 * done], 3, &xyz[3 * points[done]]);
            ++done;
        }
        if (!message.empty()) {
            EXPECT_EQ(message, "out of memory after " + std::to_string(done) + " of 60 points");
        }
        within += done > 0 && done < 60;
        ASSERT_EQ(done == 60, is_done) << allowed;
        expect_as_fresh(t, xyz);
        if (HasFatalFailure()) return;
    }
    EXPECT_GT(failures, 10u);
    EXPECT_GT(within, 0u);
}

// Points on two lines have tetrahedra in a number that is quadratic in theirs: more than fit.
TEST(MotionWithoutSlots, LeavesEachPointInOnePlace) {
    Random random(8);
    for (const bool one_call : {false, true}) {
        Points xyz = uniform_points(200, random);
        const auto t = empty();
        const_cast<Mesh&>(t->mesh()).slot_limit = 3000;
        insert(*t, xyz);
        std::vector<std::uint32_t> points;
        Points places;
        for (std::uint32_t i = 0; i < 200; ++i) {
            points.push_back(i);
            const double s = 0.01 * (i / 2) + 0.001 * uniform(random);
            places.insert(places.end(), {i % 2 == 0 ? s : 0.5, i % 2 == 0 ? 0.5 : s, i % 2 + 0.0});
        }
        std::string message;
        std::size_t done = 0;
        try {
            if (one_call) move(*t, points, places);
            for (; !one_call && done < 200; ++done)
                move(*t, {points[done]}, Points(&places[3 * done], &places[3 * done] + 3));
        } catch (const Error& error) {
            EXPECT_EQ(error.status, MGDT_ERR_TOO_LARGE);
            message = error.message;
        }
        unsigned long said = 0;
        const std::size_t at = message.find("after ");
        ASSERT_NE(at, std::string::npos) << message;
        ASSERT_EQ(std::sscanf(message.c_str() + at, "after %lu of", &said), 1);
        if (one_call) {
            done = said;
            EXPECT_GT(said, 0u);
        } else {
            EXPECT_EQ(said, 0u);
        }
        std::copy_n(places.begin(), 3 * done, xyz.begin());
        expect_as_fresh(*t, xyz);
    }
}

TEST(MotionAndProgress, WhatWasDoneBeforeACancellationStays) {
    Random random(6);
    for (const std::size_t share : {0u, 16u}) {
        Points xyz = uniform_points(400, random);
        const Points places = uniform_points(200, random);
        const auto t = empty();
        t->hooks().vertices_per_rebuild = share;
        insert(*t, xyz);
        t->settings().progress = [](double fraction, void*) -> std::int32_t {
            return fraction >= 0.5;
        };
        std::vector<std::uint32_t> points;
        for (std::uint32_t i = 0; i < 200; ++i) points.push_back(i);
        try {
            move(*t, points, places);
            ADD_FAILURE() << "not cancelled";
        } catch (const Error& error) {
            EXPECT_EQ(error.status, MGDT_ERR_CANCELLED);
            EXPECT_STREQ(error.message, share == 0 ? "cancelled after 100 of 200 points"
                                                   : "cancelled after 0 of 200 points");
        }
        if (share == 0) std::copy_n(places.begin(), 300, xyz.begin());
        expect_as_fresh(*t, xyz);
    }
}

TEST(MotionArguments, AreRefusedWithTheirIndex) {
    Random random(5);
    const Points xyz = uniform_points(20, random);
    const auto t = empty();
    insert(*t, xyz);
    remove(*t, {4});
    t->settings().index_base = 1;
    const auto message = [&](const std::vector<std::uint32_t>& points,
                             const Points& places) -> std::string {
        try {
            move(*t, points, places);
        } catch (const Error& error) {
            EXPECT_EQ(error.status, std::string(error.message).find("coordinate") == 0
                                        ? MGDT_ERR_NOT_FINITE
                                        : MGDT_ERR_INVALID_ARGUMENT);
            return error.message;
        }
        return {};
    };
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(message({3, 20}, Points(6)), "there is no point 21: 20 were given, counted from 1");
    EXPECT_EQ(message({3, 5, 3}, Points(9)), "point 4 is to be moved twice");
    EXPECT_EQ(message({3, 4}, Points(6)), "point 5 is not in the triangulation");
    EXPECT_EQ(message({3, 5}, {1, 2, 3, 4, -infinity, 6}), "coordinate y of point 6 is infinite");
    EXPECT_EQ(message({3, 5}, {1, 2, std::nan(""), 4, 5, 6}), "coordinate z of point 4 is NaN");
    expect_as_fresh(*t, xyz);
}

// As often as one likes, without more memory.
TEST(Churn, TakesNoMoreMemory) {
    Random random(10);
    const std::size_t n = 700;  // enough for a location tree
    Points xyz = uniform_points(n, random);
    const auto t = empty();
    insert(*t, xyz);
    std::size_t bytes = 0;
    for (std::size_t round = 0; round < 8000; ++round) {
        const std::uint32_t i = static_cast<std::uint32_t>(random() % n);
        const Points place = uniform_points(1, random);
        if (round % 2 == 0) {
            move_to(*t, xyz, {i}, place);
        } else {
            remove(*t, {i});
            xyz.erase(xyz.begin() + 3 * i, xyz.begin() + 3 * i + 3);
            t->forget_absent_points();
            insert(*t, place);
            xyz.insert(xyz.end(), place.begin(), place.end());
        }
        if (round == 4000) bytes = t->allocator().bytes();
    }
    EXPECT_LE(t->allocator().bytes(), bytes + bytes / 8);
    EXPECT_EQ(t->vertex_count(), n);
    expect_as_fresh(*t, xyz);
}

}  // namespace
}  // namespace mgdt
