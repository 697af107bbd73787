// SPDX-License-Identifier: MIT
// Periodic boxes for tests: random points, and what a build of them gives.
#pragma once

#include <array>
#include <random>
#include <vector>

#include "periodic/periodic_cells.hpp"
#include "periodic/periodic_check.hpp"
#include "unwatched.hpp"

namespace mgdt {

inline const std::vector<double> cube = {1, 0, 0, 0, 1, 0, 0, 0, 1};
inline const std::vector<double> oblique = {4, 0, 0, 1.5, 3, 0, -0.75, 0.5, 2.5};

inline std::vector<double> random_points(std::size_t n, const std::vector<double>& vectors,
                                         unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(-0.5, 1.5);
    std::vector<double> points;
    for (std::size_t i = 0; i < n; ++i) {
        double x[3] = {};
        for (std::size_t k = 0; k < vectors.size() / 3; ++k) {
            const double s = place(random);
            for (unsigned c = 0; c < 3; ++c) x[c] += s * vectors[3 * k + c];
        }
        for (std::size_t k = vectors.size() / 3; k < 3; ++k) x[k] += place(random);
        points.insert(points.end(), x, x + 3);
    }
    return points;
}

struct Built : Periodic {
    Built(const std::vector<double>& vectors, const std::vector<double>& points)
        : Periodic(nullptr, nullptr, nullptr), box(vectors) {
        set_vectors(static_cast<unsigned>(vectors.size() / 3), vectors.data());
        insert(points.size() / 3, points.data());
        build();
        check_periodic(*this, Unwatched());
    }
    std::array<double, 3> place(std::uint32_t point, const std::array<std::int64_t, 3>& of) const {
        double x[3];
        rounded(point, x);
        for (std::size_t k = 0; k < box.size() / 3; ++k)
            for (unsigned c = 0; c < 3; ++c) x[c] += static_cast<double>(of[k]) * box[3 * k + c];
        return {x[0], x[1], x[2]};
    }
    std::vector<double> measures(Measure measure) const {
        std::vector<double> x((measure == Measure::centroid ? 3 : 1) * point_count());
        export_periodic_measures(*this, measure, Unwatched(), x.data());
        return x;
    }
    std::vector<double> box;
};

}  // namespace mgdt
