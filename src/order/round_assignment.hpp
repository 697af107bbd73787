// SPDX-License-Identifier: MIT
// Assigns points to rounds, along an order in which consecutive points are near each other.
#pragma once

#include "order/curve_sort.hpp"
#include "order/schedule.hpp"
#include "parallel/team_lists.hpp"

namespace mgdt {

// The round of each position in an order. If there is a curve, it tells which points are isolated.
class RoundAssignment {
  public:
    RoundAssignment(Team& team, Allocator& allocator, std::size_t n, std::uint64_t seed,
                    const CurveOrder* curve = nullptr);

    static constexpr unsigned most_rounds = 16;
    static constexpr std::size_t min_items_per_thread = 65536;

    unsigned rounds() const noexcept { return rounds_; }
    unsigned round(std::size_t position) const noexcept { return rounds_ - 1u - back_[position]; }

  private:
    class Chooser;

    Buffer<std::uint8_t> back_;  // the round of each position, counted from the last round
    unsigned rounds_ = 0;
};

// Assigns points to rounds of growing size as in BRIO, but evenly spread instead of random: along
// the order, one point in twelve belongs to earlier rounds than the other eleven; of these earlier
// points, again one in twelve belongs to still earlier rounds, and so on. Random rounds have gaps
// and clusters, so more tetrahedra are built that are removed again. docs/experiments.md has
// figures for one in eight, twelve and sixteen. If at most 4,096 points are left, which fit into
// the cache, one point in four is chosen.
//
// With a curve, the chosen point is usually one in the middle of the twelve: the point that is
// farthest from its neighbours on the curve. Ties, and the choice without a curve, are random. On
// thin sets the chosen points are on the outside, and later points are between them. This saves 4 %
// of the removals on a spiral, on diagonals and on a line, and changes nothing on a uniform set.
//
// Fills `order` and `rounds` of a schedule; index(k) is the point at position k of the order.
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
        [&](std::size_t position, std::uint32_t point) { out.order[position] = point; });
    out.rounds.clear();
    for (unsigned r = 0; r < rounds.rounds(); ++r) out.rounds.push_back(ends[r]);
}

// Assigns the points of a schedule's order to rounds.
void assign_rounds(Team& team, std::uint64_t seed, Schedule& schedule);

}  // namespace mgdt
