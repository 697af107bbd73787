// SPDX-License-Identifier: MIT
// The numbers of tetrahedra, by slot and by bits and counts, against a scan of the records.
#include "query/numbering.hpp"

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
        for (const std::size_t few : {slots, slots - 1}) {
            const Numbering numbering(p.t->allocator(), mesh, false, team, few);
            EXPECT_FALSE(numbering.is_canonical());
            std::vector<std::int32_t> expected;
            std::int32_t count = 0;
            for (TetId t = 0; t < slots; ++t) {
                const Tetrahedron& record = mesh.tetrahedra[t];
                expected.push_back(record.is_dead() || record.is_ghost() ? -1 : count++);
                ASSERT_EQ(numbering.number(t), expected[t]) << n << ' ' << few << ' ' << t;
            }
            TetId next = 0;
            numbering.for_each(0, numbering.stretches(), [&](TetId t, std::size_t number) {
                while (expected[next] < 0) ++next;
                ASSERT_EQ(t, next);
                ASSERT_EQ(number, static_cast<std::size_t>(expected[next++]));
            });
            while (next < slots && expected[next] < 0) ++next;
            EXPECT_EQ(next, slots);
        }
    }
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
