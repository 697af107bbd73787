// SPDX-License-Identifier: MIT
// Places in meshes: the nearest ones of the boundary beside a search of all faces, and values that
// are linear.
#include "solid/mesh_places.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "../support/small.h"
#include "improvable_meshes.hpp"
#include "mesh/tetrahedron.hpp"

namespace mgdt {
namespace {

using Number = long double;
struct P {
    Number x[3];
};
P minus(const P& a, const P& b) {
    return {{a.x[0] - b.x[0], a.x[1] - b.x[1], a.x[2] - b.x[2]}};
}
Number dot(const P& a, const P& b) {
    return a.x[0] * b.x[0] + a.x[1] * b.x[1] + a.x[2] * b.x[2];
}
P at(const double* x) {
    return {{x[0], x[1], x[2]}};
}

Number square_to_segment(const P& q, const P& a, const P& b) {
    const P u = minus(b, a), v = minus(q, a);
    const Number t = std::min(std::max(dot(u, v) / dot(u, u), Number(0)), Number(1));
    const P d = {{v.x[0] - t * u.x[0], v.x[1] - t * u.x[1], v.x[2] - t * u.x[2]}};
    return dot(d, d);
}
// By another way than the library's: the heights over the plane and over the edges.
Number square_to_triangle(const P& q, const P& a, const P& b, const P& c) {
    const P u = minus(b, a), v = minus(c, a), w = minus(q, a);
    const Number uu = dot(u, u), uv = dot(u, v), vv = dot(v, v), uw = dot(u, w), vw = dot(v, w);
    const Number area = uu * vv - uv * uv;
    const Number s = (vv * uw - uv * vw) / area, t = (uu * vw - uv * uw) / area;
    if (s >= 0 && t >= 0 && s + t <= 1) {
        P d = w;
        for (int k = 0; k < 3; ++k) d.x[k] -= s * u.x[k] + t * v.x[k];
        return dot(d, d);
    }
    return std::min(
        {square_to_segment(q, a, b), square_to_segment(q, b, c), square_to_segment(q, c, a)});
}

Number square_to_boundary(const SolidMesh& mesh, const double* place) {
    Number least = std::numeric_limits<Number>::infinity();
    const auto corner = [&](std::size_t t, unsigned i) {
        return at(mesh.points.begin() + 3 * std::size_t{mesh.tetrahedra[4 * t + i]});
    };
    for (std::size_t t = 0; t < mesh.tetrahedron_count(); ++t)
        for (unsigned i = 0; i < 4; ++i)
            if (mesh.neighbors[4 * t + i] == no_index)
                least = std::min(least, square_to_triangle(at(place), corner(t, outer_face[i][0]),
                                                           corner(t, outer_face[i][1]),
                                                           corner(t, outer_face[i][2])));
    return least;
}

TEST(MeshPlaces, NearestOnesOfTheBoundary) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    for_improvable_meshes([&](const SolidMesh& mesh) {
        Allocator memory;
        StopFlag flag;
        const BoundaryPlaces boundary(memory, mesh, flag.request());
        double size = 0;
        for (const double c : mesh.points) size = std::max(size, std::fabs(c));
        for (int i = 0; i < fewer(200); ++i) {
            // Near, far, and at points of the mesh.
            double place[3];
            const std::size_t p = random() % (mesh.points.size() / 3);
            for (std::size_t k = 0; k < 3; ++k)
                place[k] = mesh.points[3 * p + k] +
                           (i % 3 == 0 ? 0.0 : size * unit(random) * (i % 3 == 1 ? 0.1 : 4.0));
            const BoundaryPlaces::Place found = boundary.nearest(place);
            ASSERT_NE(found.tetrahedron, no_index);
            Number x[3] = {0, 0, 0}, sum = 0;
            bool is_on_face = false;
            for (unsigned k = 0; k < 4; ++k) {
                const std::size_t t = found.tetrahedron;
                const std::size_t v = mesh.tetrahedra[4 * t + k];
                EXPECT_GE(found.weights[k], 0);
                sum += found.weights[k];
                is_on_face |= found.weights[k] == 0 && mesh.neighbors[4 * t + k] == no_index;
                for (std::size_t j = 0; j < 3; ++j)
                    x[j] += Number(found.weights[k]) * mesh.points[3 * v + j];
            }
            EXPECT_TRUE(is_on_face);
            EXPECT_NEAR(static_cast<double>(sum), 1, 1e-15);
            Number square = 0;
            for (int j = 0; j < 3; ++j) square += (x[j] - place[j]) * (x[j] - place[j]);
            const Number expected = std::sqrt(square_to_boundary(mesh, place));
            EXPECT_NEAR(static_cast<double>(std::sqrt(square)), static_cast<double>(expected),
                        1e-14 * (size + static_cast<double>(expected)));
        }
    });
}

TEST(MeshPlaces, FarOnesAndEmptyMeshes) {
    MeshedDomain domain;
    give(domain, gridded_box(2, 2, 2, 0, 1));
    domain.build();
    Allocator memory;
    StopFlag flag;
    const BoundaryPlaces boundary(memory, domain.mesh(), flag.request());
    for (const double far : {1e10, 1e200, 1e308}) {
        const double place[3] = {far, far / 2, -far};
        const BoundaryPlaces::Place found = boundary.nearest(place);
        double x[3] = {0, 0, 0};
        for (unsigned k = 0; k < 4; ++k)
            for (std::size_t j = 0; j < 3; ++j)
                x[j] += found.weights[k] *
                        domain.mesh()
                            .points[3 * std::size_t{domain.mesh().tetrahedra
                                                        [4 * std::size_t{found.tetrahedron} + k]} +
                                    j];
        double corner[3] = {0, 0, 0};
        for (std::size_t i = 0; i < domain.mesh().points.size(); ++i)
            corner[i % 3] = i % 3 < 2 ? std::max(corner[i % 3], domain.mesh().points[i])
                                      : std::min(corner[2], domain.mesh().points[i]);
        EXPECT_EQ(x[0], corner[0]) << far;
        EXPECT_EQ(x[1], corner[1]) << far;
        EXPECT_EQ(x[2], corner[2]) << far;
    }
    const SolidMesh empty(memory);
    const BoundaryPlaces none(memory, empty, flag.request());
    const double place[3] = {0, 0, 0};
    EXPECT_EQ(none.nearest(place).tetrahedron, no_index);
}

TEST(MeshPlaces, LinearValuesAreReproduced) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(-0.2, 1.2);
    for_improvable_meshes([&](const SolidMesh& mesh) {
        Allocator memory;
        StopFlag flag;
        const MeshLocator inside(memory, mesh, flag.request());
        const BoundaryPlaces boundary(memory, mesh, flag.request());
        double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
        for (std::size_t i = 0; i < mesh.points.size(); ++i) {
            low[i % 3] = std::min(low[i % 3], mesh.points[i]);
            high[i % 3] = std::max(high[i % 3], mesh.points[i]);
        }
        const std::size_t n = 500;
        std::vector<double> xyz, values;
        for (std::size_t i = 0; i < 3 * n; ++i)
            xyz.push_back(low[i % 3] + unit(random) * (high[i % 3] - low[i % 3]));
        for (std::size_t p = 0; p < mesh.points.size(); p += 3) {
            values.push_back(3 * mesh.points[p] - mesh.points[p + 1] + 2 * mesh.points[p + 2] + 1);
            values.push_back(mesh.points[p + 2]);
        }
        PointSet places = {{xyz.data(), xyz.data() + 1, xyz.data() + 2},
                           3,
                           n,
                           1,
                           {low[0], low[1], low[2]},
                           {high[0], high[1], high[2]}};
        for (int k = 0; k < 3; ++k) {
            places.low[k] -= high[k] - low[k];
            places.high[k] += high[k] - low[k];
        }
        std::vector<std::int64_t> first;
        for (const unsigned threads : {1u, 4u}) {
            Team team(threads);
            for (const bool takes_boundary : {false, true}) {
                const PlaceFinder finder = {mesh, inside, takes_boundary ? &boundary : nullptr};
                std::vector<double> out(2 * n), weights(4 * n);
                std::vector<std::int64_t> found(n);
                locate_places<std::int64_t>(finder, team, places, memory, Unwatched(), 1,
                                            found.data(), weights.data());
                interpolate_places(finder, team, places, memory, Unwatched(), 2, values.data(),
                                   out.data());
                std::size_t outside = 0;
                for (std::size_t i = 0; i < n; ++i) {
                    if (found[i] == 0) {
                        ++outside;
                        EXPECT_TRUE(std::isnan(out[2 * i]));
                        continue;
                    }
                    double x[3] = {0, 0, 0};
                    for (std::size_t k = 0; k < 4; ++k)
                        for (std::size_t j = 0; j < 3; ++j)
                            x[j] +=
                                weights[4 * i + k] *
                                mesh.points[3 *
                                                std::size_t{
                                                    mesh.tetrahedra[4 * static_cast<std::size_t>(
                                                                            found[i] - 1) +
                                                                    k]} +
                                            j];
                    const double size =
                        std::max({std::fabs(high[0]), std::fabs(high[1]), std::fabs(high[2]), 1.0});
                    EXPECT_NEAR(out[2 * i], 3 * x[0] - x[1] + 2 * x[2] + 1, 1e-12 * size);
                    EXPECT_NEAR(out[2 * i + 1], x[2], 1e-12 * size);
                }
                if (takes_boundary) {
                    EXPECT_EQ(outside, 0u);
                } else {
                    EXPECT_GT(outside, 0u);
                    if (first.empty()) first = found;
                    EXPECT_EQ(first, found);
                }
            }
        }
    });
}

}  // namespace
}  // namespace mgdt
