// SPDX-License-Identifier: MIT
// Improves meshes, and checks and compares them, for tests of improvement.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <vector>

#include "improvement/improver.hpp"
#include "improvement/quality.hpp"
#include "improvement/vertex_classes.hpp"
#include "mesh_volumes.hpp"
#include "one_thread.hpp"
#include "unwatched.hpp"

namespace mgdt {

inline double sine_of(double degrees) {
    return std::sin(degrees * std::acos(-1.0) / 180);
}

inline ImprovementSettings settings_for(double degrees, bool slides) {
    ImprovementSettings settings;
    settings.goal = std::pow(sine_of(degrees), 2);
    settings.raised_goal = std::pow(sine_of(degrees + 10), 2);
    settings.slides = slides;
    settings.most_passes = 12;
    return settings;
}

// All vertices but those of the caller's surface may move and leave.
inline void classify(FlexibleMesh& mesh, bool slides) {
    Buffer<Permission> permissions(mesh.allocator());
    permissions.resize(mesh.hints.size(), Permission::to_leave);
    classify_vertices(mesh, permissions, slides);
}

inline void improve(FlexibleMesh& mesh, const ImprovementSettings& settings, unsigned threads) {
    Team team(threads);
    classify(mesh, settings.slides);
    Improver(mesh, team, settings).run(Unwatched());
}

inline double worst_of(const FlexibleMesh& mesh) {
    double worst = above_all;
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
        if (!mesh.tetrahedra[t].is_dead()) worst = std::min(worst, mesh.qualities[t]);
    return worst;
}

// Links are mutual, the sides of faces belong together, and qualities are those of the corners.
inline void expect_sound(const FlexibleMesh& mesh) {
    for (std::uint32_t t = 0; t < mesh.tetrahedra.size(); ++t) {
        const FlexibleMesh::Tetrahedron& one = mesh.tetrahedra[t];
        if (one.is_dead()) continue;
        ASSERT_EQ(mesh.qualities[t], mesh.quality(one.v));
        for (unsigned i = 0; i < 4; ++i) {
            ASSERT_TRUE(mesh.tetrahedra[mesh.hints[one.v[i]]].has(one.v[i]));
            ASSERT_FALSE(mesh.tetrahedra[mesh.hints[one.v[i]]].is_dead());
            if (one.n[i] == no_index) {
                ASSERT_NE(one.facets[i], no_index) << "the mesh ends at a face of no facet";
                continue;
            }
            const FlexibleMesh::Tetrahedron& other = mesh.of(one.n[i]);
            ASSERT_FALSE(other.is_dead());
            ASSERT_EQ(other.n[one.n[i] % 4], 4 * t + i);
            ASSERT_EQ(other.facets[one.n[i] % 4],
                      one.facets[i] == no_index ? no_index : one.facets[i] ^ 1);
            for (unsigned k = 0; k < 4; ++k) {
                ASSERT_EQ(other.has(one.v[k]), k != i);
            }
        }
    }
}

// Six times the volume of each region, and twice the area of each facet as a vector.
struct Sums {
    std::map<std::uint32_t, Rational> volumes;
    std::map<std::uint32_t, std::vector<Rational>> areas;
};

inline Sums sums_of(const SolidMesh& m) {
    Sums sums;
    const auto point = [&](std::uint32_t v) { return m.points.begin() + 3 * std::size_t{v}; };
    for (std::size_t t = 0; t < m.tetrahedron_count(); ++t)
        sums.volumes[m.regions[t]] += sixfold_volume(m, t);
    for (std::size_t f = 0; f < m.face_facets.size(); ++f) {
        const double* const p[3] = {point(m.faces[3 * f]), point(m.faces[3 * f + 1]),
                                    point(m.faces[3 * f + 2])};
        std::vector<Rational>& area = sums.areas[m.face_facets[f]];
        area.resize(3);
        for (std::size_t k = 0; k < 3; ++k) {
            const auto along = [&](int i, std::size_t axis) {
                return Rational(p[i][axis % 3]) - Rational(p[0][axis % 3]);
            };
            area[k] += along(1, k + 1) * along(2, k + 2) - along(1, k + 2) * along(2, k + 1);
        }
    }
    return sums;
}

inline void expect_equal(const SolidMesh& a, const SolidMesh& b) {
    const auto equal = [](const auto& one, const auto& other) {
        return std::equal(one.begin(), one.end(), other.begin(), other.end());
    };
    EXPECT_TRUE(equal(a.points, b.points));
    EXPECT_TRUE(equal(a.tetrahedra, b.tetrahedra));
    EXPECT_TRUE(equal(a.neighbors, b.neighbors));
    EXPECT_TRUE(equal(a.regions, b.regions));
    EXPECT_TRUE(equal(a.faces, b.faces));
    EXPECT_TRUE(equal(a.face_tetrahedra, b.face_tetrahedra));
    EXPECT_TRUE(equal(a.face_facets, b.face_facets));
    EXPECT_TRUE(equal(a.face_markers, b.face_markers));
    EXPECT_TRUE(equal(a.unused_faces, b.unused_faces));
    EXPECT_TRUE(equal(a.edges, b.edges));
    EXPECT_TRUE(equal(a.edge_segments, b.edge_segments));
    EXPECT_TRUE(equal(a.edge_markers, b.edge_markers));
}

// A copy of a mesh, with a memory of its own.
struct Copy {
    explicit Copy(const SolidMesh& from) : mesh(memory) {
        mesh.points.copy(from.points);
        mesh.exact_points.copy(from.exact_points);
        mesh.point_origins.copy(from.point_origins);
        mesh.tetrahedra.copy(from.tetrahedra);
        mesh.neighbors.copy(from.neighbors);
        mesh.regions.copy(from.regions);
        mesh.region_markers.copy(from.region_markers);
        mesh.faces.copy(from.faces);
        mesh.face_tetrahedra.copy(from.face_tetrahedra);
        mesh.face_facets.copy(from.face_facets);
        mesh.face_markers.copy(from.face_markers);
        mesh.edges.copy(from.edges);
        mesh.edge_segments.copy(from.edge_segments);
        mesh.edge_markers.copy(from.edge_markers);
        mesh.steiner_edges.copy(from.steiner_edges);
        mesh.steiner_parameters.copy(from.steiner_parameters);
        mesh.unused_faces.copy(from.unused_faces);
        mesh.planar_facets = from.planar_facets;
        mesh.cavities = from.cavities;
        mesh.is_rounded = from.is_rounded;
        mesh.grid = from.grid;
    }
    Allocator memory;
    SolidMesh mesh;
};

}  // namespace mgdt
