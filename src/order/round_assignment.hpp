// SPDX-License-Identifier: MIT
// Rounds dealt along an order whose consecutive points are near each other.
#pragma once

#include "order/curve_sort.hpp"
#include "order/schedule.hpp"
#include "parallel/team_lists.hpp"

namespace mgdt {

// The round of each place of an order. A curve also says which points stand alone.
class RoundAssignment {
  public:
    RoundAssignment(Team& team, Allocator& allocator, std::size_t n, std::uint64_t seed,
                    const CurveOrder* curve = nullptr);

    static constexpr unsigned most_rounds = 16;
    static constexpr std::size_t min_items_per_thread = 65536;

    unsigned rounds() const noexcept { return rounds_; }
    unsigned round(std::size_t place) const noexcept { return rounds_ - 1u - back_[place]; }

  private:
    class Chooser;

    Buffer<std::uint8_t> back_;  // rounds from the last
    unsigned rounds_ = 0;
};

// Biased rounds as in BRIO, but spread evenly instead of drawn independently at random: along the
// order, one point of every twelve goes in before the other eleven, of those again one of every
// twelve before the rest, and so on. No round has the gaps and crowds of an independent choice, so
// fewer tetrahedra are built to be removed again, and fewer rounds do. docs/experiments.md has the
// figures for one of eight, twelve and sixteen. Of up to 4,096 points, which stay in the cache, it
// is one of four.
//
// Along a curve the one is not any of the twelve but, of those in the middle, the one that lies
// farthest from the next along the curve; which of several that lie equally far, or of all where
// there is no curve, is drawn. On thin sets these are the points that stick out, and what comes
// later falls between them: 4 % fewer removals on a spiral, on diagonals and on a line, fewer than
// in random order, and the same number on a uniform set.
//
// Fills order and rounds of a schedule; index(k) is the point at place k of the order.
template <class Index>
void assign_rounds(Team& team, std::uint64_t seed, Index index, Schedule& out,
                   const CurveOrder* curve = nullptr) {
    const std::size_t n = out.order.size();
    Allocator& allocator = out.scratch;
    const RoundAssignment rounds(team, allocator, n, seed, curve);
    std::uint32_t ends[RoundAssignment::most_rounds + 1];
    make_lists(
        team, allocator, n, RoundAssignment::min_items_per_thread, rounds.rounds(), ends,
        [&](std::size_t begin, std::size_t end, auto f) {
            for (std::size_t k = begin; k < end; ++k) f(rounds.round(k), index(k));
        },
        [](std::size_t) {},
        [&](std::size_t place, std::uint32_t point) { out.order[place] = point; });
    out.rounds.clear();
    for (unsigned r = 0; r < rounds.rounds(); ++r) out.rounds.push_back(ends[r]);
}

// Deals the order that a schedule has.
void assign_rounds(Team& team, std::uint64_t seed, Schedule& schedule);

}  // namespace mgdt
