// SPDX-License-Identifier: MIT
// Points of a box that become equal, beside a comparison of all images.
#include "periodic/merging.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "periodic_built.hpp"
#include "unwatched.hpp"

namespace mgdt {
namespace {

struct Merged : Periodic {
    Merged(const std::vector<double>& vectors, const std::vector<double>& points, double distance)
        : Periodic(nullptr, nullptr, nullptr) {
        set_vectors(static_cast<unsigned>(vectors.size() / 3), vectors.data());
        settings().merge_distance = distance;
        insert(points.size() / 3, points.data());
        build();
        check_periodic(*this, Unwatched());
    }
};

using Offset = std::array<std::int64_t, 3>;

// The multiples with which an image of the first point is within the distance of the second.
bool find_near_image(const std::vector<double>& vectors, const double* first, const double* second,
                     double distance, Offset& of) {
    const auto most = [&](unsigned k) { return k < vectors.size() / 3 ? 5 : 0; };
    for (std::int64_t i = -most(0); i <= most(0); ++i)
        for (std::int64_t j = -most(1); j <= most(1); ++j)
            for (std::int64_t k = -most(2); k <= most(2); ++k) {
                const std::int64_t multiples[3] = {i, j, k};
                long double sum = 0;
                for (unsigned c = 0; c < 3; ++c) {
                    long double d = static_cast<long double>(first[c]) - second[c];
                    for (std::size_t v = 0; v < vectors.size() / 3; ++v)
                        d += static_cast<long double>(multiples[v]) * vectors[3 * v + c];
                    sum += d * d;
                }
                if (sum > static_cast<long double>(distance) * distance) continue;
                of = {i, j, k};
                return true;
            }
    return false;
}

TEST(Merging, LatticeWithBothSides) {
    for (const std::vector<double>& shape :
         {cube, oblique, std::vector<double>{0, 0.5, 0.5, 0.5, 0, 0.5, 0.5, 0.5, 0}}) {
        std::vector<double> points, vectors = shape;
        for (double& x : vectors) x *= 14.44;
        for (int i = 0; i < 125; ++i) {
            const double s[3] = {0.25 * (i % 5), 0.25 * (i / 5 % 5), 0.25 * (i / 25)};
            for (unsigned c = 0; c < 3; ++c)
                points.push_back(s[0] * vectors[c] + s[1] * vectors[3 + c] + s[2] * vectors[6 + c]);
        }
        const Merged box(vectors, points, 1e-9);
        EXPECT_EQ(box.vertex_count(), 64u);
        std::vector<double> volumes(125);
        export_periodic_measures(box, Measure::volume, Unwatched(), volumes.data());
        const double expected = std::fabs(volumes[0]);
        for (std::uint32_t p = 0; p < 125; ++p)
            if (box.vertex_of(p) == p) {
                EXPECT_NEAR(volumes[p], expected, 1e-9 * expected);
            }
    }
}

TEST(Merging, NearImages) {
    for (const std::vector<double>& vectors :
         {cube, oblique, std::vector<double>{4, 0, 0, 1.5, 3, 0}, std::vector<double>{0, 2, 1}})
        for (const double distance : {1e-12, 1e-3, 0.1}) {
            std::vector<double> points = random_points(40, vectors, 5);
            std::mt19937 random(9);
            std::uniform_real_distribution<double> noise(-distance, distance);
            std::uniform_int_distribution<int> multiple(-2, 2);
            for (std::size_t i = 0; i < 3 * 40; i += 3) {
                const double x[3] = {points[i], points[i + 1], points[i + 2]};
                double moved[3];
                const int k[3] = {multiple(random), multiple(random), multiple(random)};
                for (unsigned c = 0; c < 3; ++c) {
                    moved[c] = x[c] + noise(random);
                    for (std::size_t v = 0; v < vectors.size() / 3; ++v)
                        moved[c] += k[v] * vectors[3 * v + c];
                }
                points.insert(points.end(), moved, moved + 3);
            }
            const Merged box(vectors, points, distance);
            std::vector<std::uint32_t> leaders;
            std::size_t merged = 0;
            for (std::uint32_t p = 0; p < 80; ++p) {
                std::uint32_t expected = p;
                Offset of = {};
                for (const std::uint32_t leader : leaders) {
                    // Near the limit, rounding may decide.
                    Offset unsure;
                    const double *const a = &points[3 * leader], *const b = &points[3 * p];
                    if (!find_near_image(vectors, a, b, distance, of)) {
                        ASSERT_FALSE(distance > 1e-6 &&
                                     find_near_image(vectors, a, b, distance * 1.0001, unsure));
                        continue;
                    }
                    expected = leader;
                    break;
                }
                if (distance > 1e-6) {
                    ASSERT_EQ(box.vertex_of(p), expected) << p;
                }
                const std::uint32_t vertex = box.vertex_of(p);
                if (vertex == p) {
                    leaders.push_back(p);
                    continue;
                }
                ++merged;
                // The offset leads from the vertex to the point.
                ASSERT_TRUE(find_near_image(vectors, &points[3 * vertex], &points[3 * p],
                                            1.01 * distance, of));
                const Offset found = box.shift_from(p, {vertex, {}});
                EXPECT_EQ(found, of) << p;
            }
            EXPECT_GT(merged, 15u);
        }
}

TEST(Merging, RefusesLargeDistances) {
    const std::vector<double> points = random_points(10, oblique, 1);
    Periodic box(nullptr, nullptr, nullptr);
    box.set_vectors(3, oblique.data());
    box.insert(10, points.data());
    box.settings().merge_distance = 1;
    try {
        box.build();
        FAIL();
    } catch (const Error& e) {
        EXPECT_EQ(e.status, MGDT_ERR_INVALID_ARGUMENT);
        EXPECT_NE(std::string(e.message).find("an eighth of the box"), std::string::npos);
    }
    box.settings().merge_distance = 0;
    box.build();
}

}  // namespace
}  // namespace mgdt
