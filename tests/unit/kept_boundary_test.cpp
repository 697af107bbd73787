// SPDX-License-Identifier: MIT
// Meshes of domains whose boundaries are kept: every triangle of a facet is one face, every segment
// one edge, and points are added inside of the domain only.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

#include "mesh_volumes.hpp"
#include "random_complexes.hpp"

namespace mgdt {
namespace {

// Whether the boundary of a domain is kept. What flips and added points do not recover is refused.
bool is_kept(MeshedDomain& domain) {
    domain.settings().keeps_boundary = true;
    const Error error = error_of([&] {
        domain.build();
        domain.check();
    });
    if (error.status != MGDT_OK) {
        EXPECT_EQ(error.status, MGDT_ERR_RESOLUTION) << error.message;
        return false;
    }
    const SolidMesh& m = domain.mesh();
    expect_equal_volumes(m);
    EXPECT_FALSE(m.is_rounded);
    EXPECT_TRUE(
        std::equal(domain.input().points.begin(), domain.input().points.end(), m.points.begin()));
    for (const std::uint32_t end : m.steiner_edges) EXPECT_EQ(end, no_index);
    return true;
}

TEST(KeptBoundary, KeepsAllTestSurfaces) {
    for (const Surface& s : test_surfaces()) {
        SCOPED_TRACE(s.name);
        MeshedDomain domain;
        give(domain, s);
        // Facets that hundreds of edges cross are not recovered.
        const bool is_hard = s.name == "city on a large square" || s.name == "square in a cloud";
        EXPECT_EQ(is_kept(domain), !is_hard);
        if (is_hard) continue;
        const SolidMesh& m = domain.mesh();
        EXPECT_GT(m.tetrahedron_count(), 0u);
        if (s.regions > 0) {
            EXPECT_EQ(m.region_markers.size(), s.regions);
        }
        if (s.volume >= 0) {
            EXPECT_NEAR(volume(m), s.volume, 1e-9 * s.volume);
        }
    }
}

// The size of the set is less than the distance from the largest coordinate to the next double.
TEST(KeptBoundary, OfATriangleFarAwayIsRefused) {
    MeshedDomain domain;
    Surface s("far triangle");
    s.point(1e-299, -1e-214, 1e-75);
    s.point(2e-299, -1e-214, 1e-75);
    s.point(1e-299, std::nextafter(-1e-214, 0), 1e-75);
    s.facet({0, 1, 2});
    give(domain, s);
    for (const bool keeps : {false, true}) {
        domain.settings().keeps_boundary = keeps;
        EXPECT_EQ(error_of([&] { domain.build(); }).status, MGDT_ERR_OPEN_BOUNDARY);
    }
}

TEST(KeptBoundary, KeepsRandomComplexes) {
    int kept = 0;
    for (unsigned seed = 0; seed < 150; ++seed) {
        SCOPED_TRACE(seed);
        MeshedDomain domain;
        give_random_complex(domain, seed);
        kept += is_kept(domain);
    }
    EXPECT_EQ(kept, 150);
}

// The tetrahedra of a mesh by the coordinates of their corners, sorted.
std::vector<std::array<std::array<double, 3>, 4>> places_of(const SolidMesh& m) {
    std::vector<std::array<std::array<double, 3>, 4>> all(m.tetrahedron_count());
    for (std::size_t i = 0; i < m.tetrahedra.size(); ++i)
        std::copy_n(m.points.begin() + 3 * std::size_t{m.tetrahedra[i]}, 3,
                    all[i / 4][i % 4].begin());
    for (auto& t : all) std::sort(t.begin(), t.end());
    std::sort(all.begin(), all.end());
    return all;
}

TEST(KeptBoundary, DoesNotDependOnTheOrderOfPointsAndFacetsOrOnThreads) {
    Surface s = chazelle(3);
    MeshedDomain domain, other;
    give(domain, s);
    ASSERT_TRUE(is_kept(domain));
    EXPECT_GT(domain.mesh().steiner_parameters.size(), 0u);
    // Points and facets in the opposite order.
    const auto n = static_cast<std::uint32_t>(s.points.size() / 3);
    for (std::uint32_t v = 0; v < n / 2; ++v)
        std::swap_ranges(s.points.begin() + 3 * v, s.points.begin() + 3 * v + 3,
                         s.points.begin() + 3 * (n - 1 - v));
    for (auto& facet : s.facets)
        for (std::uint32_t& v : facet) v = n - 1 - v;
    std::reverse(s.facets.begin(), s.facets.end());
    std::reverse(s.markers.begin(), s.markers.end());
    give(other, s);
    other.settings().threads = 3;
    ASSERT_TRUE(is_kept(other));
    EXPECT_EQ(places_of(domain.mesh()), places_of(other.mesh()));
}

// Corners on one sphere need no points where flips suffice. Not all choices of diagonals of a cube
// have a mesh without points.
TEST(KeptBoundary, AddsFewPoints) {
    const auto points_of = [](std::vector<std::vector<std::uint32_t>> facets) {
        Surface s = cube();
        s.facets = std::move(facets);
        s.markers.resize(s.facets.size());
        std::iota(s.markers.begin(), s.markers.end(), 0);
        MeshedDomain domain;
        give(domain, s);
        EXPECT_TRUE(is_kept(domain));
        return domain.mesh().steiner_parameters.size();
    };
    EXPECT_EQ(points_of({{0, 2, 3},
                         {0, 3, 1},
                         {4, 5, 7},
                         {4, 7, 6},
                         {0, 1, 5},
                         {0, 5, 4},
                         {2, 6, 7},
                         {2, 7, 3},
                         {0, 4, 6},
                         {0, 6, 2},
                         {1, 3, 7},
                         {1, 7, 5}}),
              0u);
    EXPECT_EQ(points_of({{0, 5, 1},
                         {0, 4, 5},
                         {4, 7, 5},
                         {4, 6, 7},
                         {6, 3, 7},
                         {6, 2, 3},
                         {2, 1, 3},
                         {2, 0, 1},
                         {1, 7, 3},
                         {1, 5, 7},
                         {2, 4, 0},
                         {2, 6, 4}}),
              1u);
}

// A prism whose caps have their corners on circles, so that all triangulations of a cap are
// Delaunay. `shift` turns the fan of one cap, and a wall between the caps has a third one.
Surface prism_with_fans(std::uint32_t sides, std::uint32_t shift, bool has_wall, double tilt) {
    Surface s("prism with fans");
    const std::uint32_t levels = has_wall ? 3 : 2;
    for (std::uint32_t level = 0; level < levels; ++level)
        for (std::uint32_t i = 0; i < sides; ++i) {
            const double angle = 2 * 3.14159265358979323846 * i / sides, z = 0.5 * level;
            s.point(std::cos(angle), std::sin(angle) - tilt * z, z + tilt * std::sin(angle));
        }
    const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
        s.facets.push_back({a, b, c});
        s.markers.push_back(static_cast<std::int32_t>(s.facets.size()));
    };
    for (std::uint32_t level = 0; level < levels; ++level)
        for (std::uint32_t i = 1; i + 1 < sides; ++i) {
            const std::uint32_t from = level * shift, first = level * sides;
            add(first + from % sides, first + (from + i) % sides, first + (from + i + 1) % sides);
        }
    for (std::uint32_t level = 0; level + 1 < levels; ++level)
        for (std::uint32_t i = 0; i < sides; ++i) {
            const std::uint32_t a = level * sides + i, b = level * sides + (i + 1) % sides;
            add(a, b, a + sides);
            add(b, b + sides, a + sides);
        }
    return s;
}

TEST(KeptBoundary, TurnsFansInAPlane) {
    for (const std::uint32_t sides : {32u, 101u, 240u})
        for (const bool has_wall : {false, true})
            for (const double tilt : {0.0, 0.25, 0.3}) {
                SCOPED_TRACE(std::to_string(sides) + (has_wall ? ", wall, " : ", ") +
                             std::to_string(tilt));
                MeshedDomain domain;
                give(domain, prism_with_fans(sides, sides / 3, has_wall, tilt));
                EXPECT_TRUE(is_kept(domain));
                EXPECT_LE(domain.mesh().steiner_parameters.size(), 8u);
            }
}

TEST(KeptBoundary, TurnsFansOfAllSizes) {
    for (const double scale : {1.0, 0x1p-300, 0x1p300}) {
        SCOPED_TRACE(scale);
        Surface s = prism_with_fans(60, 20, true, 0.3);
        for (double& x : s.points) x *= scale;
        MeshedDomain domain;
        give(domain, s);
        EXPECT_TRUE(is_kept(domain));
        EXPECT_LE(domain.mesh().steiner_parameters.size(), 4u);
    }
}

// The four points around the middle of a double pyramid are on a circle.
TEST(KeptBoundary, SaysWhetherTheMeshIsDelaunay) {
    for (const double height : {0.5, 1.5}) {
        Surface s("double pyramid");
        for (const double sign : {1.0, -1.0}) {
            s.point(sign, 0, 0);
            s.point(0, sign, 0);
            s.point(0, 0, sign * height);
        }
        for (const std::uint32_t x : {0u, 3u})
            for (const std::uint32_t y : {1u, 4u})
                for (const std::uint32_t z : {2u, 5u}) s.facet({x, y, z});
        MeshedDomain domain;
        give(domain, s);
        ASSERT_TRUE(is_kept(domain));
        EXPECT_TRUE(domain.mesh().is_delaunay);
    }
    MeshedDomain turned;
    give(turned, prism_with_fans(32, 10, false, 0.3));
    ASSERT_TRUE(is_kept(turned));
    EXPECT_FALSE(turned.mesh().is_delaunay);
}

// Details far below the grid to which other meshes are rounded.
TEST(KeptBoundary, MeshesThinSheets) {
    for (const double thickness : {1e-7, 1e-13, 1e-30}) {
        SCOPED_TRACE(thickness);
        Surface s("sheet");
        add_box(s, {0, 0, 0}, {1, 1, thickness});
        s.point(0.25, 0.5, thickness / 3);
        MeshedDomain domain;
        give(domain, s);
        EXPECT_TRUE(is_kept(domain));
        EXPECT_LE(domain.mesh().steiner_parameters.size(), 1u);
        domain.settings().keeps_boundary = false;
        domain.build();
        domain.check();
    }
}

TEST(KeptBoundary, RefusesCoordinatesWithoutRoomAroundThem) {
    Surface s = cube();
    for (double& x : s.points) x = x * 1.6e308 - 0.8e308;
    MeshedDomain domain;
    give(domain, s);
    EXPECT_FALSE(is_kept(domain));
}

}  // namespace
}  // namespace mgdt
