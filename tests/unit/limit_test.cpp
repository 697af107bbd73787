// SPDX-License-Identifier: MIT
// More tetrahedra than facet codes can number: a status, and nothing lost. The limit is lowered,
// since 2^30 tetrahedra fill 48 GiB.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "core/triangulation.hpp"
#include "platform/error.hpp"
#include "query/check.hpp"
#include "unwatched.hpp"

namespace mgdt {
namespace {

void insert(Triangulation& t, const std::vector<double>& xyz) {
    const double* axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
    t.insert(xyz.size() / 3, axis, 3);
}

TEST(Limit, KeepsWhatGotIn) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::vector<double> xyz(3 * 3000);
    for (double& x : xyz) x = uniform(random);

    Team alone;
    Triangulation t(nullptr, nullptr, nullptr);
    Mesh& mesh = const_cast<Mesh&>(t.mesh());
    // Storage is reserved for a batch at once; small batches make it grow step by step.
    mesh.slot_limit = 4000;
    mgdt_status status = MGDT_OK;
    std::size_t given = 0;
    for (; given < 3000 && status == MGDT_OK; given += 10) {
        try {
            insert(t,
                   std::vector<double>(xyz.begin() + static_cast<std::ptrdiff_t>(3 * given),
                                       xyz.begin() + static_cast<std::ptrdiff_t>(3 * given + 30)));
        } catch (const Error& error) {
            status = error.status;
            EXPECT_NE(std::string(error.message).find("4000 tetrahedra"), std::string::npos);
        }
    }
    EXPECT_EQ(status, MGDT_ERR_TOO_LARGE);
    EXPECT_EQ(t.point_map().size(), given);
    EXPECT_LE(mesh.tetrahedra.size(), 4000u);
    EXPECT_GT(t.vertex_count(), 400u);
    EXPECT_LT(t.vertex_count(), given);
    EXPECT_NO_THROW(check_triangulation(alone, t.check_input(), t.allocator(), MGDT_CHECK_CANONICAL,
                                        0, Unwatched()));

    // With room again insertion goes on, and the points that were left out may be given anew.
    mesh.slot_limit = max_tetrahedra;
    insert(t, xyz);
    EXPECT_EQ(t.vertex_count(), 3000u);
    EXPECT_NO_THROW(check_triangulation(alone, t.check_input(), t.allocator(), MGDT_CHECK_CANONICAL,
                                        0, Unwatched()));
}

// More points than vertices can have numbers, but fewer places: repeats take no number. The limit
// is lowered here too.
TEST(Limit, MorePointsThanVertices) {
    std::mt19937_64 random(2);
    std::vector<double> xyz(3 * 3000);
    for (double& x : xyz) x = static_cast<double>(random() % 9);
    const std::vector<double> first(xyz.begin(), xyz.begin() + 300);
    const std::vector<double> rest(xyz.begin() + 300, xyz.end());
    Triangulation expected(nullptr, nullptr, nullptr);
    insert(expected, xyz);
    for (const std::int32_t threads : {1, 3}) {
        Triangulation t(nullptr, nullptr, nullptr);
        const_cast<Mesh&>(t.mesh()).vertex_limit = 800;  // 9^3 places
        t.settings().threads = threads;
        t.hooks().min_points_per_thread = 100;
        insert(t, first);
        insert(t, rest);
        EXPECT_EQ(t.vertex_count(), expected.vertex_count());
        EXPECT_EQ(t.mesh().finite_count(), expected.mesh().finite_count());
        for (std::size_t i = 0; i < 3000; ++i)
            for (std::size_t k = 0; k < 3; ++k)
                ASSERT_EQ(t.mesh().point(t.point_map()[i])[k], xyz[3 * i + k]) << i;
        Team team(2);
        EXPECT_NO_THROW(check_triangulation(team, t.check_input(), t.allocator(),
                                            MGDT_CHECK_CANONICAL, 0, Unwatched()));
    }
}

// A cavity that outgrows the scratch arrays while it is dug: nothing has changed but marks, which
// are taken back.
TEST(Limit, CavityOutOfMemory) {
    std::vector<double> lines;
    for (int i = 0; i < 24; ++i) {
        lines.insert(lines.end(), {i - 11.7, 0, -8});
        lines.insert(lines.end(), {0, i - 11.3, 8});
    }
    Team alone;
    Triangulation t(nullptr, nullptr, nullptr);
    insert(t, lines);
    const std::size_t before = t.mesh().live_count();
    ASSERT_GT(before, 600u);
    int refused = 0;
    for (std::size_t more = 0;; more += 256) {
        t.allocator().set_limit(t.allocator().bytes() + more);
        try {
            insert(t, {0.1, 0.2, 0.3});
            break;
        } catch (const std::bad_alloc&) {
            ++refused;
        }
        ASSERT_EQ(t.mesh().live_count(), before);
        t.allocator().set_limit(0);
        ASSERT_NO_THROW(check_triangulation(alone, t.check_input(), t.allocator(),
                                            MGDT_CHECK_CANONICAL, 0, Unwatched()));
    }
    t.allocator().set_limit(0);
    EXPECT_GT(refused, 3);
    EXPECT_LT(t.mesh().live_count(), before / 2);
    EXPECT_NO_THROW(check_triangulation(alone, t.check_input(), t.allocator(), MGDT_CHECK_CANONICAL,
                                        0, Unwatched()));
}

}  // namespace
}  // namespace mgdt
