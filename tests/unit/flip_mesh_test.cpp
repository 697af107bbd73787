// SPDX-License-Identifier: MIT
// Exchanges of tetrahedra that fill the same place.
#include "recovery/flip_mesh.hpp"

#include <gtest/gtest.h>

namespace mgdt {
namespace {

// Two tetrahedra with the face 0 1 2, between the points 3 above and 4 below.
class TwoTetrahedra : public testing::Test {
  protected:
    TwoTetrahedra() : points(allocator), mesh(points, allocator) {
        for (const double x : {0., 0., 0., 3., 0., 0., 0., 3., 0., 1., 1., 2., 1., 1., -2.})
            points.push_back(x);
        mesh.hints.resize(5, no_tetrahedron);
        mesh.add(0, 1, 2, 3);
        mesh.add(2, 1, 0, 4);
        // The face 0 1 2 is opposite to the last corner of both.
        mesh.join(3, 7);
        for (std::uint32_t v = 0; v < 5; ++v) mesh.hints[v] = v == 4 ? 1 : 0;
    }
    bool replace(std::initializer_list<FlipMesh::Corners> tetrahedra) {
        Buffer<std::uint32_t> removed(allocator);
        Buffer<FlipMesh::Corners> added(allocator);
        removed.push_back(0);
        removed.push_back(1);
        for (const FlipMesh::Corners& t : tetrahedra) added.push_back(t);
        return mesh.replace(removed, added);
    }
    std::size_t living() const {
        std::size_t count = 0;
        for (const FlipMesh::Tetrahedron& t : mesh.tetrahedra) count += !t.is_dead();
        return count;
    }

    Allocator allocator;
    Buffer<double> points;
    FlipMesh mesh;
};

TEST_F(TwoTetrahedra, BecomeThreeAndTwoAgain) {
    ASSERT_TRUE(replace({{{4, 0, 1, 3}}, {{4, 1, 2, 3}}, {{4, 2, 0, 3}}}));
    EXPECT_EQ(living(), 3u);
    for (const FlipMesh::Tetrahedron& t : mesh.tetrahedra)
        EXPECT_TRUE(mesh.is_positive({{t.v[0], t.v[1], t.v[2], t.v[3]}}));
    mesh.undo(0);
    EXPECT_EQ(living(), 2u);
    EXPECT_TRUE(mesh.tetrahedra[0].has(3));
    EXPECT_TRUE(mesh.tetrahedra[1].has(4));
}

TEST_F(TwoTetrahedra, AreNotReplacedByOthersWithOtherFaces) {
    EXPECT_FALSE(replace({{{4, 0, 1, 3}}, {{4, 1, 2, 3}}}));
    EXPECT_FALSE(replace({{{0, 1, 2, 3}}}));
    EXPECT_EQ(living(), 2u);
}

// All faces are paired, but not on different sides of them.
TEST_F(TwoTetrahedra, AreNotReplacedByOnesOnTheSameSideOfAFace) {
    EXPECT_FALSE(replace({{{0, 1, 2, 3}}, {{0, 1, 2, 4}}}));
    EXPECT_FALSE(replace({{{2, 1, 0, 3}}, {{0, 1, 2, 4}}}));
    EXPECT_FALSE(replace({{{4, 0, 1, 3}}, {{4, 1, 2, 3}}, {{4, 0, 2, 3}}}));
    EXPECT_EQ(living(), 2u);
    EXPECT_TRUE(replace({{{0, 1, 2, 3}}, {{2, 1, 0, 4}}}));
}

}  // namespace
}  // namespace mgdt
