// SPDX-License-Identifier: MIT
// Which grids and rules are tried, for every kind of boundary.
#include "domain/attempts.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace mgdt {
namespace {

using Result = Attempts::Result;

// The attempts until there is no other, or until a mesh is made: each with its bits, and the
// letters `s` if it avoids short parts and `t` if it may take long.
std::string attempts_of(const std::function<Result(const Attempt&)>& result) {
    Attempts attempts;
    std::string all;
    do {
        const Attempt& a = attempts.current();
        all += std::to_string(a.bits) + (a.avoids_short_parts ? "s" : "") +
               (a.may_take_long ? "t" : "") + " ";
        EXPECT_EQ(attempts.share_passed() > 0, all.find(' ') + 1 < all.size());
    } while (attempts.advance(result(attempts.current())));
    return all + (attempts.has_taken_long() ? "slow" : "");
}

TEST(Attempts, CoarsenWhileSegmentsAreStuck) {
    EXPECT_EQ(attempts_of([](const Attempt&) { return Result::stuck; }), "36 36s 32s 28s 24s ");
}

TEST(Attempts, GiveTimeOnTheCoarsestSlowGrid) {
    EXPECT_EQ(attempts_of([](const Attempt&) { return Result::took_long; }),
              "36 36s 32s 28s 24s 24st slow");
    EXPECT_EQ(attempts_of([](const Attempt& a) {
                  return a.bits == 32 ? Result::took_long : Result::stuck;
              }),
              "36 36s 32s 28s 24s 32st slow");
}

TEST(Attempts, TakeTheFinestGridForFineDetails) {
    EXPECT_EQ(attempts_of([](const Attempt&) { return Result::too_coarse; }), "36 44 ");
    EXPECT_EQ(attempts_of([](const Attempt& a) {
                  return a.bits < 40 ? Result::too_coarse : Result::stuck;
              }),
              "36 44 44s 40s 36s ");
    EXPECT_EQ(attempts_of([](const Attempt& a) {
                  return a.bits < 40 ? Result::too_coarse : Result::took_long;
              }),
              "36 44 44s 40s 36s 40st slow");
}

}  // namespace
}  // namespace mgdt
