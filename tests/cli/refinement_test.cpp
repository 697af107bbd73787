// SPDX-License-Identifier: MIT
//
// The finite-element meshes of docs/data, their reader, and local refinement.
#include "cli/point_sets/refinement.hpp"

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cli/element_mesh.hpp"
#include "generated_points.hpp"

namespace mgdt::cli {
namespace {

double volume(const ElementMesh& mesh, const std::array<std::uint32_t, 4>& t) {
    std::array<Point, 3> e;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) e[i][k] = mesh.nodes[t[i + 1]][k] - mesh.nodes[t[0]][k];
    }
    return (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) +
            e[0][1] * (e[1][2] * e[2][0] - e[1][0] * e[2][2]) +
            e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) /
           6;
}

TEST(ElementMesh, DataAreMeshesOfSolids) {
    for (const std::string name : {"machine", "church"}) {
        const ElementMesh mesh =
            read_element_mesh(std::string(MGDT_TEST_DATA_DIRECTORY) + "/" + name + ".msh");
        EXPECT_GT(mesh.nodes.size(), 10000U) << name;
        EXPECT_GT(mesh.tetrahedra.size(), 2 * mesh.nodes.size()) << name;
        for (const auto& t : mesh.tetrahedra) ASSERT_GT(volume(mesh, t), 0) << name;
    }
}

TEST(ElementMesh, BadFilesAreNamed) {
    const std::string good = std::string(MGDT_TEST_DATA_DIRECTORY) + "/machine.msh";
    std::ifstream file(good, std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    const auto refused = [](const std::string& path, const std::string& word) {
        try {
            read_element_mesh(path);
            ADD_FAILURE() << "accepted, though " << word;
        } catch (const std::runtime_error& e) {
            const std::string message = e.what();
            EXPECT_NE(message.find(path), std::string::npos) << message;
            EXPECT_NE(message.find(word), std::string::npos) << message;
        }
    };
    refused("/nonexistent/machine.msh", "No such file");

    std::string pattern = (std::filesystem::temp_directory_path() / "mgdt-XXXXXX").string();
    ASSERT_NE(mkdtemp(pattern.data()), nullptr);
    const std::string bad = pattern + "/bad.msh";
    const auto try_bytes = [&](const std::string& content) {
        std::ofstream(bad, std::ios::binary) << content;
        refused(bad, "byte");
    };
    try_bytes("");
    try_bytes("solid from a CAD program\n");
    try_bytes(bytes.substr(0, bytes.size() / 8));  // among the nodes
    try_bytes(bytes.substr(0, bytes.size() / 2));  // among the tetrahedra
    std::string changed = bytes;
    changed.replace(changed.find("$Elements\n") + 10, 1, "99999999999999999999");
    try_bytes(changed);
    changed = bytes;
    changed[changed.size() - std::strlen("\n$EndElements\n") - 1] = 0x7f;  // a node's number
    try_bytes(changed);
    std::filesystem::remove_all(pattern);

    GenerateOptions options;
    options.data_directory = "/nonexistent";
    EXPECT_THROW(generate("church", 10, options), std::runtime_error);
}

TEST(Refinement, GivesTheNodesOfTheMeshFirst) {
    for (const std::string name : {"machine", "church"}) {
        const Points base =
            read_element_mesh(std::string(MGDT_TEST_DATA_DIRECTORY) + "/" + name + ".msh").nodes;
        EXPECT_EQ(points_of(name, base.size()), base);
        EXPECT_EQ(points_of(name, 1000), Points(base.begin(), base.begin() + 1000));
        for (const std::size_t more : {std::size_t{1}, std::size_t{5000}, base.size()}) {
            const Points refined = points_of(name, base.size() + more);
            ASSERT_EQ(refined.size(), base.size() + more) << name;
            EXPECT_TRUE(std::equal(base.begin(), base.end(), refined.begin())) << name;
            EXPECT_EQ(distinct(refined), refined.size()) << name;
        }
    }
}

TEST(Refinement, IsLocal) {
    const std::map<std::string, std::pair<Point, double>> regions{
        {"machine", {{0, 0, 103}, 30}},  // of 170 mm
        {"church", {{29, 5.5, 3}, 12}},  // of 58 m
    };
    for (const auto& [name, region] : regions) {
        const Points points = points_of(name, 100000);
        Point low = points[0];
        Point high = points[0];
        std::size_t inside = 0;
        for (const Point& p : points) {
            if (distance(p, region.first) < region.second) ++inside;
            for (std::size_t i = 0; i < 3; ++i) {
                low[i] = std::min(low[i], p[i]);
                high[i] = std::max(high[i], p[i]);
            }
        }
        EXPECT_GT(inside, 75000U) << name;
        EXPECT_GT(distance(low, high), 3 * region.second) << name;
        // Midpoints stay within the mesh, so nothing lies outside the box of its nodes.
        for (const Point& p : points_of(name, 10000)) {
            for (std::size_t i = 0; i < 3; ++i) EXPECT_TRUE(low[i] <= p[i] && p[i] <= high[i]);
        }
    }
}

// Of a regular tetrahedron at the centre of refinement, spacing grows with the distance.
TEST(Refinement, SpacingGrowsGradually) {
    ElementMesh mesh;
    mesh.nodes = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    mesh.tetrahedra = {{0, 1, 2, 3}};
    const Points points = refine(mesh, {{1, 1, 1}, 0.25}, 20000);
    ASSERT_EQ(points.size(), 20000U);
    EXPECT_EQ(distinct(points), 20000U);
    std::array<double, 5> densities{};
    for (std::size_t shell = 0; shell < densities.size(); ++shell) {
        const double inner = 0.3 * static_cast<double>(shell);
        const double outer = inner + 0.3;
        for (const Point& p : points) {
            const double r = distance(p, {1, 1, 1});
            if (inner <= r && r < outer) densities[shell] += 1;
        }
        densities[shell] /= outer * outer * outer - inner * inner * inner;
        if (shell > 0) {
            EXPECT_LT(densities[shell], densities[shell - 1]) << shell;
        }
        EXPECT_GT(densities[shell], 0) << shell;
    }
    // At a distance of four radii the spacing is 17 times that at the centre.
    EXPECT_GT(densities[0], 100 * densities[4]);
}

TEST(Refinement, NeedsAMesh) {
    EXPECT_THROW(refine({}, {{0, 0, 0}, 1}, 10), std::runtime_error);
    EXPECT_TRUE(refine({}, {{0, 0, 0}, 1}, 0).empty());
}

}  // namespace
}  // namespace mgdt::cli
