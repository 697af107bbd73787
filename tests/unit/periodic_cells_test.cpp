// SPDX-License-Identifier: MIT
// Points in periodic boxes as callers see them: offsets, and Voronoi cells.
#include "periodic/periodic_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "cells_and_rationals.hpp"
#include "periodic_built.hpp"
#include "unwatched.hpp"

namespace mgdt {
namespace {

double determinant(const std::vector<double>& v) {
    return std::fabs(v[0] * (v[4] * v[8] - v[5] * v[7]) - v[1] * (v[3] * v[8] - v[5] * v[6]) +
                     v[2] * (v[3] * v[7] - v[4] * v[6]));
}

TEST(Periodic, CrystalsHaveTheirCells) {
    struct Crystal {
        const char* name;
        std::vector<double> points;
        double faces;
    };
    const std::vector<Crystal> crystals = {
        {"simple cubic", {0, 0, 0}, 6},
        {"body-centred", {0, 0, 0, 0.5, 0.5, 0.5}, 14},
        {"face-centred", {0, 0, 0, 0.5, 0.5, 0, 0.5, 0, 0.5, 0, 0.5, 0.5}, 12},
        {"diamond",
         {0,    0,    0,    0.5,  0.5,  0,    0.5,  0,    0.5,  0,    0.5,  0.5,
          0.25, 0.25, 0.25, 0.75, 0.75, 0.25, 0.75, 0.25, 0.75, 0.25, 0.75, 0.75},
         16},
    };
    for (const Crystal& crystal : crystals) {
        SCOPED_TRACE(crystal.name);
        const Built built(cube, crystal.points);
        const double share = 3.0 / static_cast<double>(crystal.points.size());
        for (const double volume : built.measures(Measure::volume)) EXPECT_DOUBLE_EQ(volume, share);
        for (const double faces : built.measures(Measure::faces)) EXPECT_EQ(faces, crystal.faces);
    }
}

TEST(Periodic, CellsFillTheBox) {
    for (const std::vector<double>& box : {cube, oblique})
        for (const std::size_t n : {1u, 2u, 9u, 500u}) {
            const Built built(box, random_points(n, box, 7));
            double sum = 0;
            for (const double volume : built.measures(Measure::volume)) sum += volume;
            EXPECT_NEAR(sum, determinant(box), 1e-14 * determinant(box) * 8);
        }
}

// Corners are where offsets say, and the tetrahedra have the volume of the box.
TEST(Periodic, OffsetsGivePlaces) {
    for (const std::vector<double>& box : {cube, oblique}) {
        const Built built(box, random_points(200, box, 3));
        double sum = 0;
        for (std::size_t i = 0; i < built.tetrahedra().size(); ++i) {
            std::array<double, 3> x[4];
            for (unsigned k = 0; k < 4; ++k) {
                const Image image = built.tetrahedra()[i].corners[k];
                x[k] = built.place(image.point,
                                   built.shift_from(built.tetrahedra()[i].corners[0].point, image));
            }
            double v[3][3];
            for (unsigned k = 0; k < 3; ++k)
                for (unsigned c = 0; c < 3; ++c) v[k][c] = x[k + 1][c] - x[0][c];
            sum += v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) -
                   v[0][1] * (v[1][0] * v[2][2] - v[1][2] * v[2][0]) +
                   v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
        }
        EXPECT_NEAR(sum / 6, determinant(box), 1e-12);
    }
}

// The vectors that are returned are doubles, and the basis is an exact combination of them, however
// oblique they are. So offsets and arrays give the exact places.
TEST(Periodic, ObliqueVectorsAreExact) {
    using exact_cells::Rational;
    std::mt19937 random(31);
    std::uniform_real_distribution<double> place(-1, 1);
    int built = 0;
    for (int round = 0; round < 300; ++round) {
        double v[3][3];
        for (auto& vector : v)
            for (double& x : vector) x = place(random);
        const int most = round % 3 == 0 ? 3 : round % 3 == 1 ? 100 : 3000;
        for (unsigned step = 0; step < 3; ++step) {
            const std::size_t i = random() % 3, j = (i + 1 + random() % 2) % 3;
            const double times =
                static_cast<int>(random() % static_cast<unsigned>(2 * most + 1)) - most;
            for (unsigned c = 0; c < 3; ++c) v[i][c] += times * v[j][c];
        }
        if (round == 0) {
            const double vectors[3][3] = {{.1, 55635.6, 0}, {0, .1, 0}, {0, 18450.4, .1}};
            std::copy_n(vectors[0], 9, v[0]);
        }
        try {
            const BoxLattice lattice(3, v[0]);
            const ImageGrid grid(lattice, PointReach(lattice));
            const BoxLattice& rounded = grid.lattice();
            for (unsigned k = 0; k < 3; ++k) {
                Multiples one = {};
                one[k] = 1;
                const std::array<std::int64_t, 3> times = rounded.multiples_of_callers(one);
                for (unsigned c = 0; c < 3; ++c) {
                    Rational sum = 0;
                    for (unsigned j = 0; j < 3; ++j)
                        sum += Rational(times[j]) * Rational(rounded.callers_vector(j)[c]);
                    EXPECT_EQ(sum, Rational(rounded.vector(k)[c]));
                    EXPECT_NEAR(rounded.callers_vector(k)[c],
                                std::scalbn(v[k][c], -lattice.exponent()), grid.unit(c));
                }
            }
            ++built;
        } catch (const Error& e) {
            EXPECT_EQ(e.status, MGDT_ERR_INVALID_ARGUMENT);
        }
    }
    EXPECT_GT(built, 200);
}

// The same set, with points at other images and by another basis of the lattice.
TEST(Periodic, DoesNotDependOnTheImagesThatAreGiven) {
    const auto tetrahedra_of = [](const Built& built) {
        std::set<std::vector<double>> all;
        for (std::size_t i = 0; i < built.tetrahedra().size(); ++i) {
            std::vector<double> relative;
            const PeriodicTetrahedra::Tetrahedron t = built.tetrahedra()[i];
            const Image* const corners = t.corners;
            const auto first = built.place(corners[0].point, {});
            for (unsigned k = 0; k < 4; ++k) {
                const auto x =
                    built.place(corners[k].point, built.shift_from(corners[0].point, corners[k]));
                relative.push_back(corners[k].point);
                for (unsigned c = 0; c < 3; ++c) relative.push_back(x[c] - first[c]);
            }
            all.insert(relative);
        }
        return all;
    };
    // Multiples of 2^-10, so that all sums are exact; and few, so that there are ties.
    for (const double grid : {1024.0, 4.0}) {
        std::vector<double> points = random_points(100, oblique, 5);
        for (double& x : points) x = std::floor(x * grid) / grid;
        const auto expected = tetrahedra_of(Built(oblique, points));
        EXPECT_GT(expected.size(), 100u);
        std::mt19937 random(1);
        std::vector<double> moved = points;
        for (std::size_t i = 0; i < moved.size(); i += 3)
            for (unsigned k = 0; k < 3; ++k) {
                const double times = static_cast<double>(random() % 2001) - 1000;
                for (unsigned c = 0; c < 3; ++c) moved[i + c] += times * oblique[3 * k + c];
            }
        EXPECT_TRUE(tetrahedra_of(Built(oblique, moved)) == expected);
        std::vector<double> basis = oblique;
        for (unsigned c = 0; c < 3; ++c) {
            basis[c] = -oblique[3 + c];
            basis[3 + c] = oblique[c] + 3 * oblique[6 + c];
            basis[6 + c] = oblique[6 + c] - 2 * basis[3 + c];
        }
        EXPECT_TRUE(tetrahedra_of(Built(basis, points)) == expected);
    }
}

// Two points that change the ends of what is allowed. A sanitizer of undefined behaviour sees
// whether the differences of their multiples fit.
TEST(Periodic, StepsMayBeAsFarAsPointsMayBe) {
    const double far = 0x1p29;
    const std::vector<double> before = {-far, -far, -far, far - 0.5, far - 0.5, far - 0.5},
                              after = {far, far, far, 0.5 - far, 0.5 - far, 0.5 - far};
    Built built(cube, before);
    const std::uint32_t both[2] = {0, 1};
    built.move(2, both, after.data());
    built.build();
    EXPECT_EQ(built.tetrahedra().size(), 12u);
}

// Centroids of the cells in a cluster are as accurate, in units of the cell, as those of the same
// cells at the origin.
TEST(Periodic, CentroidsInClusters) {
    for (const double size : {1e-3, 1e-6, 1e-9}) {
        SCOPED_TRACE(size);
        std::mt19937 random(5);
        std::uniform_real_distribution<double> place(0, 1);
        std::vector<double> points;
        for (int i = 0; i < 12; ++i)
            for (int c = 0; c < 3; ++c)
                points.push_back(std::round(std::ldexp(0.3 + size * place(random), 44)) * 0x1p-44);
        const Built built(cube, points);
        const std::vector<double> centroids = built.measures(Measure::centroid);
        double worst = 0;
        for (std::size_t p = 0; p < 12; ++p) {
            std::vector<double> around = {0, 0, 0};
            for (int x = -1; x <= 1; ++x)
                for (int y = -1; y <= 1; ++y)
                    for (int z = -1; z <= 1; ++z)
                        for (std::size_t q = 0; q < 12; ++q) {
                            const int of[3] = {x, y, z};
                            if (p == q && x == 0 && y == 0 && z == 0) continue;
                            for (std::size_t c = 0; c < 3; ++c)
                                around.push_back(points[3 * q + c] - points[3 * p + c] + of[c]);
                        }
            const std::vector<double> at_origin = measures_of_cells(around, Measure::centroid, {});
            // In units of the distance of the farthest corner, which is at least the centroid's.
            double distance = 0, error = 0;
            for (std::size_t c = 0; c < 3; ++c) {
                distance = std::max(distance, std::fabs(at_origin[c]));
                error = std::max(error, std::fabs(centroids[3 * p + c] - at_origin[c]));
            }
            worst = std::max(worst, error / std::max(distance, 1e-2 * size));
        }
        EXPECT_LT(worst, 1e-11);
    }
}

TEST(Periodic, MovesAndRefuses) {
    std::vector<double> points = random_points(50, cube, 2);
    Built built(cube, points);
    const std::size_t before = built.tetrahedra().size();
    std::vector<std::uint32_t> all;
    std::vector<double> moved = points;
    for (std::uint32_t i = 0; i < 50; ++i) all.push_back(i);
    std::mt19937 random(4);
    for (double& x : moved) x += 1e-9 * static_cast<double>(random() % 100);
    built.move(50, all.data(), moved.data());
    EXPECT_FALSE(built.has_triangulation());
    built.build();
    EXPECT_EQ(built.tetrahedra().size(), before);
    const std::uint32_t none = 50;
    try {
        built.move(1, &none, moved.data());
        ADD_FAILURE();
    } catch (const Error& e) {
        EXPECT_EQ(e.status, MGDT_ERR_INVALID_ARGUMENT);
        EXPECT_STREQ(e.message, "there is no point 50");
    }
    const double far[3] = {0.5, -1e15, 0.5};
    built.insert(1, far);
    try {
        built.build();
        ADD_FAILURE();
    } catch (const Error& e) {
        EXPECT_STREQ(e.message, "point 50 is more than 536870912 boxes away from the box");
    }
    EXPECT_FALSE(built.has_triangulation());
    built.clear();
    built.build();
    EXPECT_EQ(built.tetrahedra().size(), 0u);
    // Points with the same images are one vertex.
    const double same[9] = {0.25, 0.5, 0.75, 3.25, -1.5, 0.75, 0.25, 0.5, 0.25};
    built.insert(3, same);
    built.build();
    EXPECT_EQ(built.vertex_of(0), 0u);
    EXPECT_EQ(built.vertex_of(1), 0u);
    EXPECT_EQ(built.vertex_of(2), 2u);
    built.stop().set();
    EXPECT_THROW(built.build(), Error);
    built.build();
}

void expect_same_tetrahedra(const Built& built, const Built& fresh) {
    ASSERT_EQ(built.tetrahedra().size(), fresh.tetrahedra().size());
    for (std::size_t t = 0; t < fresh.tetrahedra().size(); ++t)
        for (unsigned k = 0; k < 4; ++k) {
            const Image a = built.tetrahedra()[t].corners[k], b = fresh.tetrahedra()[t].corners[k];
            ASSERT_TRUE(a.point == b.point && a.multiples() == b.multiples());
        }
}

// After each time step, the triangulation is that of the points, as if they were given anew.
TEST(Periodic, StepsGiveWhatAFreshBuildGives) {
    std::mt19937 random(12);
    std::normal_distribution<double> step(0, 0.02);
    for (const std::vector<double>& box : {cube, oblique}) {
        std::vector<double> points = random_points(300, box, 6);
        Built built(box, points);
        std::vector<std::uint32_t> all(300);
        for (std::uint32_t i = 0; i < 300; ++i) all[i] = i;
        for (int i = 0; i < 20; ++i) {
            for (double& x : points) x += i == 10 ? 30 * step(random) : step(random);
            // In two calls, as the next build uses the images of the last one.
            built.move(100, all.data(), points.data());
            built.move(200, all.data() + 100, points.data() + 300);
            built.build();
            const Built fresh(box, points);
            expect_same_tetrahedra(built, fresh);
        }
    }
}

// Points that come together in a step are one vertex, also where the images of the greater one are
// expected and those of the other one are not.
TEST(Periodic, StepsMayUnitePoints) {
    std::mt19937 random(14);
    std::uniform_real_distribution<double> place(0, 1);
    for (const std::vector<double>& box : {cube, {1, 0, 0, 0, 2, 0}})
        for (int i = 0; i < 200; ++i) {
            // A few points near the middle, and one that was elsewhere and joins one of them.
            std::vector<double> points;
            for (int k = 0; k < 18; ++k) points.push_back(0.5 + 0.05 * place(random));
            const std::uint32_t moving = 5;
            for (std::size_t c = 15; c < 18; ++c) points[c] = place(random);
            Built built(box, points);
            std::copy_n(points.begin() + 3 * (i % 5), 3, points.begin() + 15);
            built.move(1, &moving, points.data() + 15);
            built.build();
            check_periodic(built, Unwatched());
            const Built fresh(box, points);
            expect_same_tetrahedra(built, fresh);
        }
}

}  // namespace
}  // namespace mgdt
