// SPDX-License-Identifier: MIT
// Generated points as tests look at them.
// MGDT_TEST_DATA_DIRECTORY is the folder of machine.msh and church.msh.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "cli/point_sets/distributions.hpp"
#include "cli/point_sets/random_points.hpp"

namespace mgdt::cli {

inline GenerateOptions with_seed(std::uint64_t seed) {
    GenerateOptions options;
    options.seed = seed;
    options.data_directory = MGDT_TEST_DATA_DIRECTORY;
    return options;
}

inline Points points_of(const std::string& kind, std::size_t n,
                        const GenerateOptions& options = with_seed(1)) {
    const std::vector<double> xyz = generate(kind, n, options);
    EXPECT_EQ(xyz.size() % 3, 0U);
    Points points;
    for (std::size_t i = 0; i + 2 < xyz.size(); i += 3) {
        points.push_back({xyz[i], xyz[i + 1], xyz[i + 2]});
    }
    return points;
}

inline double distance(const Point& a, const Point& b) {
    return std::sqrt((a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]) +
                     (a[2] - b[2]) * (a[2] - b[2]));
}

inline std::size_t distinct(const Points& points) {
    return std::set<Point>(points.begin(), points.end()).size();
}

}  // namespace mgdt::cli
