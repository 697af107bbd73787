// SPDX-License-Identifier: MIT
// The check must fail on triangulations that are Delaunay but for one property, at the level that
// promises it. Damage of every kind is in corruptions_test.cpp, other triangulations of the same
// points in flips_test.cpp.
#include "query/check.hpp"

#include <set>

#include "surgery.hpp"

namespace mgdt {
namespace {

using namespace surgery;

// As if the vertices had been given where they are now.
std::string complaint_as_given(Patient& p, int level) {
    p.set_exponents();
    p.set_spheres();
    return p.complaint(level);
}

TEST(Check, PassesOnSoundMeshes) {
    Random random(1);
    for (const std::size_t n : {4u, 5u, 30u, 500u})
        for (int level = 1; level <= 3; ++level)
            EXPECT_EQ(triangulate(uniform_points(n, random)).complaint(level), "");
}

TEST(Check, FindsVerticesMovedOut) {
    Random random(2);
    Patient p = triangulate(uniform_points(200, random));
    const std::set<VertexId> outer = p.hull();
    VertexId v = 1;
    while (outer.count(v) != 0) ++v;
    p.mesh().vertices[v].x[0] += 10;
    EXPECT_EQ(complaint_as_given(p, 1), "");
    EXPECT_NE(complaint_as_given(p, 2), "");
}

// Four points around an axis of two. One of the four moved towards the axis leaves all tetrahedra
// positive and locally Delaunay, but its edges to the axis concave.
TEST(Check, FindsConcaveHulls) {
    Patient p = triangulate(
        {0, 0, 0.2, 0, 0, -0.2, 0.9, 0, 0, 0.5, 0.87, 0, -1.0, 0.001, 0, 0.5, -0.88, 0});
    ASSERT_EQ(p.complaint(3), "");
    ASSERT_EQ(p.mesh().finite_count(), 4u);
    p.mesh().vertices[p.map()[2]].x[0] = 0.3;
    EXPECT_EQ(complaint_as_given(p, 2), "");
    EXPECT_NE(complaint_as_given(p, 3).find("hull"), std::string::npos);
}

// Cospherical points, moved by a hair, are triangulated in any of several ways; put back in
// place they are tied, and only the canonical way may pass level 3.
TEST(Check, FindsTiesBrokenOtherwise) {
    // On the sphere of radius 15, no four on a plane.
    const Points tied = {15, 0, 0, 2, 5, 14, -10, 10, 5, -2, -14, 5, 11, 2, -10, -5, -2, -14};
    const auto sets = [](Patient& p) {
        std::set<std::set<std::uint32_t>> tetrahedra;
        for (const Quad& q : p.finite()) {
            std::set<std::uint32_t> indices;
            for (const VertexId v : q) indices.insert(p.mesh().vertices[v].index);
            tetrahedra.insert(indices);
        }
        return tetrahedra;
    };
    Patient sound = triangulate(tied);
    const auto canonical = sets(sound);
    Random random(3);
    int other = 0;
    for (int round = 0; round < 100; ++round) {
        Points moved = tied;
        for (double& x : moved) x += (uniform(random) - 0.5) * 1e-9;
        Patient p = triangulate(moved);
        for (std::size_t v = 1; v < p.mesh().vertices.size(); ++v)
            std::copy_n(&tied[3 * p.mesh().vertices[v].index], 3, p.mesh().vertices[v].x);
        EXPECT_EQ(complaint_as_given(p, 2), "");
        const bool passes = complaint_as_given(p, 3).empty();
        EXPECT_EQ(passes, sets(p) == canonical);
        other += !passes;
    }
    EXPECT_GT(other, 0);
    EXPECT_LT(other, 100);
}

}  // namespace
}  // namespace mgdt
