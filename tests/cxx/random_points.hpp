// SPDX-License-Identifier: MIT
// Points and measures that the tests of the C++ interface share.
#pragma once

#include <array>
#include <cstdint>
#include <mgdt/mgdt.hpp>
#include <random>
#include <vector>

#include "../support/small.h"

namespace cxx_test {

// The cube's corners, then points inside: the hull's volume is 1.
inline std::vector<mgdt::Point> points_in_cube(std::size_t n, unsigned seed = 1) {
    std::vector<mgdt::Point> points;
    for (int k = 0; k < 8; ++k)
        points.push_back({double(k & 1), double((k >> 1) & 1), double((k >> 2) & 1)});
    std::mt19937_64 random(seed);
    while (points.size() < n) {
        mgdt::Point p;
        for (double& x : p) x = double(random() >> 11) * 0x1p-53;
        points.push_back(p);
    }
    return points;
}

inline std::size_t size(std::size_t n) {
    return is_small() ? n / 20 + 20 : n;
}

inline std::vector<double> flat(const std::vector<mgdt::Point>& points) {
    std::vector<double> xyz;
    for (const mgdt::Point& p : points) xyz.insert(xyz.end(), p.begin(), p.end());
    return xyz;
}

inline double volume(const mgdt::Point& a, const mgdt::Point& b, const mgdt::Point& c,
                     const mgdt::Point& d) {
    double u[3], v[3], w[3];
    for (std::size_t k = 0; k < 3; ++k) {
        u[k] = b[k] - a[k];
        v[k] = c[k] - a[k];
        w[k] = d[k] - a[k];
    }
    return (w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2]) +
            w[2] * (u[0] * v[1] - u[1] * v[0])) /
           6;
}

inline mgdt::Triangulation triangulated(const std::vector<mgdt::Point>& points) {
    mgdt::Triangulation t;
    t.insert(points);
    return t;
}

// Runs something that must throw an mgdt::Error, and gives its status.
template <class Body>
mgdt_status status_of(Body body) {
    try {
        body();
    } catch (const mgdt::Error& error) {
        return error.status();
    }
    return MGDT_OK;
}

}  // namespace cxx_test
