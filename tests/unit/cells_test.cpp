// SPDX-License-Identifier: MIT
// Voronoi cells and their measures: cells that are known, cells that fill their box, and the same
// bits whatever the order of insertion and the number of threads.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <vector>

#include "../support/points.hpp"
#include "../support/small.h"
#include "cells_and_rationals.hpp"
#include "core/triangulation.hpp"
#include "dual/exact_measures.hpp"
#include "predicates/circumcenter.hpp"

namespace mgdt {
namespace {

using mgdt_tests::lattice;
using mgdt_tests::Points;
using mgdt_tests::uniform;
const Points unit_box = {1, 0, 0, 1, -1, 0, 0, 0, 0, 1, 0, 1, 0, -1, 0, 0, 0, 0, 1, 1, 0, 0, -1, 0};

// Rounded once.
double sum(const Points& x) {
    Twofold all = {0, 0};
    for (const double v : x) all = all + Twofold{v, 0};
    return all.high;
}

TEST(Cells, OfALatticeAreCubes) {
    const Points xyz = lattice(5), volumes = measures_of_cells(xyz, Measure::volume, {}),
                 areas = measures_of_cells(xyz, Measure::area, {}),
                 faces = measures_of_cells(xyz, Measure::faces, {}),
                 centroids = measures_of_cells(xyz, Measure::centroid, {});
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        bool is_inside = true;
        int neighbors = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = xyz[3 * i + k];
            is_inside &= x > 0 && x < 4;
            neighbors += (x > 0) + (x < 4);
        }
        EXPECT_EQ(faces[i], neighbors);
        if (is_inside) {
            EXPECT_EQ(volumes[i], 1);
            EXPECT_NEAR(areas[i], 6, 6e-12);
            for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(centroids[3 * i + k], xyz[3 * i + k]);
        } else {
            EXPECT_EQ(volumes[i], std::numeric_limits<double>::infinity());
        }
    }
    const Points box = {1, 0,  0, 4.5, -1, 0, 0, .5,  0, 1, 0,  4.5,
                        0, -1, 0, .5,  0,  0, 1, 4.5, 0, 0, -1, .5};
    for (const double volume : measures_of_cells(xyz, Measure::volume, box)) EXPECT_EQ(volume, 1);
    for (const double area : measures_of_cells(xyz, Measure::area, box))
        EXPECT_NEAR(area, 6, 6e-12);
    for (const double count : measures_of_cells(xyz, Measure::faces, box)) EXPECT_EQ(count, 6);
}

TEST(Cells, FillTheBox) {
    for (const std::size_t n : {4u, 5u, 20u, 300u, 3000u}) {
        EXPECT_NEAR(sum(measures_of_cells(uniform(n), Measure::volume, unit_box)), 1, 4e-16) << n;
        // As flat as that, circumcentres are far outside.
        Points flat_box = unit_box;
        flat_box[19] = 1e-7;
        EXPECT_NEAR(
            sum(measures_of_cells(uniform(n, 1, 1, 1, 1e-7), Measure::volume, flat_box)) * 1e7, 1,
            4e-16)
            << n;
    }
}

// How many cells of a set in a box doubles and twofold numbers with bounds leave to long ones, of
// those that the plain stages leave open.
struct Shares {
    int in_short = 0, in_long = 0;
};
Shares shares(const Points& xyz, const Points& planes) {
    Triangulation t(nullptr, nullptr, nullptr);
    const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
    t.insert(xyz.size() / 3, axis, 3);
    const Mesh& mesh = t.mesh();
    const Region region(t.allocator(), planes.size() / 4, planes.data(), mesh, 0);
    std::vector<TetId> first(mesh.vertices.size(), no_tetrahedron);
    for (TetId id = 0; id < mesh.tetrahedra.size(); ++id)
        if (!mesh.tetrahedra[id].is_dead())
            for (const VertexId v : mesh.tetrahedra[id].v) first[v] = id;
    Link link(t.allocator());
    CellMeasures in_doubles(t.allocator());
    CellFaces faces(t.allocator());
    Shares found;
    for (VertexId v = 1; v < mesh.vertices.size(); ++v) {
        link.gather(mesh, v, first[v]);
        double volume;
        if (in_doubles.measure(mesh, v, link, region, Measure::volume, Centers::corrected, &volume))
            continue;
        faces.find(mesh, v, link, in_doubles.cell(), region);
        const auto is_in = [&](ExactMeasures::Stage stage) {
            return ExactMeasures::measure_in(stage, faces, mesh.point(v), mesh.scale,
                                             Measure::volume, &volume);
        };
        const bool is_short =
            is_in(ExactMeasures::Stage::doubles) || is_in(ExactMeasures::Stage::twofold);
        ++(is_short ? found.in_short : found.in_long);
    }
    return found;
}

// Long numbers take a thousand times as long as doubles: where one axis is far longer than another
// and where exponents are far apart they are not needed.
TEST(Cells, OfExtremeShapesAreFoundInShortNumbers) {
    const std::size_t n = is_small() ? 20 : 150;
    for (const double z_size : {1e-6, 1e-15, 1e-100, 1e-300}) {
        Points planes = unit_box;
        planes[19] = planes[23] = z_size;
        const Shares found = shares(uniform(n, 1, 1, 1, z_size), planes);
        EXPECT_EQ(found.in_long, 0) << z_size;
        EXPECT_GT(found.in_short, 0) << z_size;
    }
    Points xyz = uniform(n), planes = unit_box;
    for (double& x : xyz) x = std::pow(x, 400);
    const Shares found = shares(xyz, planes);
    EXPECT_LE(found.in_long, 3);
    EXPECT_GT(found.in_short, static_cast<int>(n / 4));
}

// Where products of coordinates and planes overflow, the planes still cut.
TEST(Cells, OfCoordinatesNearTheLargest) {
    const Points near_one = uniform(60);
    Points xyz = near_one, planes = unit_box;
    for (double& x : xyz) x *= 0x1p1000;
    for (std::size_t k = 3; k < planes.size(); k += 4) planes[k] *= 0x1p1000;
    xyz[0] = 1e-30;  // so that no power of two makes all ordinary
    Points same = near_one;
    same[0] = 0;
    EXPECT_EQ(measures_of_cells(xyz, Measure::faces, planes),
              measures_of_cells(same, Measure::faces, unit_box));
    const Points centroids = measures_of_cells(xyz, Measure::centroid, planes),
                 expected = measures_of_cells(same, Measure::centroid, unit_box);
    for (std::size_t i = 0; i < centroids.size(); ++i)
        EXPECT_NEAR(centroids[i] * 0x1p-1000, expected[i], 1e-11);
}

// Nearly all points are neighbours of each other, and many cells reach to each face of the box.
TEST(Cells, WithManyNeighborsFillTheBox) {
    const std::size_t n = is_small() ? 20 : 200;
    Points curve, lines, fan;
    for (std::size_t i = 0; i < n; ++i) {
        const double t = static_cast<double>(i + 1) / static_cast<double>(n + 2);
        curve.insert(curve.end(), {t, t * t, t * t * t});
        lines.insert(lines.end(), {i % 2 ? t : 0.25, i % 2 ? 0.25 : t, i % 2 ? 0.125 : 0.875});
        fan.insert(fan.end(), {i % 2 ? 0.5 + 0.25 * std::cos(20 * t) : 0.5,
                               i % 2 ? 0.5 + 0.25 * std::sin(20 * t) : 0.5, i % 2 ? 0.5 : t});
    }
    for (const Points& xyz : {curve, lines, fan}) {
        EXPECT_NEAR(sum(measures_of_cells(xyz, Measure::volume, unit_box)), 1, 1e-12);
        // Those of the box and of every cut through it.
        const Points faces = measures_of_cells(xyz, Measure::faces, unit_box);
        EXPECT_GT(*std::max_element(faces.begin(), faces.end()), 0.4 * static_cast<double>(n));
    }
}

// Thin slabs, and exponents that are far apart.
TEST(Cells, HaveTheSameBitsInWhateverOrderInAllStages) {
    Points xyz = uniform(60, 1, 1, 1, 1e-15), far = xyz;
    Points planes = unit_box;
    planes[19] = 1e-15;
    for (std::size_t i = 0; i < far.size(); ++i)
        if (i % 7 == 0) far[i] *= 1e-200;
    for (const Measure m : {Measure::volume, Measure::area, Measure::centroid, Measure::faces})
        for (const Points& points : {xyz, far})
            EXPECT_EQ(measures_of_cells(points, m, planes, MGDT_ORDER_LEXICOGRAPHIC),
                      measures_of_cells(points, m, planes));
}

TEST(Cells, HaveTheSameBitsInWhateverOrder) {
    // Enough for two threads.
    const Points xyz = uniform(9000);
    for (const Measure m : {Measure::volume, Measure::area, Measure::centroid, Measure::faces})
        for (const Points& planes : {Points{}, unit_box}) {
            if (is_small() && (m != Measure::volume || planes.empty())) continue;
            const Points expected = measures_of_cells(xyz, m, planes);
            for (const std::int32_t scheme : {MGDT_ORDER_REGULAR_GRID, MGDT_ORDER_MULTI_GRID})
                EXPECT_EQ(measures_of_cells(xyz, m, planes, scheme, 2), expected);
        }
}

TEST(Cells, OfPointsTimesAPowerOfTwo) {
    const Points xyz = uniform(200);
    const Points expected = measures_of_cells(xyz, Measure::volume, unit_box);
    for (const int e : {-200, 200}) {
        Points scaled = xyz, box = unit_box;
        for (double& x : scaled) x = std::ldexp(x, e);
        for (std::size_t k = 3; k < box.size(); k += 4) box[k] = std::ldexp(box[k], e);
        const Points volumes = measures_of_cells(scaled, Measure::volume, box);
        for (std::size_t i = 0; i < volumes.size(); ++i)
            EXPECT_EQ(volumes[i], std::ldexp(expected[i], 3 * e));
    }
}

void expect_refused(const Points& planes, mgdt_status status) {
    try {
        measures_of_cells(uniform(10), Measure::volume, planes);
        ADD_FAILURE() << "planes are taken";
    } catch (const Error& error) {
        EXPECT_EQ(error.status, status) << error.message;
    }
}

TEST(Cells, NeedPlanesThatBoundARegion) {
    const Points half(unit_box.begin(), unit_box.begin() + 4),
        open(unit_box.begin(), unit_box.end() - 4);
    expect_refused(half, MGDT_ERR_INVALID_ARGUMENT);
    expect_refused(open, MGDT_ERR_INVALID_ARGUMENT);
    expect_refused({1, 0, 0, .25, -1, 0, 0, 0}, MGDT_ERR_INVALID_ARGUMENT);
    expect_refused({0, 0, 0, 1}, MGDT_ERR_INVALID_ARGUMENT);
    expect_refused({1, 0, std::nan(""), 1}, MGDT_ERR_NOT_FINITE);
}

TEST(Cells, TakePlanesThatComeTwice) {
    Points planes = unit_box;
    planes.insert(planes.end(), {3, 0, 0, 3, 1, 1, 1, 5});
    const Points volumes = measures_of_cells(uniform(300), Measure::volume, planes),
                 expected = measures_of_cells(uniform(300), Measure::volume, unit_box);
    for (std::size_t i = 0; i < volumes.size(); ++i)
        EXPECT_NEAR(volumes[i], expected[i], 2 * measure_error * expected[i]);
}

TEST(CenterOffset, IsTheCentreRelativeToTheFirstVertex) {
    const Points p = {1, 2, 3, 4, 2, 3, 1, 6, 3, 1, 2, 5};
    double offset[3];
    center_offset({&p[0], &p[3], &p[6], &p[9]}, offset);
    EXPECT_EQ(offset[0], 1.5);
    EXPECT_EQ(offset[1], 2);
    EXPECT_EQ(offset[2], 1);
    // Nearly flat: 2^-60 of what is around it is its volume.
    const Points flat = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0x1p-60};
    center_offset({&flat[0], &flat[3], &flat[6], &flat[9]}, offset);
    EXPECT_EQ(offset[0], 0.5);
    EXPECT_EQ(offset[1], 0.5);
    EXPECT_EQ(offset[2], 0x1p-61);
}

}  // namespace
}  // namespace mgdt
