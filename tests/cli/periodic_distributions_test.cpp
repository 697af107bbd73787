// SPDX-License-Identifier: MIT
// Every kind of points that the program generates, in periodic boxes, slabs and wires: the check
// accepts the result, its numbers are those of a torus, and cells fill the box.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "../support/small.h"
#include "cli/point_sets/distributions.hpp"
#include "mgdt/mgdt.hpp"

namespace mgdt::cli {
namespace {

// Sets with quadratic numbers of tetrahedra are small.
std::size_t size_of(const std::string& kind) {
    if (kind == "moment-curve" || kind == "two-lines" || kind == "integer-sphere") return 60;
    return is_small() ? 150 : 1000;
}

// Vectors a little longer than the points reach, along the axes or oblique.
std::vector<double> vectors_around(const std::vector<double>& xyz, bool is_oblique) {
    std::vector<double> v(9);
    for (std::size_t k = 0; k < 3; ++k) {
        double low = xyz[k], high = xyz[k];
        for (std::size_t i = k; i < xyz.size(); i += 3) {
            low = std::min(low, xyz[i]);
            high = std::max(high, xyz[i]);
        }
        v[4 * k] = high > low ? 1.125 * (high - low) : 1;
    }
    // Boxes that are thinner than 2^-38 of their size are refused.
    const double longest = std::max({v[0], v[4], v[8]});
    for (std::size_t k = 0; k < 3; ++k) v[4 * k] = std::max(v[4 * k], 1e-9 * longest);
    if (is_oblique) {
        v[3] = 0.25 * v[0];
        v[6] = -0.375 * v[0];
        v[7] = 0.25 * v[4];
    }
    return v;
}

void expect_right(const std::vector<double>& xyz, const std::vector<double>& vectors) {
    Periodic p(vectors);
    p.insert(xyz);
    p.build();
    p.check();
    const std::int64_t tetrahedra = p.statistic(PeriodicStatistic::tetrahedra);
    if (vectors.size() < 9) return;
    EXPECT_EQ(p.statistic(PeriodicStatistic::edges),
              p.statistic(PeriodicStatistic::vertices) + tetrahedra);
    double sum = 0;
    for (const double v : p.cell_measures(Measure::volume)) sum += v;
    const double box = vectors[0] * vectors[4] * vectors[8];  // both shapes are triangular
    EXPECT_NEAR(sum, box, 1e-9 * box);
}

TEST(PeriodicDistributions, AreRight) {
    for (const Distribution& distribution : distributions()) {
        const std::string kind = distribution.name;
        SCOPED_TRACE(kind);
        GenerateOptions options;
        options.data_directory = MGDT_TEST_DATA_DIRECTORY;
        const std::vector<double> xyz = generate(kind, size_of(kind), options);
        if (kind == "nan" || kind == "infinity") {
            Periodic p(vectors_around({0, 0, 0, 1, 1, 1}, false));
            EXPECT_THROW(p.insert(xyz), Error);
            EXPECT_EQ(p.statistic(PeriodicStatistic::points), 0);
            continue;
        }
        for (const bool is_oblique : {false, true}) {
            std::vector<double> vectors = vectors_around(xyz, is_oblique);
            for (std::size_t dimensions = 3; dimensions > 0; --dimensions) {
                vectors.resize(3 * dimensions);
                expect_right(xyz, vectors);
            }
        }
    }
}

TEST(PeriodicDistributions, AtAllScales) {
    for (const double scale : {1e-290, 1e-60, 1e60, 1e290}) {
        SCOPED_TRACE(scale);
        GenerateOptions options;
        options.scale = scale;
        std::vector<double> xyz = generate("uniform", 200, options);
        Periodic p(vectors_around(xyz, true));
        p.insert(xyz);
        p.build();
        p.check();
        EXPECT_EQ(p.statistic(PeriodicStatistic::vertices), 200);
        EXPECT_EQ(p.statistic(PeriodicStatistic::edges),
                  200 + p.statistic(PeriodicStatistic::tetrahedra));
    }
}

}  // namespace
}  // namespace mgdt::cli
