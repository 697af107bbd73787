// SPDX-License-Identifier: MIT
//
// The program's own random numbers, so that a seed gives the same points with every compiler:
// xoshiro256++ (Blackman, Vigna, ACM TOMS 47 (2021)), seeded by splitmix64 as they advise.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mgdt::cli {

using Point = std::array<double, 3>;
using Points = std::vector<Point>;

class Random {
  public:
    explicit Random(std::uint64_t seed) {
        for (std::uint64_t& word : state_) {
            seed += 0x9e3779b97f4a7c15U;
            std::uint64_t z = seed;
            z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
            z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
            word = z ^ (z >> 31);
        }
    }

    std::uint64_t bits() {
        const std::uint64_t result = rotate(state_[0] + state_[3], 23) + state_[0];
        const std::uint64_t t = state_[1] << 17;
        state_[2] ^= state_[0];
        state_[3] ^= state_[1];
        state_[1] ^= state_[2];
        state_[0] ^= state_[3];
        state_[2] ^= t;
        state_[3] = rotate(state_[3], 45);
        return result;
    }

    // Uniform in [0, 1): a multiple of 2^-53.
    double uniform() { return static_cast<double>(bits() >> 11) * 0x1p-53; }

    // Uniform in [-width / 2, width / 2).
    double jitter(double width) { return width * (uniform() - 0.5); }

    // Uniform in 0, ..., n - 1, for 0 < n < 2^32 (Lemire's multiplication; its bias, below
    // n / 2^64, is of no concern here).
    std::uint64_t below(std::uint64_t n) {
        const std::uint64_t x = bits();
        const std::uint64_t low = ((x & 0xffffffffU) * n) >> 32;
        return ((x >> 32) * n + low) >> 32;
    }

    Point uniform_point() {
        Point p;
        for (double& c : p) c = uniform();
        return p;
    }

    // A uniform unit vector (Marsaglia 1972): square roots only, which are the same everywhere.
    Point direction() {
        for (;;) {
            const double x = 2 * uniform() - 1;
            const double y = 2 * uniform() - 1;
            const double s = x * x + y * y;
            if (s >= 1) continue;
            const double root = 2 * std::sqrt(1 - s);
            return {x * root, y * root, 1 - 2 * s};
        }
    }

  private:
    static std::uint64_t rotate(std::uint64_t x, int k) { return (x << k) | (x >> (64 - k)); }

    std::array<std::uint64_t, 4> state_;
};

// n points, each of which make_point() draws anew.
template <class MakePoint>
Points repeat(std::size_t n, MakePoint make_point) {
    Points points;
    points.reserve(n);
    for (std::size_t i = 0; i < n; ++i) points.push_back(make_point());
    return points;
}

}  // namespace mgdt::cli
