// SPDX-License-Identifier: MIT
// Cells within regions that are hard: planes that are needless, doubled or nearly equal, regions
// that touch their points or are far larger than a cell, and coordinates of any size. Beside
// rational numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <random>
#include <vector>

#include "../support/points.hpp"
#include "../support/small.h"
#include "cells_and_rationals.hpp"

namespace mgdt {
namespace {

using exact_cells::Rational;
using mgdt_tests::Points;

Points box(double half) {
    return {1, 0,  0, half, -1, 0, 0, half, 0, 1, 0,  half,
            0, -1, 0, half, 0,  0, 1, half, 0, 0, -1, half};
}

// The least box around the points.
Points own_box(const Points& xyz) {
    Points planes;
    for (std::size_t k = 0; k < 3; ++k) {
        double low = xyz[k], high = xyz[k];
        for (std::size_t i = k; i < xyz.size(); i += 3) {
            low = std::min(low, xyz[i]);
            high = std::max(high, xyz[i]);
        }
        for (const double sign : {1.0, -1.0}) {
            Points plane = {0, 0, 0, sign > 0 ? high : -low};
            plane[k] = sign;
            planes.insert(planes.end(), plane.begin(), plane.end());
        }
    }
    return planes;
}

Points with(Points planes, const Points& further) {
    planes.insert(planes.end(), further.begin(), further.end());
    return planes;
}

// The corners of a cube.
Points eight(double half) {
    Points xyz;
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < 3; ++k) xyz.push_back(i >> k & 1 ? half : -half);
    return xyz;
}

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
    double within(double size) { return size * (2 * unit() - 1); }
    int integer(int n) { return static_cast<int>(engine_() % static_cast<unsigned>(n)); }
    Points points(std::size_t n, double size = 1) {
        Points xyz(3 * n);
        for (double& x : xyz) x = within(size);
        return xyz;
    }

  private:
    std::mt19937_64 engine_;
};

double sum(const Points& x) {
    double all = 0;
    for (const double v : x) all += v;
    return all;
}

// Within planes the first six of which are nearly a box.
std::size_t compare(const Points& xyz, const Points& planes, std::size_t step) {
    // The rational numbers are nearly all of the time: under Valgrind and the like only ours.
    if (is_small()) {
        for (const Measure m : {Measure::volume, Measure::area, Measure::centroid, Measure::faces})
            EXPECT_GE(sum(measures_of_cells(xyz, m, planes)), -DBL_MAX);
        return xyz.size() / 3 / step + 1;
    }
    double size = 0;
    for (const double x : xyz) size = std::max(size, std::fabs(x));
    for (std::size_t i = 3; i < 24; i += 4) size = std::max(size, std::fabs(planes[i]));
    return compare_cells_with_rationals(xyz, planes, step, Rational(size) * 16);
}

TEST(Regions, NeedlessPlanesChangeNothing) {
    const Points xyz = eight(.15), inner = box(1);
    for (const double far : {1e13, 1e14, 1e40, 1e150, 1e300}) {
        const Points planes = with(inner, {1, 0, 0, far, 0, 1, 0, far, 0, 0, 1, far});
        for (const double volume : measures_of_cells(xyz, Measure::volume, planes))
            EXPECT_NEAR(volume, 1, measure_error) << far;
        for (const double faces : measures_of_cells(xyz, Measure::faces, planes))
            EXPECT_EQ(faces, 6) << far;
    }
}

TEST(Regions, PlanesMayComeAnyNumberOfTimes) {
    const Points xyz = eight(.15), once = box(1);
    Points third = once;
    for (int i = 0; i < 4; ++i) third.push_back(3 * once[static_cast<std::size_t>(12 + i)]);
    for (const Points& planes : {third, with(once, once), with(once, with(once, once))}) {
        for (const Measure m : {Measure::volume, Measure::area, Measure::faces})
            EXPECT_EQ(measures_of_cells(xyz, m, planes), measures_of_cells(xyz, m, once));
        EXPECT_EQ(sum(measures_of_cells(xyz, Measure::faces, planes)), 48);
    }
}

TEST(Regions, NearlyEqualPlanes) {
    const Points xyz = eight(.15);
    for (const double tilt : {1e-9, 1e-14, 1e-16, 1e-40, 1e-300}) {
        SCOPED_TRACE(tilt);
        EXPECT_EQ(compare(xyz, with(box(1), {1, tilt, tilt / 3, 1, 1, -tilt / 7, tilt, 1}), 3), 3u);
    }
}

TEST(Regions, OfAnyNumberOfPlanesOfAnySize) {
    Random random(4);
    for (int run = 0; run < (is_small() ? 2 : 12); ++run) {
        SCOPED_TRACE(run);
        const std::size_t n = run < 11 ? 1 + static_cast<std::size_t>(random.integer(12)) : 100;
        Points planes = box(run % 2 ? 1 : 1.5);
        for (std::size_t k = 0; k < n; ++k) {
            const double size = std::ldexp(1, random.integer(200) - 100);
            double normal[3], length = 0;
            for (double& x : normal) {
                x = random.integer(3) ? random.within(1) : random.integer(3) - 1;
                length += std::fabs(x);
            }
            if (length == 0) normal[0] = length = 1;
            // Far enough for all points; now and then through the corner of one plane and others.
            const double reach = random.integer(4) == 0
                                     ? length
                                     : length + std::ldexp(length, random.integer(80) - 40);
            for (const double x : normal) planes.push_back(x * size);
            planes.push_back(reach * size);
        }
        EXPECT_GT(compare(random.points(8), planes, n == 100 ? 8 : 3), 0u);
    }
}

// A needless plane that touches an edge or a corner of the region has no face, wherever it stands
// among the planes.
TEST(Regions, NeedlessPlanesThatTouchEdges) {
    Random random(11);
    for (int run = 0; run < (is_small() ? 2 : 10); ++run) {
        SCOPED_TRACE(run);
        const Points xyz = random.points(6), planes = box(1);
        Points touching;
        for (int k = 0; k < 4; ++k) {
            double normal[3], length = 0;
            const int zero = random.integer(4);  // 3: at a corner
            for (int i = 0; i < 3; ++i) {
                normal[i] = i == zero ? 0 : 1 + random.integer(8);
                if (random.integer(2) == 0) normal[i] = -normal[i];
                length += std::fabs(normal[i]);
            }
            touching.insert(touching.end(), {normal[0], normal[1], normal[2], length});
        }
        EXPECT_GE(compare(xyz, with(touching, planes), 1), 6u);
        const Points expected = measures_of_cells(xyz, Measure::area, planes);
        for (const Points& all : {with(planes, touching), with(touching, planes)}) {
            const Points areas = measures_of_cells(xyz, Measure::area, all);
            for (std::size_t i = 0; i < areas.size(); ++i)
                EXPECT_NEAR(areas[i], expected[i], 2 * measure_error * expected[i]);
        }
    }
}

// Three of the planes meet in one line, through two of the points.
TEST(Regions, ThreePlanesInOneLine) {
    const Points xyz = {
        0.50209890554931391, 1, 0, 0.80269929304081178, 1, 0, 0, 0.4190852551791151, 0, 0, 1,
        0.38704807277338171};
    Points planes = {0.57265264599955468,
                     0.51379725882198324,
                     0.78666275037441813,
                     1.5668425431897663,
                     0,
                     2,
                     -1,
                     2,
                     -0.57585184816550838,
                     -0.8731413843197533,
                     -0.4870546860306042,
                     -0.34185553328537033,
                     0,
                     1,
                     0,
                     1,
                     0,
                     0,
                     -1,
                     0};
    for (int turn = 0; turn < 5; ++turn) {
        SCOPED_TRACE(turn);
        EXPECT_GE(compare(xyz, planes, 1), 4u);
        EXPECT_NEAR(measures_of_cells(xyz, Measure::area, planes)[0], 1.4916989803680767, 1e-12);
        std::rotate(planes.begin(), planes.begin() + 4, planes.end());
    }
}

// Two points that are near each other among others that are not: the face between them is as large
// as others.
TEST(Regions, FacesBetweenNearPoints) {
    for (const double distance : {1e-6, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 1e-15}) {
        SCOPED_TRACE(distance);
        Random random(7);
        Points xyz = random.points(10);
        const double way[3] = {1, 0.3, -0.7};
        for (int i = 0; i < 2; ++i)
            for (const double x : way) xyz.push_back(0.5 + i * distance * x);
        EXPECT_EQ(compare(xyz, box(1), 5), 3u);
    }
}

// Lengths of faces leave the range in which doubles have areas, or that of the mesh's scale.
TEST(Regions, FacesBetweenTinyAndOrdinaryLengths) {
    for (const double s : {1e-140, 1e-178, 1e-230, 3e-308}) {
        SCOPED_TRACE(s);
        const Points xyz = {0, 0, 0, s, 0, 0, 0, s, 0, 0, 0, s, s, s, 1.5 * s};
        EXPECT_EQ(compare(xyz, box(1), 2), 3u);
    }
}

// Twice the area of a bounded face, as its corners give it.
double doubled_area(const VoronoiDiagram& d, std::size_t f) {
    double sum[3] = {};
    const auto corner = [&](std::uint64_t i) {
        return d.vertices.begin() + 3 * std::size_t{d.face_corners[i]};
    };
    const double* const first = corner(d.face_begin[f]);
    for (std::uint64_t i = d.face_begin[f] + 1; i + 1 < d.face_begin[f + 1]; ++i)
        for (int k = 0; k < 3; ++k) {
            const int g = (k + 1) % 3, h = (k + 2) % 3;
            const double *const p = corner(i), *const q = corner(i + 1);
            sum[k] += (p[g] - first[g]) * (q[h] - first[h]) - (p[h] - first[h]) * (q[g] - first[g]);
        }
    return std::sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
}

// Most coordinates are about 1e-201, so the mesh's scale brings the others to 1e200.
TEST(Regions, FacesOfPointsWithTinyNoise) {
    const double tiny = 1e-201;
    const Points xyz = {0.046,       0.195,      -4.0 * tiny, -1.5 * tiny, -0.683,     2.9 * tiny,
                        2.8 * tiny,  4.9 * tiny, 0.403,       0.0084,      2.2 * tiny, 4.9 * tiny,
                        -2.9 * tiny, 4.3 * tiny, 3.1 * tiny,  0.567,       0.5 * tiny, 1.4 * tiny,
                        -3.9 * tiny, 0.0487,     0.0407,      1.5 * tiny,  -0.814,     -0.6 * tiny,
                        1.2 * tiny,  -0.0897,    3.8 * tiny,  -0.221,      0.583,      -0.018};
    OwnDiagram diagram(xyz);
    std::size_t bounded = 0;
    for (std::size_t f = 0; f < diagram->face_count(); ++f) {
        if (std::isinf(diagram->areas[f])) continue;
        ++bounded;
        const double doubled = doubled_area(*diagram, f);
        EXPECT_NEAR(2 * diagram->areas[f], doubled, 1e-9 * doubled);
    }
    EXPECT_GT(bounded, 20u);
}

TEST(Regions, TouchTheirPoints) {
    const Points first = {0, 0, 0, .5, .5, 3.5, .5, .5, 4.5, .5, 1.5, 3.5},
                 second = {1, 0, 0, 0, 1, 0, 0, 6, 0, 0, 0, 6};
    EXPECT_EQ(measures_of_cells(first, Measure::faces, own_box(first))[3], 6);
    EXPECT_EQ(measures_of_cells(second, Measure::faces, {1, 0,  0, 6, -1, 0, 0, 0, 0, 1, 0,  6,
                                                         0, -1, 0, 0, 0,  0, 1, 6, 0, 0, -1, 0})[2],
              7);
    Random random(8);
    for (int run = 0; run < (is_small() ? 2 : 24); ++run) {
        SCOPED_TRACE(run);
        const int n = 2 + random.integer(6);
        Points xyz;
        for (int i = 0; i < 12; ++i)
            for (int k = 0; k < 3; ++k)
                xyz.push_back(run % 3 == 0 ? 0.5 * random.integer(n) : random.integer(n));
        // Points that span space.
        xyz.insert(xyz.end(), {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
        // A repeat has no cell.
        Points distinct;
        for (std::size_t i = 0; i < xyz.size(); i += 3) {
            bool is_new = true;
            for (std::size_t j = 0; j < distinct.size(); j += 3)
                is_new &= !std::equal(&xyz[i], &xyz[i] + 3, &distinct[j]);
            if (is_new) distinct.insert(distinct.end(), &xyz[i], &xyz[i] + 3);
        }
        compare(distinct, own_box(distinct), 2);
    }
}

TEST(Regions, FarLargerThanACell) {
    Random random(5);
    for (const double size : {1e3, 1e10, 1e36, 1e250}) {
        SCOPED_TRACE(size);
        compare(random.points(9, 5), box(size), is_small() ? 8 : 3);
        // The same without faces that are parallel to the axes.
        Points tilted = box(size);
        for (std::size_t i = 0; i < tilted.size(); i += 4)
            for (std::size_t k = 0; k < 3; ++k) tilted[i + k] += random.within(.2);
        compare(random.points(9, 5), tilted, is_small() ? 8 : 3);
    }
}

TEST(Regions, OfPointsWhoseExponentsAreFarApart) {
    Random random(6);
    for (const int most : {30, 100, 368, 900}) {
        SCOPED_TRACE(most);
        Points xyz;
        for (int i = 0; i < 24; ++i)
            xyz.push_back(std::ldexp(random.within(1), random.integer(2 * most) - most));
        compare(xyz, own_box(xyz), is_small() ? 7 : 4);
        if (most < 400 && !is_small())
            compare_cells_with_rationals(xyz, {}, 5,
                                         Rational(boost::multiprecision::cpp_int(1) << 4500));
    }
    // One point far from all others.
    for (const double far : {1e30, 1e150, 1e300}) {
        SCOPED_TRACE(far);
        Points xyz = random.points(8);
        xyz.insert(xyz.end(), {far, far / 3, -far / 7});
        compare(xyz, own_box(xyz), 4);
        compare(xyz, box(far), 5);
    }
}

TEST(Regions, BoxesOfPointsOfAnySizeAreTaken) {
    Random random(7);
    for (int e = -1070; e <= 1020; e += 110) {
        SCOPED_TRACE(e);
        Points xyz = random.points(9);
        for (double& x : xyz) x = std::ldexp(x, e);
        EXPECT_EQ(measures_of_cells(xyz, Measure::faces, own_box(xyz)).size(), 9u);
    }
}

}  // namespace
}  // namespace mgdt
