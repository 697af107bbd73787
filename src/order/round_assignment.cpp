// SPDX-License-Identifier: MIT
#include "order/round_assignment.hpp"

#include <algorithm>

#include "platform/random.hpp"

namespace mgdt {
namespace {

// From each block of consecutive positions, one position is chosen for the previous round. It is in
// the middle of the block, so that the points of a round keep a distance from each other.
template <std::size_t candidates, unsigned bits>
struct Block {
    static constexpr std::size_t size = candidates;
    static constexpr unsigned middle_bits = bits;
    static constexpr std::size_t middle = std::size_t{1} << bits, margin = (size - middle) / 2;
    static_assert(margin > 0);  // positions in the middle have neighbours in their block
};
using BlockOfMany = Block<12, 3>;
using BlockOfFew = Block<4, 1>;
constexpr std::size_t few = 4096;
constexpr std::size_t largest_first = 64;

// The position in the middle of a block that is farthest from both its neighbours on the curve, and
// by how many levels. In most_isolated(), position(i) is the i-th position of the middle, for i
// from -1 on. Among equals, the first position from `first` on is taken, cyclically.
struct MostIsolated {
    std::size_t i;
    unsigned levels;
};
template <class Block, class PositionOf>
MostIsolated most_isolated(const CurveOrder& curve, std::size_t first, PositionOf position) {
    constexpr std::size_t middle = Block::middle;
    unsigned apart[middle + 1];
    for (std::size_t i = 0; i <= middle; ++i)
        apart[i] = curve.levels_apart(position(i - 1), position(i));
    std::size_t best = first;
    unsigned most = 0;
    for (std::size_t k = 0; k < middle; ++k) {
        const std::size_t i = (first + k) % middle;
        const unsigned alone = std::min(apart[i], apart[i + 1]);
        if (alone > most) {
            most = alone;
            best = i;
        }
    }
    return {best, most};
}

// A point outside the middle of its block is chosen if it is at least this many levels farther from
// its neighbours than the most isolated point of the middle. Examples are the centre of a sphere
// and an apex above a plane. Such a point has an edge to most other points. The later it is
// inserted, the more tetrahedra are built in its place and removed again.
constexpr unsigned levels_of_a_hub = 3;

// The most isolated of the positions begin..end-1, if it is isolated by at least levels +
// levels_of_a_hub; otherwise `otherwise`. There are `count` positions in all.
template <class PositionOf>
std::size_t isolated_hub_or(std::size_t otherwise, unsigned levels, const CurveOrder& curve,
                            std::size_t begin, std::size_t end, std::size_t count,
                            PositionOf position) {
    unsigned before = begin == 0 ? ~0u : curve.levels_apart(position(begin - 1), position(begin));
    unsigned most = levels + levels_of_a_hub - 1;
    for (std::size_t k = begin; k < end; ++k) {
        const unsigned after =
            k + 1 == count ? ~0u : curve.levels_apart(position(k), position(k + 1));
        const unsigned alone = std::min(before, after);
        if (alone > most) {
            most = alone;
            otherwise = k;
        }
        before = after;
    }
    return otherwise;
}

}  // namespace

// Chooses the points of the rounds, beginning with the last round. In each step, one position of
// every block is chosen, and the chosen positions are left for the previous round.
class RoundAssignment::Chooser {
  public:
    Chooser(RoundAssignment& rounds, Allocator& allocator, std::uint64_t seed,
            const CurveOrder* curve)
        : rounds_(rounds),
          chosen_(allocator, rounds.back_.size() / (rounds.back_.size() > few ? BlockOfMany::size
                                                                              : BlockOfFew::size)),
          left_(rounds.back_.size()),
          seed_(seed),
          curve_(curve) {}

    std::size_t left() const noexcept { return left_; }

    template <class Block>
    void add_round(Team& team) {
        const std::size_t blocks = left_ / Block::size;
        const auto choose = [&](std::size_t begin, std::size_t end, unsigned) {
            for (std::size_t b = begin; b < end; ++b) choose_of_block<Block>(b, blocks);
        };
        // After the first round, choices are read from the array that they are written to, so one
        // thread makes them in order.
        if (rounds_.rounds_ == 0)
            team.split(blocks, min_items_per_thread, choose);
        else
            choose(0, blocks, 0);
        drawn_ += blocks;
        ++rounds_.rounds_;
        left_ = blocks;
    }

  private:
    // The k-th of the remaining positions.
    std::uint32_t position(std::size_t k) const {
        return rounds_.rounds_ == 0 ? static_cast<std::uint32_t>(k) : chosen_[k];
    }

    template <class Block>
    void choose_of_block(std::size_t b, std::size_t blocks) {
        const std::size_t first = b * Block::size, from = first + Block::margin;
        // The last whole block includes the remaining positions after it.
        const std::size_t last = b + 1 == blocks ? left_ : first + Block::size;
        const auto drawn =
            static_cast<std::size_t>(Random::at(seed_, drawn_ + b) >> (64 - Block::middle_bits));
        std::size_t at = from + drawn;
        if (curve_) {
            const auto position_of = [&](std::size_t k) { return position(k); };
            const MostIsolated found = most_isolated<Block>(
                *curve_, drawn, [&](std::size_t i) { return position(from + i); });
            at = isolated_hub_or(from + found.i, found.levels, *curve_, first, from, left_,
                                 position_of);
            at = isolated_hub_or(at, found.levels, *curve_, from + Block::middle, last, left_,
                                 position_of);
        }
        const std::uint32_t chosen = position(at);
        rounds_.back_[chosen] = static_cast<std::uint8_t>(rounds_.rounds_ + 1);
        chosen_[b] = chosen;
    }

    RoundAssignment& rounds_;
    Buffer<std::uint32_t> chosen_;
    std::size_t left_;
    std::uint64_t drawn_ = 0;
    const std::uint64_t seed_;
    const CurveOrder* const curve_;
};

RoundAssignment::RoundAssignment(Team& team, Allocator& allocator, std::size_t n,
                                 std::uint64_t seed, const CurveOrder* curve)
    : back_(allocator) {
    back_.resize(n);
    team.split(n, min_items_per_thread, [&](std::size_t begin, std::size_t end, unsigned) {
        std::fill(back_.begin() + begin, back_.begin() + end, std::uint8_t{0});
    });
    Chooser chooser(*this, allocator, seed, curve);
    while (chooser.left() > few) chooser.add_round<BlockOfMany>(team);
    while (chooser.left() > largest_first) chooser.add_round<BlockOfFew>(team);
    ++rounds_;
}

void assign_rounds(Team& team, std::uint64_t seed, Schedule& schedule) {
    Buffer<std::uint32_t> order(schedule.scratch, schedule.order.size());
    std::copy(schedule.order.begin(), schedule.order.end(), order.begin());
    schedule.hints.clear();
    assign_rounds(
        team, seed, [&](std::size_t k) { return order[k]; }, schedule);
}

}  // namespace mgdt
