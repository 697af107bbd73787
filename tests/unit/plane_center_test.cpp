// SPDX-License-Identifier: MIT
// Places inside of half-spaces.
#include "recovery/plane_center.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace mgdt {
namespace {

// The half-spaces of the tetrahedra that join a point to the faces of the octahedron with corners
// at distance 1 from the origin, moved along the first axis.
class Octahedron : public testing::Test {
  protected:
    Octahedron() : points(allocator), mesh(points, allocator), faces(allocator), center(allocator) {
        for (int k = 0; k < 3; ++k)
            for (const double sign : {1.0, -1.0})
                for (int l = 0; l < 3; ++l)
                    points.push_back((l == k ? sign : 0) + (l == 0 ? 5 : 0));
        mesh.hints.resize(6, no_tetrahedron);
        for (const std::uint32_t x : {0u, 1u})
            for (const std::uint32_t y : {2u, 3u})
                for (const std::uint32_t z : {4u, 5u}) {
                    const bool is_turned = (x + y + z) % 2 == 0;
                    faces.push_back({{is_turned ? y : x, is_turned ? x : y, z, 6}});
                }
    }
    std::uint32_t add_point(double x, double y, double z) { return mesh.add_point({x, y, z}); }

    Allocator allocator;
    Buffer<double> points;
    FlipMesh mesh;
    Buffer<FlipMesh::Corners> faces;
    PlaneCenter center;
};

TEST_F(Octahedron, DrawsAPointToItsMiddle) {
    const std::uint32_t v = add_point(5.2, 0.1, -0.3);
    ASSERT_TRUE(mesh.are_positive(faces));
    constexpr double from[][3] = {{5.2, 0.1, -0.3}, {9, 1, 0.5}, {5.5, -40, 3}, {5, 0, 1}};
    for (const double(&x)[3] : from) {
        mesh.move_point(v, x);
        ASSERT_TRUE(enter_half_spaces(mesh, v, faces, 0, center));
        EXPECT_TRUE(mesh.are_positive(faces));
        center_new_point(mesh, v, faces, 0, center);
        for (int k = 0; k < 3; ++k) EXPECT_NEAR(mesh.point(v)[k], k == 0 ? 5 : 0, 1e-6);
    }
}

TEST_F(Octahedron, IsNotEnteredIfItIsTurnedInsideOut) {
    const std::uint32_t v = add_point(5.2, 0.1, -0.3);
    for (FlipMesh::Corners& t : faces) std::swap(t.v[0], t.v[1]);
    EXPECT_FALSE(enter_half_spaces(mesh, v, faces, 0, center));
    EXPECT_EQ(mesh.point(v)[0], 5.2);
}

}  // namespace
}  // namespace mgdt
