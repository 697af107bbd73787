// SPDX-License-Identifier: MIT
// Sets of points that many tests use.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

namespace mgdt_tests {

using Points = std::vector<double>;  // x y z of each point

// Points that fill a box with a corner at the origin.
inline Points uniform(std::size_t n, std::uint64_t seed = 1, double x_size = 1, double y_size = 1,
                      double z_size = 1) {
    const double size[3] = {x_size, y_size, z_size};
    std::mt19937_64 random(seed);
    Points xyz(3 * n);
    for (std::size_t i = 0; i < 3 * n; ++i)
        xyz[i] = static_cast<double>(random() >> 11) * 0x1p-53 * size[i % 3];
    return xyz;
}

// The n^3 points of a cubic lattice.
inline Points lattice(int n, double spacing = 1) {
    Points xyz;
    for (int i = 0; i < n * n * n; ++i)
        for (const int k : {i % n, i / n % n, i / n / n}) xyz.push_back(spacing * k);
    return xyz;
}

inline Points scaled(Points xyz, double by) {
    for (double& x : xyz) x *= by;
    return xyz;
}

}  // namespace mgdt_tests
