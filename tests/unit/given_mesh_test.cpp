// SPDX-License-Identifier: MIT
// Meshes that a caller gives: tetrahedra in any order, and all that is refused.
#include "solid/given_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>

#include "improvable_meshes.hpp"
#include "improvement/flexible_mesh.hpp"
#include "mesh_volumes.hpp"
#include "one_thread.hpp"

namespace mgdt {
namespace {

// The tetrahedra and faces of a mesh, in random orders and orientations.
class Shuffled {
  public:
    Shuffled(const SolidMesh& from, unsigned seed) : mesh(memory_) {
        std::mt19937 random(seed);
        mesh.points.copy(from.points);
        const auto shuffled = [&](std::size_t count) {
            std::vector<std::uint32_t> order(count);
            for (std::uint32_t i = 0; i < count; ++i) order[i] = i;
            std::shuffle(order.begin(), order.end(), random);
            return order;
        };
        for (const std::uint32_t t : shuffled(from.tetrahedron_count())) {
            std::vector<std::uint32_t> v(from.tetrahedra.begin() + 4 * std::size_t{t},
                                         from.tetrahedra.begin() + 4 * std::size_t{t} + 4);
            std::shuffle(v.begin(), v.end(), random);
            for (const std::uint32_t p : v) mesh.tetrahedra.push_back(p);
            mesh.tetrahedron_markers.push_back(static_cast<std::int32_t>(from.regions[t]) - 1);
        }
        for (const std::uint32_t f : shuffled(from.face_facets.size())) {
            if (from.face_tetrahedra[2 * std::size_t{f}] == no_index &&
                from.face_tetrahedra[2 * std::size_t{f} + 1] == no_index)
                continue;
            for (std::size_t k = 0; k < 3; ++k)
                mesh.faces.push_back(from.faces[3 * std::size_t{f} + k]);
            mesh.face_markers.push_back(from.face_markers[f]);
        }
    }
    Allocator& memory() { return memory_; }

  private:
    Allocator memory_;

  public:
    GivenMesh mesh;
};

TEST(GivenMesh, IsThatOfTheDomain) {
    unsigned seed = 0;
    for_improvable_meshes([&](const SolidMesh& expected) {
        Shuffled given(expected, ++seed);
        Allocator memory;
        SolidMesh mesh(memory);
        link_mesh(given.mesh, 0, one_thread(), memory, Unwatched(), mesh);
        ASSERT_EQ(mesh.region_markers.size(), expected.region_markers.size());
        for (std::size_t t = 0; t < mesh.tetrahedron_count(); ++t) {
            ASSERT_TRUE(std::is_permutation(mesh.tetrahedra.begin() + 4 * t,
                                            mesh.tetrahedra.begin() + 4 * t + 4,
                                            given.mesh.tetrahedra.begin() + 4 * t));
            ASSERT_EQ(mesh.region_markers[mesh.regions[t]], given.mesh.tetrahedron_markers[t]);
        }
        ASSERT_TRUE(
            std::equal(given.mesh.faces.begin(), given.mesh.faces.end(), mesh.faces.begin()));
        ASSERT_TRUE(std::equal(given.mesh.face_markers.begin(), given.mesh.face_markers.end(),
                               mesh.face_markers.begin()));
        expect_equal_volumes(mesh);
        try {
            check_mesh(mesh, 0, memory, Unwatched());
        } catch (const Error& e) {
            ADD_FAILURE() << e.message;
        }
        // The mesh that is written back is sorted.
        FlexibleMesh(mesh, one_thread(), memory).write(mesh);
        EXPECT_TRUE(std::equal(mesh.tetrahedra.begin(), mesh.tetrahedra.end(),
                               expected.tetrahedra.begin(), expected.tetrahedra.end()));
        EXPECT_TRUE(std::equal(mesh.neighbors.begin(), mesh.neighbors.end(),
                               expected.neighbors.begin(), expected.neighbors.end()));
    });
}

TEST(GivenMesh, JoinsFacesInOnePlane) {
    MeshedDomain domain;
    give(domain, gridded_box(3, 3, 3, 0.3, 1));
    domain.build();
    Shuffled given(domain.mesh(), 1);
    Allocator memory;
    SolidMesh mesh(memory);
    link_mesh(given.mesh, 0, one_thread(), memory, Unwatched(), mesh);
    EXPECT_EQ(mesh.planar_facets, 6u);
    EXPECT_EQ(mesh.edges.size() / 2, 36u);
    // Without the caller's faces those at the end of the mesh are found.
    given.mesh.faces.clear();
    given.mesh.face_markers.clear();
    SolidMesh bare(memory);
    link_mesh(given.mesh, 0, one_thread(), memory, Unwatched(), bare);
    EXPECT_EQ(bare.planar_facets, 6u);
    EXPECT_EQ(bare.face_facets.size(), mesh.face_facets.size());
    // An edge of the caller's inside of a side stays, and has its marker.
    given.mesh.edges.push_back(bare.faces[1]);
    given.mesh.edges.push_back(bare.faces[0]);
    given.mesh.edge_markers.push_back(-5);
    SolidMesh edged(memory);
    link_mesh(given.mesh, 0, one_thread(), memory, Unwatched(), edged);
    EXPECT_EQ(std::count(edged.edge_markers.begin(), edged.edge_markers.end(), -5), 1);
    EXPECT_EQ(edged.edge_markers[0], -5);
    EXPECT_EQ(edged.edge_segments[0], 0u);
    EXPECT_EQ(edged.edges[0], bare.faces[1]);
    EXPECT_GE(edged.edges.size(), bare.edges.size());
}

// Two tetrahedra at the triangle of points 0, 1 and 2, and points beside them.
class Refusals : public testing::Test {
  protected:
    Refusals() : given(memory), mesh(memory) {
        for (const double x :
             {0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 0., 1., 0., 0., -1., 1., 1., 0., 0., 0., 2.})
            given.points.push_back(x);
        add({0, 1, 2, 3});
        add({4, 0, 1, 2});
    }
    void add(const std::vector<std::uint32_t>& v) {
        for (const std::uint32_t p : v) given.tetrahedra.push_back(p);
    }
    void expect(const char* message) {
        SolidMesh refused(memory);
        const Error error =
            error_of([&] { link_mesh(given, 1, one_thread(), memory, Unwatched(), refused); });
        EXPECT_EQ(error.status, MGDT_ERR_INVALID_ARGUMENT);
        EXPECT_STREQ(error.message, message);
    }
    Allocator memory;
    GivenMesh given;
    SolidMesh mesh;
};
using GivenMeshRefusals = Refusals;

TEST_F(GivenMeshRefusals, TwoTetrahedraAreAMesh) {
    link_mesh(given, 1, one_thread(), memory, Unwatched(), mesh);
    EXPECT_EQ(mesh.face_facets.size(), 6u);
    EXPECT_EQ(mesh.unused_points.size(), 2u);
    // The faces in the planes x = 0 and y = 0 continue each other at one edge each.
    EXPECT_EQ(mesh.planar_facets, 4u);
    EXPECT_EQ(mesh.edges.size(), 14u);
}

TEST_F(GivenMeshRefusals, Corners) {
    add({0, 1, 1, 3});
    expect("tetrahedron 3 has a corner twice");
}

TEST_F(GivenMeshRefusals, FlatTetrahedra) {
    add({0, 1, 2, 5});
    expect("tetrahedron 3 is flat");
}

TEST_F(GivenMeshRefusals, TheSameTwice) {
    add({3, 2, 1, 0});
    expect("tetrahedra 1 and 3 have the same corners");
}

TEST_F(GivenMeshRefusals, ThreeAtAFace) {
    add({0, 1, 2, 6});
    expect("tetrahedra 1, 2 and 3 have a common face");
}

TEST_F(GivenMeshRefusals, OnTheSameSide) {
    given.tetrahedra.clear();
    add({0, 1, 2, 3});
    add({0, 1, 2, 6});
    expect("tetrahedra 1 and 2 are on the same side of their common face");
}

TEST_F(GivenMeshRefusals, FacesOfNone) {
    for (const std::uint32_t v : {0u, 1u, 2u, 0u, 3u, 4u}) given.faces.push_back(v);
    expect("face 2 is no face of a tetrahedron");
    given.faces.resize(3);
    for (const std::uint32_t v : {2u, 0u, 1u}) given.faces.push_back(v);
    expect("faces 1 and 2 have the same corners");
    given.faces.resize(3);
    given.faces.push_back(6);
    given.faces.push_back(6);
    given.faces.push_back(6);
    expect("face 2 is no face of a tetrahedron");
}

TEST_F(GivenMeshRefusals, EdgesOfNone) {
    for (const std::uint32_t v : {0u, 1u, 3u, 4u}) given.edges.push_back(v);
    expect("edge 2 is no edge of a tetrahedron");
    given.edges[2] = 1;
    given.edges[3] = 0;
    expect("edges 1 and 2 have the same ends");
}

}  // namespace
}  // namespace mgdt
