// SPDX-License-Identifier: MIT
// Random rounds of growing size, as in a biased randomized insertion order.
#pragma once

#include <cstddef>
#include <cstdint>

#include "platform/random.hpp"

namespace mgdt {

// Assigns points to rounds, each about `ratio` times as large as all previous rounds together:
// Amenta, Choi and Rote, "Incremental constructions con BRIO" (SoCG 2003), where the ratio is 1.
// The round of a point is a function of its index and the seed, so nothing has to be stored.
class RandomRounds {
  public:
    RandomRounds(std::size_t n, double ratio, std::uint64_t seed) noexcept : seed_(seed) {
        double share = 1;
        while (static_cast<double>(n) * share > largest_first && count_ < most) {
            share /= 1 + ratio;
            limit_[count_++] = static_cast<std::uint64_t>(share * 0x1p64);
        }
    }

    unsigned count() const noexcept { return count_; }

    // The round of a point, 0..count-1.
    unsigned of(std::uint32_t index) const noexcept {
        const std::uint64_t draw = Random::at(seed_, index);
        unsigned back = 0;
        while (back + 1 < count_ && draw < limit_[back + 1]) ++back;
        return count_ - 1 - back;
    }

  private:
    static constexpr unsigned most = 64;
    static constexpr double largest_first = 64;  // up to this many points need no rounds

    std::uint64_t seed_;
    unsigned count_ = 1;
    // A point is in one of the first count - k rounds, where k >= 1, if its random number is below
    // limit_[k].
    std::uint64_t limit_[most] = {};
};

}  // namespace mgdt
