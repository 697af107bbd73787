// SPDX-License-Identifier: MIT
// Domains whose facets are repeated, collapsed, or divided on one side only, before and after they
// are cleaned.
#include "cleaning/cleaning.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>

#include "cleaning/incidences.hpp"
#include "mesh_volumes.hpp"
#include "predicates/predicates.hpp"
#include "random_complexes.hpp"

namespace mgdt {
namespace {

// Cleans a domain, and makes and checks its mesh.
void clean_and_build(MeshedDomain& domain, double weld = 0, double flatness = 0) {
    domain.settings().weld = weld;
    domain.settings().flatness = flatness;
    domain.clean();
    for (const bool keeps : {false, true}) {
        domain.settings().keeps_boundary = keeps;
        const Error error = error_of([&] {
            domain.build();
            domain.check();
        });
        ASSERT_EQ(error.status, MGDT_OK) << error.message;
        expect_equal_volumes(domain.mesh());
    }
}

void expect_invalid(const MeshedDomain& domain) {
    EXPECT_FALSE(is_valid(domain.input()));
}

// How many faces of the mesh have a marker.
std::size_t faces_with(const SolidMesh& mesh, std::int32_t marker) {
    return static_cast<std::size_t>(
        std::count(mesh.face_markers.begin(), mesh.face_markers.end(), marker));
}

TEST(Cleaning, LeavesCleanSurfacesAsTheyAre) {
    for (const Surface& s : test_surfaces()) {
        SCOPED_TRACE(s.name);
        MeshedDomain domain, cleaned;
        give(domain, s);
        give(cleaned, s);
        cleaned.clean();
        const DomainInput &a = domain.input(), &b = cleaned.input();
        EXPECT_TRUE(std::equal(a.points.begin(), a.points.end(), b.points.begin(), b.points.end()));
        EXPECT_TRUE(
            std::equal(a.corners.begin(), a.corners.end(), b.corners.begin(), b.corners.end()));
        EXPECT_TRUE(std::equal(a.facet_begin.begin(), a.facet_begin.end(), b.facet_begin.begin(),
                               b.facet_begin.end()));
        EXPECT_TRUE(
            std::equal(a.segments.begin(), a.segments.end(), b.segments.begin(), b.segments.end()));
        EXPECT_TRUE(std::equal(a.facet_markers.begin(), a.facet_markers.end(),
                               b.facet_markers.begin(), b.facet_markers.end()));
        for (std::uint32_t f = 0; f < a.facet_count(); ++f) EXPECT_EQ(b.facet_origin(f), f);
        EXPECT_TRUE(cleaned.cleaned().covered.empty());
    }
}

// A cube, a point in the middle of an edge of which only two of the three facets at it know.
Surface cube_with_hanging_point() {
    Surface s = cube();
    const std::uint32_t middle = s.point(0.5, 0, 0);
    s.facets[0] = {0, 2, 3, 1, middle};
    return s;
}

TEST(Cleaning, DividesEdgesAtPointsOfOtherFacets) {
    MeshedDomain domain;
    give(domain, cube_with_hanging_point());
    expect_invalid(domain);
    clean_and_build(domain);
    EXPECT_NEAR(volume(domain.mesh()), 1, 1e-12);
    EXPECT_EQ(domain.cleaned().counts.points_in_edges, 1u);
    EXPECT_EQ(domain.cleaned().counts.points_in_facets, 0u);
    EXPECT_TRUE(domain.mesh().steiner_parameters.empty());
}

// The triangles of a surface, each with points of its own that are moved at random.
Surface torn(const Surface& of, double distance, unsigned seed) {
    Surface s("torn " + of.name);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> moved(-distance, distance);
    for (std::size_t f = 0; f < of.facets.size(); ++f) {
        std::vector<std::uint32_t> corners;
        for (const std::uint32_t v : of.facets[f]) {
            const double* const x = of.points.data() + 3 * std::size_t{v};
            corners.push_back(
                s.point(x[0] + moved(random), x[1] + moved(random), x[2] + moved(random)));
        }
        s.facet(corners, of.markers[f]);
    }
    return s;
}

TEST(Cleaning, WeldsPoints) {
    for (const Surface& of : {cube(), torus(20, 10), chazelle(4), nested_shells(3, false)}) {
        SCOPED_TRACE(of.name);
        MeshedDomain whole, domain;
        give(whole, of);
        whole.build();
        give(domain, torn(of, 1e-10, 5));
        EXPECT_NE(error_of([&] { domain.build(); }).status, MGDT_OK);
        clean_and_build(domain, 1e-9);
        EXPECT_NEAR(volume(domain.mesh()), volume(whole.mesh()), 1e-7 * volume(whole.mesh()));
        EXPECT_GT(domain.cleaned().counts.moved_points, 0u);
    }
}

TEST(Cleaning, MovesPointsByAtMostTheDistance) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> anywhere(0, 1);
    for (const double share : {1e-3, 1e-2, 5e-2}) {
        MeshedDomain domain;
        Buffer<double> points(domain.allocator());
        for (int i = 0; i < 3000; ++i) points.push_back(i % 3 == 2 ? 0 : anywhere(random));
        std::vector<double> before(points.begin(), points.end());
        domain.set_points(std::move(points));
        domain.settings().weld = share;
        const double distance = Nearness(share, domain.input().points).distance();
        EXPECT_NEAR(distance, share * std::sqrt(2), 1e-2 * share);
        domain.clean();
        const Buffer<double>& after = domain.input().points;
        std::size_t moved = 0;
        const auto apart = [&](const double* p, const double* q) {
            return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
        };
        for (std::size_t i = 0; i < before.size(); i += 3) {
            const double by = apart(before.data() + i, after.begin() + i);
            EXPECT_LE(by, distance * (1 + 1e-12));
            if (by > 0) ++moved;
            for (std::size_t k = 0; k < i; k += 3) {
                const double between = apart(after.begin() + k, after.begin() + i);
                EXPECT_TRUE(between == 0 || between > distance * (1 - 1e-12)) << between;
            }
        }
        EXPECT_EQ(domain.cleaned().counts.moved_points, moved);
        EXPECT_GT(moved, 0u);
        domain.clean();
        EXPECT_EQ(domain.cleaned().counts.moved_points, 0u);
    }
}

TEST(Cleaning, DropsRepeatedCornersAndCollapsedFacets) {
    Surface s = cube();
    s.facets[1] = {4, 5, 5, 7, 6, 4};
    s.facet({0, 1, 0});
    s.facet({2, 2, 2, 2});
    s.facet({0, 0, 1, 1});
    MeshedDomain domain;
    give(domain, s);
    expect_invalid(domain);
    clean_and_build(domain);
    EXPECT_EQ(domain.input().facet_count(), 6u);
    EXPECT_EQ(domain.cleaned().counts.collapsed_facets, 3u);
    EXPECT_EQ(domain.cleaned().counts.repeated_corners, 2u);
    EXPECT_EQ(domain.input().corners.size(), 24u);
}

TEST(Cleaning, ReplacesAFlatTriangleBetweenEdges) {
    // The flat triangle connects an edge with its two halves.
    Surface s = cube_with_hanging_point();
    s.facet({0, 8, 1});
    MeshedDomain domain;
    give(domain, s);
    expect_invalid(domain);
    clean_and_build(domain);
    EXPECT_EQ(domain.cleaned().counts.collapsed_facets, 1u);
    EXPECT_NEAR(volume(domain.mesh()), 1, 1e-12);
}

TEST(Cleaning, TakesAWallBetweenTwoSolidsOnce) {
    Surface s("two cubes");
    add_box(s, {0, 0, 0}, {1, 1, 1});
    add_box(s, {1, 0, 0}, {2, 1, 1});
    for (std::size_t f = 0; f < s.markers.size(); ++f) s.markers[f] = static_cast<std::int32_t>(f);
    MeshedDomain domain;
    give(domain, s);
    expect_invalid(domain);
    clean_and_build(domain);
    EXPECT_EQ(domain.input().facet_count(), 11u);
    const SolidMesh& m = domain.mesh();
    EXPECT_EQ(m.region_markers.size(), 2u);
    EXPECT_NEAR(volume(m), 2, 1e-12);
    ASSERT_EQ(domain.cleaned().covered.size(), 1u);
    EXPECT_EQ(domain.cleaned().covered[0].facet, 10u);
    EXPECT_EQ(domain.cleaned().covered[0].by, 5u);
    EXPECT_EQ(faces_with(m, 5), 2u);
    EXPECT_EQ(faces_with(m, 10), 0u);
}

// A cube with a patch in its top, which is a square of two triangles.
Surface cube_with_patch(const std::vector<std::array<double, 2>>& patch) {
    Surface s = cube();
    s.facets[1] = {4, 5, 7};
    s.facet({4, 7, 6});
    std::vector<std::uint32_t> corners;
    for (const auto& p : patch) corners.push_back(s.point(p[0], p[1], 1));
    s.facet(corners, 7);
    return s;
}

TEST(Cleaning, PutsPatchesIntoFacets) {
    const std::vector<std::vector<std::array<double, 2>>> patches = {
        {{0.25, 0.5}, {0.5, 0.25}, {0.75, 0.5}, {0.5, 0.75}},  // across the diagonal
        {{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.75}, {0.25, 0.75}},
        {{0.5, 0.125}, {0.75, 0.125}, {0.75, 0.25}},
        {{0, 0}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}},
        {{1, 0}, {1, 1}, {0, 1}},  // the other diagonal
        {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
        {{0.25, 0.25}, {0.75, 0.25}, {0.75, 0.375}, {0.375, 0.375}, {0.375, 0.75}, {0.25, 0.75}}};
    for (std::size_t i = 0; i < patches.size(); ++i) {
        SCOPED_TRACE(i);
        MeshedDomain domain;
        give(domain, cube_with_patch(patches[i]));
        expect_invalid(domain);
        clean_and_build(domain);
        const SolidMesh& m = domain.mesh();
        EXPECT_NEAR(volume(m), 1, 1e-12);
        double area = 0, expected = 0;
        for (std::size_t f = 0; f < m.face_markers.size(); ++f) {
            if (m.face_markers[f] != 7) continue;
            const auto x = [&](std::size_t k) {
                return m.points.begin() + 3 * std::size_t{m.faces[3 * f + k]};
            };
            EXPECT_EQ(x(0)[2], 1);
            area += std::abs((x(1)[0] - x(0)[0]) * (x(2)[1] - x(0)[1]) -
                             (x(1)[1] - x(0)[1]) * (x(2)[0] - x(0)[0]));
        }
        const auto& p = patches[i];
        for (std::size_t k = 0; k < p.size(); ++k) {
            const auto& q = p[(k + 1) % p.size()];
            expected += p[k][0] * q[1] - p[k][1] * q[0];
        }
        // Of facets that are equally large, or of a larger one, the others stay.
        if (i != 4 && i != 5) {
            EXPECT_NEAR(area, expected, 1e-12);
        }
        EXPECT_FALSE(domain.cleaned().covered.empty());
    }
}

TEST(Cleaning, PutsPointsAndSegmentsIntoFacets) {
    Surface s = cube();
    s.point(0.25, 0.125, 1);
    const std::uint32_t a = s.point(0.375, 0.875, 1), b = s.point(0.625, 0.25, 1);
    s.segments = {a, b, 4, 7, 5, 6};  // the second and the third cross each other
    s.segments.resize(4);
    MeshedDomain domain;
    give(domain, s);
    expect_invalid(domain);
    domain.clean();
    // The diagonal crosses the other segment, so that it takes a new point.
    EXPECT_FALSE(is_valid(domain.input()));
    s.segments.resize(2);
    MeshedDomain other;
    give(other, s);
    clean_and_build(other);
    EXPECT_NEAR(volume(other.mesh()), 1, 1e-12);
    EXPECT_TRUE(other.mesh().unused_points.empty());
    EXPECT_EQ(std::count(other.mesh().edge_segments.begin(), other.mesh().edge_segments.end(), 0u),
              1);
    // The segment with its ends in the facet is one edge.
    EXPECT_EQ(other.cleaned().counts.points_in_facets, 3u);
}

TEST(Cleaning, JoinsSolidsThatTouchInParts) {
    Surface s("boxes on a box");
    add_box(s, {0, 0, 0}, {4, 4, 1});
    add_box(s, {1, 1, 1}, {2, 3, 2});
    add_box(s, {2, 1, 1}, {3, 2, 2});
    add_box(s, {0, 0, -1}, {4, 2, 0});
    MeshedDomain domain;
    give(domain, s);
    expect_invalid(domain);
    clean_and_build(domain);
    EXPECT_EQ(domain.mesh().region_markers.size(), 4u);
    EXPECT_NEAR(volume(domain.mesh()), 16 + 2 + 1 + 8, 1e-12);
}

TEST(Cleaning, JoinsTurnedSolidsWithinADistance) {
    Surface s("boxes on a box");
    add_box(s, {0, 0, 0}, {4, 4, 1});
    add_box(s, {1, 1, 1}, {2, 3, 2});
    add_box(s, {2, 1, 1}, {3, 2, 2});
    add_box(s, {0, 0, -1}, {4, 2, 0});
    rotate(s, 0.4, 1.1);
    MeshedDomain domain;
    give(domain, s);
    expect_invalid(domain);
    clean_and_build(domain, 1e-12);
    EXPECT_EQ(domain.mesh().region_markers.size(), 4u);
    EXPECT_NEAR(volume(domain.mesh()), 16 + 2 + 1 + 8, 1e-9);
}

TEST(Cleaning, ChangesNothingTheSecondTime) {
    for (unsigned kind = 0; kind < 3; ++kind) {
        MeshedDomain domain;
        give(domain, kind == 0   ? cube_with_hanging_point()
                     : kind == 1 ? torn(torus(20, 10), 1e-9, 7)
                                 : cube_with_patch({{0.25, 0.5}, {0.5, 0.25}, {0.75, 0.5}}));
        domain.settings().weld = 1e-8;
        domain.settings().flatness = kind == 1 ? 1e-8 : 0.0;
        domain.clean();
        const std::vector<std::uint32_t> corners(domain.input().corners.begin(),
                                                 domain.input().corners.end());
        const std::vector<std::uint32_t> origins(domain.input().facet_origins.begin(),
                                                 domain.input().facet_origins.end());
        domain.clean();
        EXPECT_TRUE(std::equal(corners.begin(), corners.end(), domain.input().corners.begin(),
                               domain.input().corners.end()));
        EXPECT_TRUE(std::equal(origins.begin(), origins.end(), domain.input().facet_origins.begin(),
                               domain.input().facet_origins.end()));
        EXPECT_EQ(domain.cleaned().counts.points_in_edges, 0u);
    }
}

// Random triangles and segments on a small lattice, which cross and touch in all ways.
void give_soup(MeshedDomain& domain, unsigned seed) {
    std::mt19937 random(seed);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    const int n = 2 + below(4), points = 4 + below(20), facets = 1 + below(20),
              height = below(3) == 0 ? 1 : 2;
    domain.settings().takes_open_surfaces = true;
    DomainInput& input = domain.input();
    for (int i = 0; i < 3 * points; ++i) input.points.push_back(below(i % 3 == 2 ? height : n));
    input.facet_begin.push_back(0);
    const auto corner = [&] { return static_cast<std::uint32_t>(below(points)); };
    for (int f = 0; f < facets; ++f) {
        if (below(5) == 0) {
            for (int k = 0; k < 2; ++k) input.segments.push_back(corner());
            input.segment_markers.push_back(0);
            continue;
        }
        for (int k = 0; k < 3; ++k) input.corners.push_back(corner());
        input.facet_begin.push_back(static_cast<std::uint32_t>(input.corners.size()));
        input.facet_markers.push_back(below(2));
    }
}

// Whether a place is in a triangle of a complex, but for rounding.
bool is_covered(const Complex& complex, const Vector<double>& place) {
    const Buffer<std::uint32_t>& v = complex.boundary.triangles;
    for (std::size_t t = 0; t < v.size(); t += 3) {
        const auto x = [&](std::size_t k) {
            const double* const p = complex.boundary.points.begin() + 3 * std::size_t{v[t + k % 3]};
            return Vector<double>{{p[0], p[1], p[2]}};
        };
        const Vector<double> normal = cross(x(1) - x(0), x(2) - x(0));
        if (length(normal) == 0 || std::abs(dot(normal, place - x(0))) > 1e-9) continue;
        bool is_inside = true;
        for (std::size_t k = 0; k < 3; ++k)
            if (dot(cross(x(k + 1) - x(k), place - x(k)), normal) < -1e-9) is_inside = false;
        if (is_inside) return true;
    }
    return false;
}

// All triangles of one complex are covered by those of another, as far as random places show.
void expect_covered(const Complex& complex, const Complex& by, std::mt19937& random) {
    std::uniform_real_distribution<double> anywhere(0.01, 1);
    const Buffer<std::uint32_t>& v = complex.boundary.triangles;
    for (std::size_t t = 0; t < v.size(); t += 3)
        for (int i = 0; i < 5; ++i) {
            const double w[3] = {anywhere(random), anywhere(random), anywhere(random)};
            Vector<double> place = {{0, 0, 0}};
            for (std::size_t k = 0; k < 3; ++k) {
                const double* const p = complex.boundary.points.begin() + 3 * std::size_t{v[t + k]};
                place = place + w[k] / (w[0] + w[1] + w[2]) * Vector<double>{{p[0], p[1], p[2]}};
            }
            const auto x = [&](std::size_t k) {
                return complex.boundary.points.begin() + 3 * std::size_t{v[t + k]};
            };
            if (collinear(x(0), x(1), x(2))) continue;
            ASSERT_TRUE(is_covered(by, place)) << "triangle " << t / 3;
        }
}

TEST(Cleaning, LeavesInSoupsOnlyWhatNeedsNewPoints) {
    std::size_t became_valid = 0;
    for (unsigned seed = 0; seed < 2000; ++seed) {
        SCOPED_TRACE(seed);
        MeshedDomain domain;
        give_soup(domain, seed);
        const Complex before = make_complex(domain.input(), domain.allocator());
        const bool was_valid = is_valid(domain.input());
        domain.clean();
        const Complex after = make_complex(domain.input(), domain.allocator());
        EXPECT_TRUE(after.bad_facets.empty());
        std::mt19937 random(seed);
        expect_covered(before, after, random);
        expect_covered(after, before, random);
        // No point is in an edge or a triangle of which it is no corner; no two triangles are
        // equal.
        Team team;
        const Buffer<OffendingPair> pairs =
            offending_pairs(after.boundary, team, domain.allocator(), Unwatched());
        for (const OffendingPair& pair : pairs) {
            EXPECT_NE(pair.first, pair.second);
            Simplex a = after.boundary.simplex(pair.first), b = after.boundary.simplex(pair.second);
            EXPECT_FALSE(a.size == 3 && b.size == 3 &&
                         std::is_permutation(a.number, a.number + 3, b.number));
        }
        SurfacePieces pieces(domain.allocator());
        pieces.boundary.points.copy(after.boundary.points);
        pieces.boundary.triangles.copy(after.boundary.triangles);
        pieces.boundary.segments.copy(after.boundary.segments);
        pieces.boundary.lone_points.copy(after.boundary.lone_points);
        Unwatched unwatched;
        StageProgress& progress = unwatched;
        EXPECT_TRUE(find_incidences(pieces, Nearness(0, domain.input().points), team,
                                    domain.allocator(), progress)
                        .empty());
        if (pairs.empty() && !was_valid) ++became_valid;
        const std::vector<std::uint32_t> corners(domain.input().corners.begin(),
                                                 domain.input().corners.end());
        domain.clean();
        EXPECT_TRUE(std::equal(corners.begin(), corners.end(), domain.input().corners.begin(),
                               domain.input().corners.end()));
        if (HasFailure()) return;
    }
    EXPECT_GT(became_valid, 400u);
}

TEST(Cleaning, DoesNotDependOnThreads) {
    for (unsigned seed = 0; seed < 30; ++seed) {
        MeshedDomain one, many;
        give_soup(one, seed);
        give_soup(many, seed);
        many.settings().threads = 4;
        one.clean();
        many.clean();
        EXPECT_TRUE(std::equal(one.input().corners.begin(), one.input().corners.end(),
                               many.input().corners.begin(), many.input().corners.end()));
    }
}

// A cube of n x n squares on each side, in single precision, turned.
TEST(Cleaning, MakesNearlyFlatFacetsOnePatch) {
    Surface s("plate of needles");
    // Two fans from a corner of a plate to points on its far edges, on both sides.
    const int n = 60;
    std::vector<std::uint32_t> ring[2];
    for (int side = 0; side < 2; ++side) {
        ring[side].push_back(s.point(0, 0, side * 0.1));
        for (int i = 0; i <= n; ++i) ring[side].push_back(s.point(1, i / double(n), side * 0.1));
        ring[side].push_back(s.point(0, 1, side * 0.1));
    }
    rotate(s, 0.5, 0.8);
    for (double& x : s.points) x = static_cast<float>(x);
    for (int side = 0; side < 2; ++side)
        for (std::size_t i = 1; i + 1 < ring[side].size(); ++i)
            s.facet({ring[side][0], ring[side][i + (side == 1 ? 0 : 1)],
                     ring[side][i + (side == 1 ? 1 : 0)]});
    for (std::size_t i = 0; i < ring[0].size(); ++i) {
        const std::size_t next = (i + 1) % ring[0].size();
        s.facet({ring[0][i], ring[0][next], ring[1][next]});
        s.facet({ring[0][i], ring[1][next], ring[1][i]});
    }
    MeshedDomain plain, flat;
    give(plain, s);
    give(flat, s);
    plain.build();
    clean_and_build(flat, 0, 1e-6);
    EXPECT_GT(flat.cleaned().counts.exchanged_edges, 0u);
    EXPECT_EQ(flat.input().facet_count(), plain.input().facet_count());
    EXPECT_NEAR(volume(flat.mesh()), volume(plain.mesh()), 1e-6);
    flat.settings().keeps_boundary = false;
    flat.build();
    EXPECT_EQ(flat.mesh().steiner_parameters.size(), 0u);
    EXPECT_TRUE(flat.mesh().is_delaunay);
    EXPECT_FALSE(plain.mesh().is_delaunay);
}

}  // namespace
}  // namespace mgdt
