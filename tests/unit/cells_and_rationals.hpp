// SPDX-License-Identifier: MIT
// Measures of cells beside those of cells that are cut out of space in rational numbers.
#pragma once

#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <vector>

#include "../support/small.h"
#include "core/triangulation.hpp"
#include "dual/measures.hpp"
#include "exact_cells.hpp"
#include "unwatched.hpp"
#include "voronoi_and_rationals.hpp"

namespace mgdt {

inline std::vector<double> measures_of_cells(const std::vector<double>& xyz, Measure measure,
                                             const std::vector<double>& planes,
                                             std::int32_t scheme = 0, unsigned threads = 1) {
    Triangulation t(nullptr, nullptr, nullptr);
    t.settings().scheme = scheme;
    const std::size_t n = xyz.size() / 3;
    const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
    t.insert(n, axis, 3);
    Team team(threads);
    const MeshView view = {team, t.mesh(), nullptr, t.allocator(), 0, false};
    const Region region(t.allocator(), planes.size() / 4, planes.data(), t.mesh(), 0);
    std::vector<double> x((measure == Measure::centroid ? 3 : 1) * n);
    export_measures(view, region, measure, n, Unwatched(), x.data());
    return x;
}

// Of every `step`-th cell, `far` being more than the distance of any corner of a bounded one.
// Returns how many were bounded.
inline std::size_t compare_cells_with_rationals(const std::vector<double>& xyz,
                                                const std::vector<double>& planes, std::size_t step,
                                                const exact_cells::Rational& far) {
    using exact_cells::Rational;
    const std::vector<double> volumes = measures_of_cells(xyz, Measure::volume, planes),
                              areas = measures_of_cells(xyz, Measure::area, planes),
                              centroids = measures_of_cells(xyz, Measure::centroid, planes),
                              faces = measures_of_cells(xyz, Measure::faces, planes);
    const Rational largest = Rational(DBL_MAX);
    OwnDiagram diagram(xyz, planes);
    std::size_t bounded = 0;
    for (std::size_t k = 0; 3 * k < xyz.size(); k += step) {
        SCOPED_TRACE(k);
        const std::vector<exact_cells::HalfSpace> all = exact_cells::half_spaces(xyz, k, planes);
        const exact_cells::Cell exact = exact_cells::cell(all, far);
        compare_cell_of_diagram(*diagram, xyz, k, all, exact, far);
        EXPECT_EQ(faces[k], exact.faces);
        if (exact.reach > far) {
            EXPECT_TRUE(planes.empty());
            EXPECT_TRUE(std::isinf(volumes[k]) && std::isinf(areas[k]) &&
                        std::isinf(centroids[3 * k]));
            continue;
        }
        ++bounded;
        const Rational bound = Rational(measure_error) * exact.volume;
        const Rational least = Rational(DBL_MIN);
        if (exact.volume > largest)
            EXPECT_TRUE(std::isinf(volumes[k]));
        else
            EXPECT_LE(abs(Rational(volumes[k]) - exact.volume), std::max(bound, least))
                << volumes[k] << " for " << static_cast<double>(exact.volume);
        if (exact.area > 0 && exact.area < DBL_MAX) {
            EXPECT_LE(std::fabs(areas[k] / exact.area - 1), measure_error * (1 + 1e-3))
                << areas[k] << " for " << exact.area;
        }
        for (std::size_t i = 0; i < 3; ++i)
            compare_centroid(centroids[3 * k + i], Rational(xyz[3 * k + i]), exact, i);
    }
    return bounded;
}

}  // namespace mgdt
