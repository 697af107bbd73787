// SPDX-License-Identifier: MIT
// Sets that are as hard as sets of points come: for the tests of extremes and of what they cost.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "../support/points.hpp"

namespace faults {

using mgdt_tests::Points;
using Random = std::mt19937_64;

inline double uniform(Random& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}

template <class Coordinate>
Points from_coordinates(std::size_t n, unsigned seed, Coordinate coordinate) {
    Random random(seed);
    Points xyz(3 * n);
    for (double& x : xyz) x = coordinate(random);
    return xyz;
}

// Any finite double, all bits at random: every exponent from subnormals to 1e308.
inline Points any_doubles(std::size_t n) {
    return from_coordinates(n, 1, [](Random& random) {
        for (;;) {
            const std::uint64_t bits = random();
            double x;
            std::memcpy(&x, &bits, sizeof x);
            if (std::isfinite(x)) return x;
        }
    });
}

// Exponents from -spread / 2 to spread / 2, one-bit significands if `powers`.
inline Points exponent_spread(std::size_t n, int spread, bool powers) {
    return from_coordinates(n, 2, [=](Random& random) {
        const double significand = powers ? 1 : 1 + uniform(random);
        const int exponent =
            static_cast<int>(random() % static_cast<unsigned>(spread + 1)) - spread / 2;
        return std::ldexp(random() % 2 == 0 ? significand : -significand, exponent);
    });
}

// Few values, the largest and the least there are among them: differences that overflow, and ties.
inline Points ends_of_range(std::size_t n) {
    static const double values[] = {0,
                                    1,
                                    -1,
                                    1e308,
                                    -1e308,
                                    0x1.fffffffffffffp1023,
                                    -0x1.fffffffffffffp1023,
                                    0x1p-1074,
                                    -0x1p-1074,
                                    0x1p-1022};
    return from_coordinates(n, 3, [](Random& random) { return values[random() % 10]; });
}

inline Points two_clusters(std::size_t n, double distance) {
    Points xyz = from_coordinates(n, 4, uniform);
    for (std::size_t i = 0; i < n / 2; ++i) xyz[3 * i] += distance;
    return xyz;
}

// Subnormals about a point of ordinary size.
inline Points subnormals_and_units(std::size_t n) {
    return from_coordinates(n, 5, [](Random& random) {
        return random() % 2 == 0 ? static_cast<double>(random() % 9) * 0x1p-1074
                                 : static_cast<double>(random() % 5) / 4;
    });
}

// Ten planes with random points in each.
inline Points layers(std::size_t n) {
    Points xyz = from_coordinates(n, 6, uniform);
    for (std::size_t i = 0; i < n; ++i) xyz[3 * i + 2] = static_cast<double>(i % 10) / 10;
    return xyz;
}

inline Points helix(std::size_t n) {
    Points xyz;
    for (std::size_t i = 0; i < n; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(n);
        xyz.insert(xyz.end(), {std::cos(120 * t), std::sin(120 * t), 10 * t});
    }
    return xyz;
}

// The first n of all integer points on the sphere of this radius about the origin, shuffled. For
// odd radii with prime factors 3 modulo 4 there are many: 4,230 for 231, 77,220 for 4,389,
// 1,842,750 for 100,947.
inline Points integer_sphere(std::size_t n, std::int64_t radius) {
    std::vector<std::int64_t> found;
    // 0 <= x <= y <= z, then all signs and orders.
    for (std::int64_t x = 0; 3 * x * x <= radius * radius; ++x) {
        const std::int64_t rest = radius * radius - x * x;
        std::int64_t z = radius;
        for (std::int64_t y = x; 2 * y * y <= rest; ++y) {
            while (y * y + z * z > rest) --z;
            if (y * y + z * z != rest) continue;
            std::int64_t p[3] = {x, y, z};
            do
                for (int signs = 0; signs < 8; ++signs) {
                    bool is_new = true;
                    for (int k = 0; k < 3; ++k) is_new &= p[k] != 0 || !(signs >> k & 1);
                    if (!is_new) continue;
                    for (int k = 0; k < 3; ++k) found.push_back(signs >> k & 1 ? -p[k] : p[k]);
                }
            while (std::next_permutation(p, p + 3));
        }
    }
    std::vector<std::size_t> order(found.size() / 3);
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    Random random(7);
    for (std::size_t i = order.size(); i > 1; --i) std::swap(order[i - 1], order[random() % i]);
    Points xyz;
    for (std::size_t i = 0; i < std::min(n, order.size()); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            xyz.push_back(static_cast<double>(found[3 * order[i] + k]));
    return xyz;
}

inline Points moment_curve(std::size_t n) {
    Points xyz;
    for (std::size_t i = 0; i < n; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(n);
        xyz.insert(xyz.end(), {t, t * t, t * t * t});
    }
    return xyz;
}

}  // namespace faults
