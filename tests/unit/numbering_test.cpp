// SPDX-License-Identifier: MIT
// The numbers of tetrahedra, by slot and by bits and counts, against a scan of the records.
#include "query/numbering.hpp"

#include <algorithm>

#include "surgery.hpp"

namespace mgdt {
namespace {

using namespace surgery;

TEST(Numbering, CountsFiniteTetrahedra) {
    Random random(1);
    Team team;
    // Up to some words of 64 slots, and one more or less.
    for (const std::size_t n : {4u, 12u, 13u, 14u, 60u, 400u}) {
        Patient p = triangulate(uniform_points(n, random));
        Mesh& mesh = p.mesh();
        // Free slots, as an insertion leaves them that removes more than it makes.
        mesh.reserve_slots(0, 8);
        for (std::size_t k = 0; k < n / 12 && k < 8; ++k) mesh.free_slot(p.any(random, false));
        const std::size_t slots = mesh.tetrahedra.size();
        std::vector<std::int32_t> expected;
        std::int32_t count = 0;
        for (TetId t = 0; t < slots; ++t) {
            const Tetrahedron& record = mesh.tetrahedra[t];
            expected.push_back(record.is_dead() || record.is_ghost() ? -1 : count++);
        }
        const Numbering numbering(p.t->allocator(), mesh, false, team, slots);
        EXPECT_FALSE(numbering.is_canonical());
        ASSERT_TRUE(numbering.is_by_slot());
        for (TetId t = 0; t < slots; ++t) {
            ASSERT_EQ(numbering.by_slot()(t), expected[t]) << n << ' ' << t;
            ASSERT_EQ(numbering.by_bits()(t), expected[t]) << n << ' ' << t;
            ASSERT_EQ(numbering.number(t), expected[t]) << n << ' ' << t;
        }
        // Runs of any stretches: all of their finite tetrahedra, in runs that end at gaps or
        // stretches.
        for (std::size_t begin = 0; begin < numbering.stretches(); ++begin)
            for (std::size_t end = begin; end <= numbering.stretches(); ++end) {
                const std::size_t slots_end = std::min(64 * end, slots);
                std::size_t next = 64 * begin;
                const auto pass_others = [&] {
                    while (next < slots_end && expected[next] < 0) ++next;
                };
                numbering.for_each_run(
                    begin, end, [&](TetId first, TetId last, std::size_t number) {
                        pass_others();
                        ASSERT_EQ(first, next);
                        ASSERT_GT(last, first);
                        ASSERT_LE(last, slots_end);
                        for (; next < last; ++next, ++number)
                            ASSERT_EQ(static_cast<std::int64_t>(number), expected[next]);
                        ASSERT_TRUE(next % 64 == 0 || next == slots_end || expected[next] < 0);
                    });
                pass_others();
                ASSERT_EQ(next, slots_end) << n << ' ' << begin << ' ' << end;
            }
        std::size_t next = 0;
        numbering.for_each(0, numbering.stretches(), [&](TetId t, std::size_t number) {
            while (expected[next] < 0) ++next;
            ASSERT_EQ(t, next);
            ASSERT_EQ(static_cast<std::int64_t>(number), expected[next++]);
        });
        while (next < slots && expected[next] < 0) ++next;
        EXPECT_EQ(next, slots);
    }
}

// Where slots are many, numbers by slot are for sets with ghosts everywhere.
TEST(Numbering, BySlotWhereFewOrAmongGhosts) {
    Random random(3);
    Team team;
    const auto is_by_slot = [&](const Mesh& mesh, std::size_t few) {
        Allocator allocator;
        const Numbering one(allocator, mesh, false, team, few);
        const Numbering other(allocator, mesh, false, team, mesh.tetrahedra.size());
        for (TetId t = 0; t < mesh.tetrahedra.size(); ++t)
            if (one.number(t) != other.by_slot()(t)) ADD_FAILURE() << t;
        std::size_t longest = 0, counted = 0;
        one.for_each_run(0, one.stretches(), [&](TetId first, TetId last, std::size_t number) {
            EXPECT_EQ(number, counted);
            counted += last - first;
            longest = std::max<std::size_t>(longest, last - first);
        });
        EXPECT_EQ(counted, mesh.finite_count());
        EXPECT_GT(longest, 64u);  // over a word without gaps
        return one.is_by_slot();
    };
    Patient many = triangulate(uniform_points(100000, random));
    EXPECT_FALSE(is_by_slot(many.mesh(), Numbering::few_slots));
    EXPECT_TRUE(is_by_slot(many.mesh(), many.mesh().tetrahedra.size()));
    Patient few = triangulate(uniform_points(400, random));
    EXPECT_TRUE(is_by_slot(few.mesh(), 0));
}

TEST(Numbering, CanonicalNumbersAreAPermutation) {
    Random random(2);
    Team team;
    Patient p = triangulate(uniform_points(300, random));
    const Mesh& mesh = p.mesh();
    const Numbering numbering(p.t->allocator(), mesh, true, team);
    EXPECT_TRUE(numbering.is_canonical());
    std::vector<bool> seen(mesh.finite_count());
    for (TetId t = 0; t < mesh.tetrahedra.size(); ++t) {
        const std::int32_t number = numbering.number(t);
        ASSERT_EQ(number < 0, mesh.tetrahedra[t].is_ghost() || mesh.tetrahedra[t].is_dead());
        if (number < 0) continue;
        ASSERT_LT(static_cast<std::size_t>(number), seen.size());
        ASSERT_FALSE(seen[static_cast<std::size_t>(number)]);
        seen[static_cast<std::size_t>(number)] = true;
    }
}

}  // namespace
}  // namespace mgdt
