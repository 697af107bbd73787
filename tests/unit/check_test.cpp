// SPDX-License-Identifier: MIT
// The check must fail on what is wrong: each kind of damage is done to a sound mesh and must be
// found at the level that promises it.
#include "query/check.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <memory>
#include <random>
#include <set>
#include <string>
#include <vector>

#include "core/triangulation.hpp"
#include "kernel/circumsphere.hpp"
#include "platform/error.hpp"

namespace mgdt {
namespace {

using Points = std::vector<double>;

Points random_points(int n, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(0, 1);
    Points xyz;
    for (int i = 0; i < 3 * n; ++i) xyz.push_back(uniform(random));
    return xyz;
}

std::unique_ptr<Triangulation> triangulate(const Points& xyz) {
    auto t = std::make_unique<Triangulation>(nullptr, nullptr, nullptr);
    const double* axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
    t->insert(xyz.size() / 3, axis, 3);
    return t;
}

// Empty if the check passes.
std::string complaint(const Triangulation& t, int level) {
    Team team;
    try {
        check_mesh(team, t.mesh(), t.point_map(), t.allocator(), level, 0);
        return {};
    } catch (const Error& error) {
        EXPECT_EQ(error.status, MGDT_ERR_CHECK_FAILED);
        return error.message;
    }
}

struct Damage {
    const char* name;
    int level;  // the least that must find it
    std::function<void(Mesh&)> act;
};

TetId first_finite(const Mesh& mesh) {
    TetId t = 0;
    while (mesh.tetrahedra[t].is_dead() || mesh.tetrahedra[t].is_ghost()) ++t;
    return t;
}

TetId first_ghost(const Mesh& mesh) {
    TetId t = 0;
    while (mesh.tetrahedra[t].is_dead() || !mesh.tetrahedra[t].is_ghost()) ++t;
    return t;
}

// A vertex that no ghost has.
VertexId inner_vertex(const Mesh& mesh) {
    std::vector<bool> outer(mesh.vertices.size(), false);
    for (const Tetrahedron& t : mesh.tetrahedra)
        if (!t.is_dead() && t.is_ghost())
            for (const VertexId v : t.v) outer[v] = true;
    VertexId v = 1;
    while (outer[v]) ++v;
    return v;
}

const std::vector<Damage> damages = {
    {"vertex replaced", 1, [](Mesh& m) { m.tetrahedra[first_finite(m)].v[2] = 1; }},
    {"vertex beyond the store", 1,
     [](Mesh& m) {
         m.tetrahedra[first_finite(m)].v[1] = static_cast<VertexId>(m.vertices.size());
     }},
    {"vertices swapped", 1,
     [](Mesh& m) {
         Tetrahedron& t = m.tetrahedra[first_finite(m)];
         std::swap(t.v[1], t.v[2]);
     }},
    {"neighbours swapped", 1,
     [](Mesh& m) {
         Tetrahedron& t = m.tetrahedra[first_finite(m)];
         std::swap(t.n[0], t.n[3]);
     }},
    {"neighbour beyond the store", 1,
     [](Mesh& m) { m.tetrahedra[first_finite(m)].n[0] = 0xFFFFFFF0u; }},
    {"tetrahedron dead", 1, [](Mesh& m) { m.tetrahedra[first_finite(m)].kill(); }},
    {"ghost taken for finite", 1, [](Mesh& m) { m.tetrahedra[first_ghost(m)].e = 1e-10; }},
    {"finite taken for ghost", 1, [](Mesh& m) { m.tetrahedra[first_finite(m)].e = -1e-10; }},
    {"count of ghosts", 1, [](Mesh& m) { ++m.ghost_count; }},
    {"a ghost that is none", 1, [](Mesh& m) { m.a_ghost = first_finite(m); }},
    {"free slot in use", 1,
     [](Mesh& m) {
         // The counts agree: one slot is dead and not in the list.
         const TetId t = first_finite(m);
         m.free_slots.push_back(t == 0 ? 1 : 0);
         m.tetrahedra[t].kill();
     }},
    {"slot near a vertex", 1, [](Mesh& m) { m.near[5] = static_cast<TetId>(m.tetrahedra.size()); }},
    {"vertex's index", 1, [](Mesh& m) { ++m.vertices[7].index; }},
    {"inner vertex moved out", 2, [](Mesh& m) { m.vertices[inner_vertex(m)].x[0] += 10; }},
    {"inner vertex moved a little", 2,
     [](Mesh& m) {
         // Far enough to enter a sphere, not to turn a tetrahedron over.
         const VertexId v = inner_vertex(m);
         for (double step = 1e-4;; step *= 1.5) {
             m.vertices[v].x[2] += step;
             for (const Tetrahedron& t : m.tetrahedra) {
                 if (t.is_dead() || t.is_ghost()) continue;
                 for (int f = 0; f < 4; ++f) {
                     const Tetrahedron& n = m.tetrahedra[t.n[f] >> 2];
                     const VertexId opposite = n.v[t.n[f] & 3];
                     if (!n.is_ghost() && is_conflict_exact(m, t, m.vertices[opposite].x)) return;
                 }
             }
         }
     }},
};

TEST(Check, PassesOnSoundMeshes) {
    for (const int n : {4, 5, 30, 500})
        for (int level = 1; level <= 3; ++level)
            EXPECT_EQ(complaint(*triangulate(random_points(n, 1)), level), "");
}

TEST(Check, FindsDamage) {
    for (const Damage& damage : damages) {
        const auto t = triangulate(random_points(200, 2));
        damage.act(const_cast<Mesh&>(t->mesh()));
        for (int level = damage.level; level <= 3; ++level)
            EXPECT_NE(complaint(*t, level), "") << damage.name << " at level " << level;
    }
}

TEST(Check, FindsPointsWithoutVertex) {
    const auto t = triangulate(random_points(50, 3));
    const_cast<Buffer<VertexId>&>(t->point_map())[9] = 1000;
    EXPECT_NE(complaint(*t, 1), "");
}

// Four points around an axis of two. One of the four moved towards the axis leaves all tetrahedra
// positive and locally Delaunay, but its edges to the axis concave.
TEST(Check, FindsConcaveHulls) {
    const Points xyz = {0,   0,    0.2, 0,    0,     -0.2, 0.9, 0,     0,
                        0.5, 0.87, 0,   -1.0, 0.001, 0,    0.5, -0.88, 0};
    const auto t = triangulate(xyz);
    ASSERT_EQ(complaint(*t, 3), "");
    ASSERT_EQ(t->mesh().finite_count(), 4u);
    Mesh& mesh = const_cast<Mesh&>(t->mesh());
    for (Vertex& v : mesh.vertices)
        if (v.index == 2) v.x[0] = 0.3;
    EXPECT_EQ(complaint(*t, 2), "");
    EXPECT_NE(complaint(*t, 3).find("convex"), std::string::npos);
}

// Cospherical points, moved by a hair, are triangulated in any of several ways; put back in
// place they are tied, and only the canonical way may pass level 3.
TEST(Check, FindsTiesBrokenOtherwise) {
    // On the sphere of radius 15, no four on a plane.
    const Points tied = {15, 0, 0, 2, 5, 14, -10, 10, 5, -2, -14, 5, 11, 2, -10, -5, -2, -14};
    const auto sets = [](const Mesh& mesh) {
        std::set<std::set<std::uint32_t>> tetrahedra;
        for (const Tetrahedron& t : mesh.tetrahedra) {
            if (t.is_dead() || t.is_ghost()) continue;
            std::set<std::uint32_t> indices;
            for (const VertexId v : t.v) indices.insert(mesh.vertices[v].index);
            tetrahedra.insert(indices);
        }
        return tetrahedra;
    };
    const auto canonical = sets(triangulate(tied)->mesh());
    int other = 0;
    for (unsigned seed = 0; seed < 100; ++seed) {
        Points moved = tied;
        const Points noise = random_points(6, seed);
        for (std::size_t i = 0; i < moved.size(); ++i) moved[i] += (noise[i] - 0.5) * 1e-9;
        const auto t = triangulate(moved);
        Mesh& mesh = const_cast<Mesh&>(t->mesh());
        for (std::size_t v = 1; v < mesh.vertices.size(); ++v)
            for (std::size_t k = 0; k < 3; ++k)
                mesh.vertices[v].x[k] = tied[3 * mesh.vertices[v].index + k];
        EXPECT_EQ(complaint(*t, 2), "");
        const bool passes = complaint(*t, 3).empty();
        EXPECT_EQ(passes, sets(mesh) == canonical);
        other += !passes;
    }
    EXPECT_GT(other, 0);
    EXPECT_LT(other, 100);
}

}  // namespace
}  // namespace mgdt
