// SPDX-License-Identifier: MIT
// Tries that have failed are not repeated, and nothing is lost by that.
#include "improvement/failed_tries.hpp"

#include <gtest/gtest.h>

#include "flexible_meshes.hpp"
#include "improvable_meshes.hpp"

namespace mgdt {
namespace {

TEST(FailedTries, AreForgottenWithTheNextChange) {
    constexpr FailedTries::Kind narrow = {1, 1}, wide = {2, 3};
    Allocator memory;
    FailedTries failed(memory);
    failed.resize(2);
    EXPECT_FALSE(failed.has(0, narrow, 0));
    failed.add(0, narrow, 5, 0);
    EXPECT_TRUE(failed.has(0, narrow, 4));
    EXPECT_FALSE(failed.has(0, narrow, 5)) << "the change was in the same round, after the try";
    EXPECT_FALSE(failed.has(0, wide, 4));
    EXPECT_FALSE(failed.has(1, narrow, 4));
    // A kind that fails after a change is not joined by those that have failed before.
    failed.add(0, wide, 7, 4);
    EXPECT_TRUE(failed.has(0, narrow, 6));
    EXPECT_TRUE(failed.has(0, wide, 6));
    failed.add(0, narrow, 9, 8);
    EXPECT_TRUE(failed.has(0, narrow, 8));
    EXPECT_FALSE(failed.has(0, wide, 8));
    failed.resize(3);
    EXPECT_TRUE(failed.has(0, narrow, 8));
    EXPECT_FALSE(failed.has(2, narrow, 0));
}

// An Improver that remembers its failures, and new ones that cannot, change the mesh in the same
// way. Insertions are left out: what they remember is an estimate.
TEST(FailedTries, LeaveOutNothingThatWouldSucceed) {
    for (const unsigned seed : {15u, 16u, 17u, 18u}) {
        SCOPED_TRACE(seed);
        MeshedDomain domain;
        give(domain, is_small() != 0 ? gridded_box(5, 4, 4, 0.49, seed, true)
                                     : gridded_box(12, 12, 6, 0.49, seed, true));
        domain.build();
        const bool slides = seed % 2 == 0;
        Allocator memory;
        Team team(1);
        FlexibleMesh one(domain.mesh(), one_thread(), memory),
            other(domain.mesh(), one_thread(), memory);
        classify(one, slides);
        classify(other, slides);
        const ImprovementSettings settings = settings_for(60, slides);
        Improver remembering(one, team, settings);
        std::size_t changes = 0, last_changes = 0;
        for (int pass = 0; pass < 12; ++pass) {
            last_changes = 0;
            const auto same = [&](std::size_t (Improver::*operation)(StageProgress&)) {
                Improver forgetful(other, team, settings);
                remembering.choose(settings.goal);
                forgetful.choose(settings.goal);
                const std::size_t made = (remembering.*operation)(Unwatched());
                ASSERT_EQ(made, (forgetful.*operation)(Unwatched())) << pass;
                last_changes += made;
            };
            same(&Improver::flip);
            if (pass % 3 == 0) same(&Improver::smooth);
            same(&Improver::flip);
            same(&Improver::contract);
            changes += last_changes;
        }
        EXPECT_GT(changes, last_changes);
        EXPECT_TRUE(std::equal(one.x.begin(), one.x.end(), other.x.begin(), other.x.end()));
        EXPECT_TRUE(std::equal(one.qualities.begin(), one.qualities.end(), other.qualities.begin(),
                               other.qualities.end()));
    }
}

}  // namespace
}  // namespace mgdt
