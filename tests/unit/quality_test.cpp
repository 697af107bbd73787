// SPDX-License-Identifier: MIT
// The quality of tetrahedra, and meshes in the form in which improvement changes them.
#include "improvement/quality.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "flexible_meshes.hpp"
#include "improvable_meshes.hpp"
#include "improvement/quality_gradient.hpp"
#include "predicates/predicates.hpp"
#include "query/tetrahedron_measures.hpp"

namespace mgdt {
namespace {

TEST(Quality, IsTheLeastSine) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    Allocator memory;
    for (int i = 0; i < 1000; ++i) {
        double p[4][3];
        for (auto& point : p)
            for (double& x : point) x = coordinate(random);
        if (i % 10 == 0)  // nearly flat
            for (int k = 0; k < 3; ++k)
                p[3][k] = p[0][k] + (p[1][k] - p[0][k]) * 0.3 + (p[2][k] - p[0][k]) * 0.4 +
                          1e-5 * coordinate(random);
        const double here = quality_of(p[0], p[1], p[2], p[3]),
                     turned = quality_of(p[1], p[0], p[2], p[3]);
        ASSERT_TRUE((here > 0) != (turned > 0));
        const double* const positive[4] = {here > 0 ? p[0] : p[1], here > 0 ? p[1] : p[0], p[2],
                                           p[3]};
        const auto measure = [&](TetrahedronMeasure of) {
            return measure_tetrahedron({positive[0], positive[1], positive[2], positive[3]}, 0, of,
                                       memory);
        };
        const double least = std::sin(measure(TetrahedronMeasure::least_dihedral_angle)),
                     largest = measure(TetrahedronMeasure::largest_dihedral_angle);
        const double expected =
            largest > std::acos(0.0) ? std::min(least, obtuse_weight * std::sin(largest)) : least;
        // Measures of angles are exact to 1e-12, and sines of small angles as well.
        EXPECT_NEAR(std::sqrt(std::max(here, turned)), expected, 1e-9);
    }
}

TEST(Quality, GradientsAreDifferences) {
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    int compared = 0;
    for (int i = 0; i < 1000; ++i) {
        double p[4][3];
        for (auto& point : p)
            for (double& x : point) x = coordinate(random);
        const QualityGradient g = quality_gradient(p[0], p[1], p[2], p[3]);
        ASSERT_NEAR(g.quality, quality_of(p[0], p[1], p[2], p[3]), 1e-12);
        for (int k = 0; k < 3 && g.quality > 1e-3; ++k) {
            constexpr double step = 0x1p-20;
            double q[2];
            for (int s = 0; s < 2; ++s) {
                double at[3] = {p[0][0], p[0][1], p[0][2]};
                at[k] += s == 0 ? -step : step;
                const QualityGradient there = quality_gradient(at, p[1], p[2], p[3]);
                // Where another angle becomes the worst, the gradient jumps.
                if (std::fabs(there.by[k] - g.by[k]) > 0.01 * (1 + std::fabs(g.by[k])))
                    q[s] = NAN;
                else
                    q[s] = there.quality;
            }
            const double by = (q[1] - q[0]) / (2 * step);
            if (std::isnan(by)) continue;
            ++compared;
            EXPECT_NEAR(by, g.by[k], 1e-4 * (1 + std::fabs(g.by[k])));
        }
    }
    EXPECT_GT(compared, 1000);
}

// Tetrahedra whose volume is 0 or negative, but rounds to a positive number.
TEST(Quality, IsPositiveOnlyIfTheVolumeIs) {
    std::mt19937_64 random(9);
    std::uniform_real_distribution<double> coordinate(-1, 1);
    double largest = 0;  // error of a volume, relative to the sum with all terms positive
    const int cases = fewer(200000);
    for (int i = 0; i < cases; ++i) {
        double p[4][3];
        for (auto& point : p)
            for (double& x : point) x = coordinate(random);
        const double s = coordinate(random), t = coordinate(random);
        for (int k = 0; k < 3; ++k)
            p[3][k] = p[0][k] + (p[1][k] - p[0][k]) * s + (p[2][k] - p[0][k]) * t;
        double size;
        const double rounded =
            rounded_volume(difference<double>(p[1], p[0]), difference<double>(p[2], p[0]),
                           difference<double>(p[3], p[0]), size);
        const int sign = orientation(p[0], p[1], p[2], p[3]);
        if (sign <= 0) {
            ASSERT_EQ(quality_of(p[0], p[1], p[2], p[3]), 0);
            if (rounded > 0) largest = std::max(largest, rounded / size);
        }
    }
    // The bound is not much larger than errors are.
    EXPECT_GT(largest, volume_error / 16);
}

TEST(FlexibleMesh, ReadsAndWritesMeshes) {
    for_improvable_meshes([](const SolidMesh& given) {
        Allocator memory;
        const FlexibleMesh mesh(given, one_thread(), memory);
        expect_sound(mesh);
        Copy written(given);
        mesh.write(written.mesh);
        expect_equal(given, written.mesh);
        EXPECT_EQ(given.planar_facets, written.mesh.planar_facets);
        EXPECT_EQ(given.cavities, written.mesh.cavities);
    });
}

}  // namespace
}  // namespace mgdt
