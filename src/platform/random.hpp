// SPDX-License-Identifier: MIT
// Pseudorandom numbers that are the same on every machine and with every compiler.
#pragma once

#include <cstdint>

namespace mgdt {

// The generator splitmix64 of Steele, Lea and Flood, "Fast splittable pseudorandom number
// generators" (OOPSLA 2014): a counter and a mixing function. It accepts any
// seed, and its n-th value can be computed without the previous ones.
class Random {
  public:
    explicit Random(std::uint64_t seed) noexcept : state_(seed) {}

    // The n-th value (counted from 0) of the sequence of a seed.
    static std::uint64_t at(std::uint64_t seed, std::uint64_t n) noexcept {
        return mix(seed + (n + 1) * increment);
    }

    std::uint64_t next() noexcept { return mix(state_ += increment); }

    // A uniform number in 0..bound-1, without bias; bound >= 1. Lemire, "Fast random integer
    // generation in an interval" (ACM TOMACS 2019).
    std::uint32_t below(std::uint32_t bound) noexcept {
        std::uint64_t product = (next() >> 32) * bound;
        auto fraction = static_cast<std::uint32_t>(product);
        if (fraction < bound) {
            const std::uint32_t reject = (0u - bound) % bound;
            while (fraction < reject) {
                product = (next() >> 32) * bound;
                fraction = static_cast<std::uint32_t>(product);
            }
        }
        return static_cast<std::uint32_t>(product >> 32);
    }

  private:
    static constexpr std::uint64_t increment = 0x9E3779B97F4A7C15u;

    static std::uint64_t mix(std::uint64_t z) noexcept {
        z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
        z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
        return z ^ (z >> 31);
    }

    std::uint64_t state_;
};

}  // namespace mgdt
