// SPDX-License-Identifier: MIT
#include "order/deal.hpp"

#include <algorithm>

#include "order/random.hpp"

namespace mgdt {
namespace {

// Of so many consecutive places one is chosen for the round before, of those in the middle, so that
// a round's points keep their distance.
template <std::size_t places, unsigned bits>
struct Block {
    static constexpr std::size_t size = places;
    static constexpr unsigned middle_bits = bits;
    static constexpr std::size_t middle = std::size_t{1} << bits, margin = (size - middle) / 2;
    static_assert(margin > 0);  // all have neighbours in their block
};
using BlockOfMany = Block<12, 3>;
using BlockOfFew = Block<4, 1>;
constexpr std::size_t few = 4096;
constexpr std::size_t largest_first = 64;
constexpr std::size_t share = 65536;

// Which of the middle ones is farthest from both of its neighbours along the curve; place(i) is
// that of the i-th of them, from -1 on. Of equal ones the first from `first` on, cyclically.
template <class Block, class Place>
std::size_t loneliest(const CurveOrder& curve, std::size_t first, Place place) {
    constexpr std::size_t middle = Block::middle;
    unsigned apart[middle + 1];
    for (std::size_t i = 0; i <= middle; ++i) apart[i] = curve.levels_apart(place(i - 1), place(i));
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
    return best;
}

}  // namespace

Deal::Deal(Team& team, Allocator& allocator, std::size_t n, std::uint64_t seed,
           const CurveOrder* curve)
    : back_(allocator) {
    back_.resize(n);
    team.split(n, share, [&](std::size_t begin, std::size_t end, unsigned) {
        std::fill(back_.begin() + begin, back_.begin() + end, std::uint8_t{0});
    });
    Buffer<std::uint32_t> chosen(allocator, n / (n > few ? BlockOfMany::size : BlockOfFew::size));
    std::uint64_t drawn = 0;
    std::size_t left = n;
    // Chooses the round before from those that are left.
    const auto add_round = [&](auto kind) {
        using Block = decltype(kind);
        const std::size_t blocks = left / Block::size;
        const auto place_of = [&](std::size_t k) {
            return rounds_ == 0 ? static_cast<std::uint32_t>(k) : chosen[k];
        };
        const auto choose = [&](std::size_t begin, std::size_t end, unsigned) {
            for (std::size_t b = begin; b < end; ++b) {
                const std::size_t from = b * Block::size + Block::margin;
                auto at = static_cast<std::size_t>(Random::at(seed, drawn + b) >>
                                                   (64 - Block::middle_bits));
                if (curve)
                    at = loneliest<Block>(*curve, at,
                                          [&](std::size_t i) { return place_of(from + i); });
                const std::uint32_t place = place_of(from + at);
                back_[place] = static_cast<std::uint8_t>(rounds_ + 1);
                chosen[b] = place;
            }
        };
        // Later ones read what was chosen before, in the array that they write.
        if (rounds_ == 0)
            team.split(blocks, share, choose);
        else
            choose(0, blocks, 0);
        drawn += blocks;
        ++rounds_;
        left = blocks;
    };
    while (left > few) add_round(BlockOfMany());
    while (left > largest_first) add_round(BlockOfFew());
    ++rounds_;
}

void deal_rounds(Team& team, std::uint64_t seed, Schedule& schedule) {
    Buffer<std::uint32_t> order(schedule.scratch, schedule.order.size());
    std::copy(schedule.order.begin(), schedule.order.end(), order.begin());
    schedule.hints.clear();
    deal_rounds(
        team, seed, [&](std::size_t k) { return order[k]; }, schedule);
}

}  // namespace mgdt
