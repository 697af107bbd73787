// SPDX-License-Identifier: MIT
// Voronoi diagrams: what belongs together, threads and orders, rays, small faces. cells_test and
// cell_regions_test compare the same diagrams with rational numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <random>
#include <set>

#include "../support/points.hpp"
#include "../support/small.h"
#include "voronoi_and_rationals.hpp"

namespace mgdt {
namespace {

using mgdt_tests::Points;
using mgdt_tests::uniform;

Points box(double low, double high) {
    return {1, 0,  0, high, -1, 0, 0, -low, 0, 1, 0,  high,
            0, -1, 0, -low, 0,  0, 1, high, 0, 0, -1, -low};
}

Points lattice(int n, int centers) {
    Points xyz;
    for (int i = 0; i < n * n * n; ++i) {
        const double at[3] = {double(i % n), double(i / n % n), double(i / n / n)};
        xyz.insert(xyz.end(), at, at + 3);
        if (centers == 1)
            for (const double x : at) xyz.push_back(x + .5);
        for (int k = 0; k < 3 && centers == 2; ++k)
            for (int axis = 0; axis < 3; ++axis) xyz.push_back(at[axis] + (axis == k ? 0 : .5));
    }
    return xyz;
}

// Whether each bounded cell is a polyhedron: its edges are in two faces each, and Euler's formula
// holds; and whether all numbers exist.
void check_cells(const VoronoiDiagram& d) {
    const std::size_t vertices = d.vertices.size() / 3, rays = d.ray_vertices.size();
    for (std::size_t f = 0; f < d.face_count(); ++f) {
        const std::size_t n = static_cast<std::size_t>(d.face_begin[f + 1] - d.face_begin[f]);
        ASSERT_GE(n, 3u);
        std::set<std::uint32_t> corners;
        for (std::uint64_t i = d.face_begin[f]; i < d.face_begin[f + 1]; ++i) {
            const std::uint32_t corner = d.face_corners[i];
            const bool is_ray = (corner & VoronoiDiagram::ray) != 0;
            ASSERT_LT(corner & ~VoronoiDiagram::ray, is_ray ? rays : vertices);
            // The two rays come last, the one from the last vertex first.
            if (is_ray) {
                ASSERT_GE(i + 2, d.face_begin[f + 1]);
                const std::uint32_t from = d.ray_vertices[corner & ~VoronoiDiagram::ray];
                ASSERT_EQ(from,
                          d.face_corners[i + 2 == d.face_begin[f + 1] ? i - 1 : d.face_begin[f]]);
            }
            ASSERT_TRUE(corners.insert(corner).second);
        }
        ASSERT_LT(d.face_sides[2 * f], d.face_sides[2 * f + 1]);
        ASSERT_GT(d.areas[f], 0);
    }
    for (std::size_t c = 0; c < d.cell_count(); ++c) {
        std::set<std::uint32_t> corners;
        std::map<std::set<std::uint32_t>, int> edges;
        for (std::uint64_t i = d.cell_begin[c]; i < d.cell_begin[c + 1]; ++i) {
            const std::uint32_t f = d.cell_faces[i];
            ASSERT_TRUE(d.face_sides[2 * f] == c || d.face_sides[2 * f + 1] == c);
            const std::uint64_t begin = d.face_begin[f], end = d.face_begin[f + 1];
            for (std::uint64_t k = begin; k < end; ++k) {
                corners.insert(d.face_corners[k]);
                ++edges[{d.face_corners[k], d.face_corners[k + 1 == end ? begin : k + 1]}];
            }
        }
        if (d.is_bounded[c] == 0) continue;
        const auto faces = static_cast<std::size_t>(d.cell_begin[c + 1] - d.cell_begin[c]);
        EXPECT_EQ(corners.size() + faces, edges.size() + 2) << c;
        for (const auto& [edge, count] : edges) EXPECT_EQ(count, 2) << c;
    }
}

TEST(Voronoi, CellsArePolyhedra) {
    const std::size_t n = is_small() ? 60 : 600;
    for (const Points& planes : {Points(), box(0, 1), box(-3, 2), box(-1e6, 1e6)})
        check_cells(*OwnDiagram(uniform(n, 1), planes));
    for (const int centers : {0, 1, 2})
        for (const Points& planes : {Points(), box(-.5, 4.5), box(0, 4.5), box(-9, 12)})
            check_cells(*OwnDiagram(lattice(5, centers), planes));
}

TEST(Voronoi, LatticesHaveTheirFaces) {
    const std::size_t faces[] = {6, 14, 12};
    for (const int centers : {0, 1, 2}) {
        OwnDiagram d(lattice(5, centers), box(-2, 6.5));
        const auto inner =
            static_cast<std::size_t>((2 * 25 + 2 * 5 + 2) * (centers == 2 ? 4 : 1 + centers));
        EXPECT_EQ(d->cell_begin[inner + 1] - d->cell_begin[inner], faces[centers]);
        double sum = 0;
        for (const double volume : d->volumes) sum += volume;
        EXPECT_NEAR(sum, 8.5 * 8.5 * 8.5, 1e-10);
    }
    // 27 cells have 8 inner vertices, and each of the 6 sides has 4 by 4 on the boundary.
    OwnDiagram cubes(lattice(3, 0), box(-.5, 2.5));
    EXPECT_EQ(cubes->vertices.size() / 3, 64u);
    EXPECT_EQ(cubes->face_count(), 3u * 4 * 9);
}

template <class T>
void expect_equal(const Buffer<T>& a, const Buffer<T>& b) {
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(T)), 0);
}

TEST(Voronoi, ThreadsAndOrdersChangeNoBit) {
    const Points wild = uniform(is_small() ? 3000 : 40000, 5);
    for (const Points& planes : {Points(), box(0, 1)}) {
        OwnDiagram one(wild, planes);
        for (const unsigned threads : {1u, 2u, 3u})
            for (const std::int32_t scheme : {0, 30}) {
                OwnDiagram other(wild, planes, threads, scheme);
                expect_equal(one->vertices, other->vertices);
                expect_equal(one->ray_vertices, other->ray_vertices);
                expect_equal(one->ray_directions, other->ray_directions);
                expect_equal(one->face_begin, other->face_begin);
                expect_equal(one->face_corners, other->face_corners);
                expect_equal(one->face_sides, other->face_sides);
                expect_equal(one->areas, other->areas);
                expect_equal(one->face_centroids, other->face_centroids);
                expect_equal(one->cell_begin, other->cell_begin);
                expect_equal(one->cell_faces, other->cell_faces);
                expect_equal(one->volumes, other->volumes);
                expect_equal(one->cell_centroids, other->cell_centroids);
            }
    }
}

// A tetrahedron has one vertex, four rays along the outward normals of its facets, and six faces.
TEST(Voronoi, OfOneTetrahedron) {
    OwnDiagram d(Points{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1});
    EXPECT_EQ(Points(d->vertices.begin(), d->vertices.end()), Points({.5, .5, .5}));
    ASSERT_EQ(d->ray_vertices.size(), 4u);
    EXPECT_EQ(d->face_count(), 6u);
    const double s = std::sqrt(1. / 3);
    std::multiset<std::vector<double>> rays;
    for (std::size_t r = 0; r < 4; ++r) {
        std::vector<double> rounded;
        for (std::size_t k = 0; k < 3; ++k)
            rounded.push_back(std::round(d->ray_directions[3 * r + k] * 1e6));
        for (double& x : rounded) x += 0.0;
        rays.insert(rounded);
    }
    const double third = std::round(s * 1e6);
    EXPECT_EQ(rays, (std::multiset<std::vector<double>>{
                        {-1e6, 0, 0}, {0, -1e6, 0}, {0, 0, -1e6}, {third, third, third}}));
    check_cells(*d);
}

// Hull facets in one plane with one circumcentre have one ray.
TEST(Voronoi, RaysOfALatticeAreThoseOfItsSquares) {
    OwnDiagram d(lattice(4, 0));
    EXPECT_EQ(d->vertices.size() / 3, 27u);
    EXPECT_EQ(d->ray_vertices.size(), 6u * 9);
    for (std::size_t r = 0; r < d->ray_vertices.size(); ++r) {
        double sum = 0;
        for (std::size_t k = 0; k < 3; ++k) sum += std::fabs(d->ray_directions[3 * r + k]);
        EXPECT_EQ(sum, 1);
    }
}

TEST(Voronoi, RepeatsHaveNoCell) {
    Points xyz = uniform(50, 3);
    xyz.insert(xyz.end(), xyz.begin(), xyz.begin() + 6);
    OwnDiagram d(xyz, box(0, 1));
    EXPECT_EQ(d->cell_begin[52], d->cell_begin[50]);
    EXPECT_EQ(d->volumes[50], 0);
    EXPECT_EQ(d->is_bounded[51], 0);
    check_cells(*d);
}

// A point may be outside of the region by less than rounding, and all of its cell with it. Here
// that is the last cell.
TEST(Voronoi, TheLastCellMayHaveNoFaces) {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Points xyz = uniform(20, seed);
        for (const double x : {1 - 0x1p-53, .5, .5, 1 + 0x1p-52, .5, .5}) xyz.push_back(x);
        OwnDiagram d(xyz, box(0, 1));
        ASSERT_EQ(d->cell_begin[22], d->cell_begin[21]);
        ASSERT_EQ(d->cell_begin[22], d->cell_faces.size());
        EXPECT_EQ(d->volumes[21], 0);
        double sum = 0;
        for (const double volume : d->volumes) sum += volume;
        EXPECT_NEAR(sum, 1, 1e-12);
    }
}

// A rotated lattice is rounded: its cells have tiny faces, which are left out on both sides.
TEST(Voronoi, SmallFacesCanBeLeftOut) {
    Points xyz = lattice(5, 0);
    for (std::size_t i = 0; i < xyz.size(); i += 3) {
        const double x = xyz[i] - 2, y = xyz[i + 1] - 2;
        xyz[i] = .6 * x - .8 * y + .1;
        xyz[i + 1] = .8 * x + .6 * y + .2;
    }
    OwnDiagram d(xyz, box(-9, 9));
    const std::size_t inner = 2 * 25 + 2 * 5 + 2, before = d->face_count();
    const Points volumes(d->volumes.begin(), d->volumes.end());
    drop_small_faces(*d, 0, 0);
    EXPECT_EQ(d->face_count(), before);
    EXPECT_GT(d->cell_begin[inner + 1] - d->cell_begin[inner], 6u);
    drop_small_faces(*d, 0, 1e-9);
    EXPECT_LT(d->face_count(), before);
    EXPECT_EQ(d->cell_begin[inner + 1] - d->cell_begin[inner], 6u);
    EXPECT_EQ(Points(d->volumes.begin(), d->volumes.end()), volumes);
    std::vector<int> sides(d->face_count(), 0);
    for (const std::uint32_t f : d->cell_faces) ++sides[f];
    for (std::size_t f = 0; f < d->face_count(); ++f)
        EXPECT_EQ(sides[f], (d->face_sides[2 * f + 1] & VoronoiDiagram::plane) != 0 ? 1 : 2);
    drop_small_faces(*d, 1e300, 0);
    EXPECT_EQ(d->face_count(), 0u);
    EXPECT_EQ(d->cell_faces.size(), 0u);
    EXPECT_EQ(d->face_begin.size(), 1u);
}

// A face that is small for a large cell may be large for the small cell beside it, and stays.
TEST(Voronoi, FacesThatAreLargeForOneCellAreNotLeftOut) {
    const Points xyz = lattice(5, 0);
    OwnDiagram d(xyz, box(-1e6, 1e6)), unbounded(xyz, {});
    for (OwnDiagram* each : {&d, &unbounded}) {
        drop_small_faces(**each, 0, 1e-6);
        // The cell beside three cells that are a million long, or have no end.
        const std::size_t corner = 25 + 5 + 1;
        EXPECT_EQ((*each)->cell_begin[corner + 1] - (*each)->cell_begin[corner], 6u);
    }
}

// Areas whose sums overflow.
TEST(Voronoi, LargeFacesAreNotLeftOut) {
    Points xyz = lattice(4, 0);
    for (double& x : xyz) x *= 0.9e154;
    OwnDiagram d(xyz);
    const std::size_t before = d->face_count();
    drop_small_faces(*d, 0, 1e-9);
    EXPECT_EQ(d->face_count(), before);
}

TEST(Voronoi, NormalsPointFromTheFirstSideToTheSecond) {
    const Points xyz = uniform(40, 8), planes = box(0, 1);
    OwnDiagram d(xyz, planes);
    Points normals(3 * d->face_count());
    write_normals(*d, normals.data());
    for (std::size_t f = 0; f < d->face_count(); ++f) {
        const std::uint32_t other = d->face_sides[2 * f + 1];
        double along = 0, square = 0, size = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double way =
                (other & VoronoiDiagram::plane) != 0
                    ? planes[4 * (other & ~VoronoiDiagram::plane) + k]
                    : xyz[3 * other + k] - xyz[3 * std::size_t{d->face_sides[2 * f]} + k];
            along += way * normals[3 * f + k];
            square += way * way;
            size += normals[3 * f + k] * normals[3 * f + k];
        }
        EXPECT_NEAR(along, std::sqrt(square), 1e-14);
        EXPECT_NEAR(size, 1, 1e-14);
    }
}

}  // namespace
}  // namespace mgdt
