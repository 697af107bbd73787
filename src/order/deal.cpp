// SPDX-License-Identifier: MIT
#include "order/deal.hpp"

#include <algorithm>

namespace mgdt {
namespace {

// Places of a round that is not the last: one of so many consecutive ones.
constexpr std::size_t block = 12;
// The one is drawn from the middle of the block, so that a round's points keep their distance.
constexpr unsigned middle_bits = 3;
constexpr std::size_t margin = (block - (std::size_t{1} << middle_bits)) / 2;
constexpr std::size_t largest_first = 64;
constexpr std::size_t share = 65536;

}  // namespace

Deal::Deal(Team& team, Allocator& allocator, std::size_t n, std::uint64_t seed) : back_(allocator) {
    back_.resize(n);
    team.split(n, share, [&](std::size_t begin, std::size_t end, unsigned) {
        std::fill(back_.begin() + begin, back_.begin() + end, std::uint8_t{0});
    });
    Buffer<std::uint32_t> chosen(allocator, (n + block - 1) / block);
    std::uint64_t drawn = 0;
    std::size_t left = n;
    while (left > largest_first) {
        const std::size_t blocks = left / block;
        const auto choose = [&](std::size_t begin, std::size_t end, unsigned) {
            for (std::size_t b = begin; b < end; ++b) {
                const std::uint64_t draw = Random::at(seed, drawn + b) >> (64 - middle_bits);
                const std::size_t at = b * block + margin + static_cast<std::size_t>(draw);
                const std::uint32_t place =
                    rounds_ == 0 ? static_cast<std::uint32_t>(at) : chosen[at];
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
    }
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
