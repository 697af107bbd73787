// SPDX-License-Identifier: MIT
// The check of tetrahedra from elsewhere: it accepts every Delaunay triangulation, and finds each
// kind of defect under the name that it reports.
#include "cli/mesh_check.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "../support/points.hpp"
#include "cli/program_triangulation.hpp"

namespace mgdt::cli {
namespace {

using mgdt_tests::lattice;
using mgdt_tests::Points;
using mgdt_tests::uniform;

Reference reference_of(const Points& points) {
    TriangulationOptions options;
    options.quiet = true;
    Triangulation t = make_triangulation(options);
    insert(t, points, "points", true);
    return {tetrahedra(t), t.point_map<MeshIndex>()};
}

struct Case {
    Mesh mesh;
    Reference reference;

    explicit Case(const Points& points) : reference(reference_of(points)) {
        mesh.points = points;
        mesh.tetrahedra = reference.tetrahedra;
        mesh.has_tetrahedra = true;
    }
    MeshReport report() const { return check_mesh(mesh, reference); }
    MeshIndex* tetrahedron(std::size_t i) { return &mesh.tetrahedra[4 * i]; }
};

// The names of what was found wrong.
std::vector<std::string> defects(const Case& c) {
    const MeshReport report = c.report();
    std::vector<std::string> names;
    for (const Finding& f : report.findings) {
        if (!f.good) names.emplace_back(f.what);
    }
    EXPECT_EQ(report.valid, names.empty());
    return names;
}

using Names = std::vector<std::string>;

TEST(MeshCheck, AcceptsTheLibrary) {
    for (const Points& points : {uniform(300), lattice(5), Points{}, Points{1, 2, 3},
                                 Points{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}}) {
        const Case c(points);
        EXPECT_EQ(defects(c), Names{});
        EXPECT_EQ(c.report().in_common, c.mesh.tetrahedron_count());
    }
}

TEST(MeshCheck, AcceptsDuplicatesUnderAnyNumber) {
    Points points = uniform(50);
    points.insert(points.end(), points.begin(), points.begin() + 3);
    Case c(points);
    for (MeshIndex& v : c.mesh.tetrahedra) {
        if (v == 0) v = 50;
    }
    EXPECT_EQ(defects(c), Names{});
    EXPECT_EQ(c.report().in_common, c.mesh.tetrahedron_count());
}

// The mirrored lattice has its ties broken the other way: mirrored back, its tetrahedra are
// another Delaunay triangulation of the same points, with every orientation reversed.
TEST(MeshCheck, AcceptsOtherTies) {
    Case c(lattice(4));
    Points mirrored = c.mesh.points;
    for (std::size_t i = 0; i < mirrored.size(); i += 3) mirrored[i] = -mirrored[i];
    c.mesh.tetrahedra = reference_of(mirrored).tetrahedra;
    EXPECT_EQ(defects(c), Names{});
    EXPECT_LT(c.report().in_common, c.mesh.tetrahedron_count());
}

TEST(MeshCheck, Orientation) {
    Case c(uniform(100));
    std::swap(c.tetrahedron(5)[0], c.tetrahedron(5)[1]);
    EXPECT_EQ(defects(c), Names{"orientation"});
    EXPECT_NE(c.report().findings[0].detail.find("number 5"), std::string::npos);
}

TEST(MeshCheck, FlatTetrahedron) {
    Case c(lattice(3));
    const std::int64_t flat[4] = {0, 1, 3, 4};
    std::copy(flat, flat + 4, c.tetrahedron(2));
    EXPECT_EQ(defects(c)[0], "orientation");
    EXPECT_NE(c.report().findings[0].detail.find("1 tetrahedron has no volume"), std::string::npos);
}

TEST(MeshCheck, MissingTetrahedron) {
    Case c(uniform(100));
    c.mesh.tetrahedra.resize(c.mesh.tetrahedra.size() - 4);
    EXPECT_EQ(defects(c), Names{"hull"});
}

TEST(MeshCheck, RepeatedTetrahedron) {
    Case c(uniform(100));
    c.mesh.tetrahedra.insert(c.mesh.tetrahedra.end(), c.tetrahedron(0), c.tetrahedron(0) + 4);
    const Names found = defects(c);
    EXPECT_NE(std::find(found.begin(), found.end(), "facets"), found.end());
    EXPECT_NE(std::find(found.begin(), found.end(), "cover"), found.end());
}

// A tetrahedron laid over four others.
TEST(MeshCheck, DoubleCover) {
    Case c(Points{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.3, 0.3, 0.2});
    c.mesh.tetrahedra.insert(c.mesh.tetrahedra.end(), {0, 1, 2, 3});
    const Names found = defects(c);
    EXPECT_NE(std::find(found.begin(), found.end(), "cover"), found.end());
}

// Tetrahedra around an axis that go round twice: no test of neighbours alone can tell.
TEST(MeshCheck, SpaceCoveredTwice) {
    for (const double outer : {1.0, 1.001}) {
        Points points = {0, 0, 0.25, 0, 0, -0.25};
        std::vector<MeshIndex> tetrahedra;
        for (int i = 0; i < 10; ++i) {
            const double angle = 4 * 3.14159265358979 * (i % 5) / 10, radius = i < 5 ? 1 : outer;
            points.insert(points.end(), {radius * std::cos(angle), radius * std::sin(angle), 0});
            tetrahedra.insert(tetrahedra.end(), {0, 1, 2 + i, 2 + (i + 1) % 10});
        }
        Case c(points);
        c.mesh.tetrahedra = tetrahedra;
        // Where the rounds coincide points are repeats of each other, and facets have four.
        const Names found = defects(c);
        EXPECT_NE(std::find(found.begin(), found.end(), outer == 1 ? "facets" : "cover"),
                  found.end());
    }
}

// A bubble inside, whose boundary is a closed surface of its own.
TEST(MeshCheck, Bubble) {
    Case c(lattice(5));
    std::size_t t = 0;
    const auto is_inner = [&](std::size_t i) {
        for (int k = 0; k < 4; ++k) {
            const double* p = &c.mesh.points[3 * static_cast<std::size_t>(c.tetrahedron(i)[k])];
            for (int j = 0; j < 3; ++j)
                if (p[j] == 0 || p[j] == 4) return false;
        }
        return true;
    };
    while (!is_inner(t)) ++t;
    c.mesh.tetrahedra.erase(c.mesh.tetrahedra.begin() + static_cast<std::ptrdiff_t>(4 * t),
                            c.mesh.tetrahedra.begin() + static_cast<std::ptrdiff_t>(4 * t + 4));
    EXPECT_EQ(defects(c), Names{"hull"});
}

// Two bipyramids that share an edge: four boundary facets meet there.
TEST(MeshCheck, EdgeOfFourBoundaryFacets) {
    Case c(Points{0, 0, 0, 0, 0, 1, 1, 0.1, 0, 1, -0.1, 0.5, -1, 0.1, 0, -1, -0.1, 0.5});
    c.mesh.tetrahedra = {0, 1, 3, 2, 0, 1, 4, 5};
    EXPECT_EQ(defects(c), Names{"hull"});
    EXPECT_NE(c.report().findings[3].detail.find("do not have two boundary facets"),
              std::string::npos);
}

// A bipyramid over the triangle 0 1 2 with its apexes near each other is Delaunay with three
// tetrahedra around the axis or with two, depending on the height: the other choice is wrong.
TEST(MeshCheck, NotDelaunay) {
    Case c(Points{1, 0, 0, -0.5, 0.875, 0, -0.5, -0.875, 0, 0, 0, 0.25, 0, 0, -0.25});
    ASSERT_EQ(c.mesh.tetrahedron_count(), 3u);
    c.mesh.tetrahedra = {0, 1, 2, 3, 0, 2, 1, 4};
    EXPECT_EQ(defects(c), Names{"spheres"});
}

TEST(MeshCheck, UnusedPoint) {
    Case c(Points{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.125, 0.125, 0.125});
    c.mesh.tetrahedra = {0, 1, 2, 3};
    EXPECT_EQ(defects(c), Names{"vertices"});
    c.mesh.tetrahedra.clear();
    EXPECT_EQ(defects(c), Names{"vertices"});
}

TEST(MeshCheck, WrongNeighbour) {
    Case c(uniform(30));
    TriangulationOptions options;
    options.quiet = true;
    Triangulation t = make_triangulation(options);
    insert(t, c.mesh.points, "points", true);
    c.mesh.neighbors = neighbors(t);
    EXPECT_EQ(defects(c), Names{});
    std::swap(c.mesh.neighbors[4], c.mesh.neighbors[5]);
    EXPECT_EQ(defects(c), Names{"neighbours"});
    // Tetrahedra all turned round take their neighbours along.
    c.mesh.neighbors = neighbors(t);
    for (std::size_t i = 0; i < c.mesh.tetrahedra.size(); i += 4) {
        std::swap(c.mesh.tetrahedra[i], c.mesh.tetrahedra[i + 1]);
        std::swap(c.mesh.neighbors[i], c.mesh.neighbors[i + 1]);
    }
    EXPECT_EQ(defects(c), Names{});
}

TEST(MeshCheck, ExtremeScales) {
    for (const double scale : {1e300, 1e-300, 5e-324}) {
        Points points = lattice(3);
        for (double& x : points) x *= scale;
        Case c(points);
        EXPECT_EQ(defects(c), Names{}) << scale;
        c.mesh.tetrahedra.resize(c.mesh.tetrahedra.size() - 4);
        EXPECT_NE(defects(c), Names{}) << scale;
    }
}

}  // namespace
}  // namespace mgdt::cli
