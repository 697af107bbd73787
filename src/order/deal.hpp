// SPDX-License-Identifier: MIT
// Rounds dealt along an order whose consecutive points are near each other.
#pragma once

#include "order/random.hpp"
#include "order/schedule.hpp"
#include "parallel/team.hpp"

namespace mgdt {

// How many rounds from the last each place of an order is.
class Deal {
  public:
    Deal(Team& team, Allocator& allocator, std::size_t n, std::uint64_t seed);

    static constexpr unsigned most_rounds = 16;

    unsigned rounds() const noexcept { return rounds_; }
    unsigned back(std::size_t place) const noexcept { return back_[place]; }
    // Places of the round that is so many from the last.
    std::size_t size(unsigned back) const noexcept { return size_[back]; }

  private:
    Buffer<std::uint8_t> back_;
    unsigned rounds_ = 0;
    std::size_t size_[most_rounds];
};

// Biased rounds as in BRIO, but spread evenly instead of drawn independently at random: along the
// order, one point of every twelve goes in before the other eleven, of those again one of every
// twelve before the rest, and so on. No round has the gaps and crowds of an independent choice, so
// fewer tetrahedra are built to be removed again, and fewer rounds do. A million points take 20.5
// removals an insertion with one of eight, 21.1 with one of twelve, 21.5 with one of sixteen (as
// many as BRIO with one of eight), but what was built before is visited the less often. Twelve
// removes no more than the paper's multi-grid plus one on an ellipsoid; sixteen does.
//
// Fills order and rounds of a schedule; index(k) is the point at place k of the order.
template <class Index>
void deal_rounds(Team& team, std::uint64_t seed, Index index, Schedule& out) {
    const std::size_t n = out.order.size();
    const Deal deal(team, out.order.allocator(), n, seed);
    // Where each round goes on, for each member's part of the order.
    struct alignas(64) Next {
        std::size_t of[Deal::most_rounds] = {};
    };
    const unsigned members = team.members_for(n, 65536);
    Buffer<Next> next(out.order.allocator());
    next.resize(members + 1, Next());
    const auto first = [&](unsigned member) { return Team::part(n, member, members); };
    if (members > 1)
        team.run(members, [&](unsigned m) {
            Next sizes;
            for (std::size_t k = first(m); k < first(m + 1); ++k) ++sizes.of[deal.back(k)];
            next[m + 1] = sizes;
        });
    std::size_t begin = 0;
    out.rounds.clear();
    for (unsigned r = deal.rounds(); r-- > 0;) {
        out.rounds.push_back(static_cast<std::uint32_t>(begin));
        next[0].of[r] = begin;
        for (unsigned m = 1; m < members; ++m) next[m].of[r] += next[m - 1].of[r];
        begin += deal.size(r);
    }
    team.run(members, [&](unsigned m) {
        Next to = next[m];
        for (std::size_t k = first(m); k < first(m + 1); ++k)
            out.order[to.of[deal.back(k)]++] = index(k);
    });
}

// Deals the order that a schedule has.
void deal_rounds(Team& team, std::uint64_t seed, Schedule& schedule);

}  // namespace mgdt
