// SPDX-License-Identifier: MIT
// Points with integral coordinates in periodic boxes, beside integers of 128 bits: the tetrahedra
// fill the box exactly, and none has an image of a point in its perturbed circumsphere.
#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <random>
#include <string>

#include "../support/small.h"
#include "mgdt/mgdt.hpp"
#include "oracle.hpp"

namespace {

using Integer = boost::multiprecision::int128_t;
using Place = oracle::Point<Integer>;

struct Box {
    const char* name;
    std::array<double, 9> vectors;
};

const std::array<Box, 5> boxes = {{{"cube", {64, 0, 0, 0, 64, 0, 0, 0, 64}},
                                   {"needle", {3200, 0, 0, 0, 32, 0, 0, 0, 32}},
                                   {"skewed", {64, 0, 0, 1000, 64, 0, 333, -777, 64}},
                                   {"flat", {64, 0, 0, 0, 64, 0, 31, 33, 1}},
                                   {"turned needle", {1000, 1001, 999, 9, -8, 0, 3, 4, -8}}}};

class Examination {
  public:
    Examination(const Box& box, const std::vector<double>& xyz)
        : box_(box), xyz_(xyz), p_(box.vectors) {
        p_.insert(xyz);
        p_.build();
        tetrahedra_ = p_.array(mgdt::PeriodicArray::tetrahedra);
        offsets_ = p_.array(mgdt::PeriodicArray::tetrahedron_shifts);
        neighbors_ = p_.array(mgdt::PeriodicArray::neighbors);
        neighbor_offsets_ = p_.array(mgdt::PeriodicArray::neighbor_shifts);
    }
    void run(int copies) {
        const std::vector<mgdt::Point> points = p_.points();
        for (std::size_t i = 0; i < xyz_.size(); ++i)
            ASSERT_EQ(points[i / 3][i % 3], xyz_[i]);  // nothing was rounded
        Integer sum = 0;
        for (std::size_t t = 0; t < count(); ++t) {
            const auto corners = corners_of(t);
            const Integer volume = oracle::volume(corners[0], corners[1], corners[2], corners[3]);
            ASSERT_GT(volume, 0);
            sum += volume;
            for (std::size_t k = 0; k < 4; ++k) examine_side(t, k);
            if (copies > 0) examine_copies(corners, copies);
        }
        const Place a = vector(0), b = vector(1), c = vector(2);
        const Integer determinant = oracle::dot(oracle::cross(a, b), c);
        EXPECT_EQ(sum, 6 * (determinant < 0 ? Integer(-determinant) : determinant));
        EXPECT_EQ(
            p_.statistic(mgdt::PeriodicStatistic::edges),
            p_.statistic(mgdt::PeriodicStatistic::vertices) + static_cast<std::int64_t>(count()));
    }

  private:
    std::size_t count() const { return tetrahedra_.size() / 4; }
    Place vector(std::size_t k) const {
        Place v;
        for (std::size_t c = 0; c < 3; ++c) v[c] = Integer(box_.vectors[3 * k + c]);
        return v;
    }
    // A point of the caller plus multiples of the vectors.
    Place place(std::size_t point, const std::array<std::int64_t, 3>& of) const {
        Place x;
        for (std::size_t c = 0; c < 3; ++c) {
            x[c] = Integer(xyz_[3 * point + c]);
            for (std::size_t k = 0; k < 3; ++k) x[c] += of[k] * vector(k)[c];
        }
        return x;
    }
    std::array<Place, 4> corners_of(std::size_t t, std::array<std::int64_t, 3> moved = {}) const {
        std::array<Place, 4> corners;
        for (std::size_t k = 0; k < 4; ++k) {
            std::array<std::int64_t, 3> of = moved;
            for (std::size_t c = 0; c < 3; ++c) of[c] += offsets_[12 * t + 3 * k + c];
            corners[k] = place(static_cast<std::size_t>(tetrahedra_[4 * t + k]), of);
        }
        return corners;
    }
    // The neighbour has the same facet, and its fourth corner is beyond it and outside.
    void examine_side(std::size_t t, std::size_t side) {
        const std::size_t at = 4 * t + side;
        std::array<std::int64_t, 3> moved;
        for (std::size_t c = 0; c < 3; ++c) moved[c] = neighbor_offsets_[3 * at + c];
        const auto corners = corners_of(t);
        const auto others = corners_of(static_cast<std::size_t>(neighbors_[at]), moved);
        std::size_t shared = 0;
        for (const Place& x : others) {
            bool is_shared = false;
            for (std::size_t k = 0; k < 4; ++k)
                is_shared = is_shared || (k != side && corners[k] == x);
            if (is_shared) {
                ++shared;
                continue;
            }
            EXPECT_EQ(oracle::side_of_sphere(corners, x), -1);
            auto turned = corners;
            turned[side] = x;
            EXPECT_EQ(oracle::orientation(turned[0], turned[1], turned[2], turned[3]), -1);
        }
        EXPECT_EQ(shared, 3u);
    }
    void examine_copies(const std::array<Place, 4>& corners, int copies) const {
        std::array<std::int64_t, 3> of;
        for (of[0] = -copies; of[0] <= copies; ++of[0])
            for (of[1] = -copies; of[1] <= copies; ++of[1])
                for (of[2] = -copies; of[2] <= copies; ++of[2])
                    for (std::size_t point = 0; point < xyz_.size() / 3; ++point) {
                        const Place x = place(point, of);
                        const bool is_corner =
                            std::find(corners.begin(), corners.end(), x) != corners.end();
                        EXPECT_TRUE(is_corner || oracle::side_of_sphere(corners, x) < 0);
                    }
    }

    const Box& box_;
    const std::vector<double>& xyz_;
    mgdt::Periodic p_;
    std::vector<std::int64_t> tetrahedra_, offsets_, neighbors_, neighbor_offsets_;
};

// `range` small: ties; large: none.
std::vector<double> random_points(std::size_t n, int range, int factor) {
    std::mt19937 random(static_cast<unsigned>(n) + 7);
    std::vector<double> xyz;
    for (std::size_t i = 0; i < 3 * n; ++i)
        xyz.push_back(static_cast<double>(factor * static_cast<int>(random() % unsigned(range))));
    return xyz;
}

TEST(PeriodicIntegers, BoxesOfAllShapes) {
    for (const Box& box : boxes)
        for (const std::size_t n : {1u, 2u, 3u, 5u, 8u, 100u, 10000u}) {
            if (n > 100 && is_small()) continue;
            SCOPED_TRACE(std::string(box.name) + ", " + std::to_string(n));
            Examination(box, random_points(n, 1 << 12, 1)).run(n <= 5 ? 4 : 0);
            if (n <= 100) Examination(box, random_points(n, 5, 16)).run(n <= 3 ? 4 : 0);
        }
}

// Cubic, body-centred, face-centred and diamond lattices from their cubes, where all is tied.
TEST(PeriodicIntegers, Crystals) {
    const Box cube = {"cube", {4, 0, 0, 0, 4, 0, 0, 0, 4}};
    std::vector<double> xyz = {0, 0, 0};
    Examination(cube, xyz).run(3);
    xyz.insert(xyz.end(), {2, 2, 2});
    Examination(cube, xyz).run(3);
    xyz = {0, 0, 0, 0, 2, 2, 2, 0, 2, 2, 2, 0};
    Examination(cube, xyz).run(3);
    for (std::size_t i = 0; i < 12; ++i) xyz.push_back(xyz[i] + 1);
    Examination(cube, xyz).run(3);
}

}  // namespace
