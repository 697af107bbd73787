// SPDX-License-Identifier: MIT
// Meshes of domains: valid ones are meshed, checked and measured in rationals; invalid ones are
// refused with all pairs.
#include "domain/domain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <map>

#include "boundary/polygon.hpp"
#include "mesh_volumes.hpp"
#include "random_complexes.hpp"
#include "solid/mesh_check.hpp"
#include "surfaces.hpp"
#include "unwatched.hpp"

namespace mgdt {
namespace {

TEST(Domain, MeshesAllTestSurfaces) {
    for (const Surface& s : test_surfaces()) {
        SCOPED_TRACE(s.name);
        MeshedDomain domain;
        give(domain, s);
        try {
            domain.build();
            domain.check();
        } catch (const Error& e) {
            ADD_FAILURE() << e.message;
            continue;
        }
        const SolidMesh& m = domain.mesh();
        EXPECT_GT(m.tetrahedron_count(), 0u);
        expect_equal_volumes(m);
        if (s.regions > 0) {
            EXPECT_EQ(m.region_markers.size(), s.regions);
        }
        if (s.volume >= 0) {
            EXPECT_NEAR(volume(m), s.volume, 1e-9 * s.volume);
        }
    }
}

TEST(Domain, MeshesRandomComplexes) {
    for (unsigned seed = 0; seed < 150; ++seed) {
        SCOPED_TRACE(seed);
        MeshedDomain domain;
        give_random_complex(domain, seed);
        const Error error = error_of([&] {
            domain.build();
            domain.check();
        });
        EXPECT_EQ(error.status, MGDT_OK) << error.message;
        expect_equal_volumes(domain.mesh());
    }
}

TEST(Domain, DoesNotDependOnTheOrderOfItsFacets) {
    Surface s = chazelle(3);
    MeshedDomain domain, other;
    give(domain, s);
    std::reverse(s.facets.begin(), s.facets.end());
    give(other, s);
    domain.build();
    other.build();
    const auto list = [](const Buffer<std::uint32_t>& of) {
        return std::vector<std::uint32_t>(of.begin(), of.end());
    };
    EXPECT_EQ(list(domain.mesh().tetrahedra), list(other.mesh().tetrahedra));
    EXPECT_GT(domain.mesh().steiner_parameters.size(), 0u);
}

TEST(Domain, NamesAllThatCrosses) {
    Surface s = cube();
    const std::uint32_t a = s.point(0.5, 0.25, 0.5), b = s.point(0.5, 0.3, 2),
                        c = s.point(0.4, 0.7, 0.5);
    s.facet({a, b, c});
    s.facet({0, 1, 0});
    s.segments = {a, s.point(3, 0.25, 0.5)};
    s.point(1, 0.4, 0.8);
    MeshedDomain domain;
    give(domain, s);
    const Error error = error_of([&] { domain.build(); });
    EXPECT_EQ(error.status, MGDT_ERR_INVALID_BOUNDARY);
    EXPECT_STREQ(error.message,
                 "facet 1 and facet 6 meet elsewhere than in common corners or edges; 4 pairs in "
                 "all offend");
    const auto has = [&](Offence::Item x, Offence::Item y) {
        return std::count(domain.offences().begin(), domain.offences().end(), Offence{x, y});
    };
    EXPECT_EQ(domain.offences().size(), 4u);
    EXPECT_TRUE(has({Offence::facet, 1}, {Offence::facet, 6}));
    EXPECT_TRUE(has({Offence::facet, 7}, {Offence::facet, 7}));
    EXPECT_TRUE(has({Offence::facet, 5}, {Offence::segment, 0}));
    EXPECT_TRUE(has({Offence::facet, 5}, {Offence::point, 12}));
    EXPECT_EQ(domain.mesh().tetrahedron_count(), 0u);
}

TEST(Domain, RefusesWhatTheGridCannotHold) {
    Surface s = cube();
    s.point(0.5, 0.5, 0.5);
    s.point(0.5 + 1e-15, 0.5, 0.5);
    MeshedDomain domain;
    give(domain, s);
    domain.settings().rounds_points = true;
    EXPECT_EQ(error_of([&] { domain.build(); }).status, MGDT_ERR_RESOLUTION);
    // Without rounding no grid is needed.
    domain.settings().rounds_points = false;
    domain.build();
    domain.check();
    EXPECT_EQ(domain.mesh().grid.bits(), RoundingGrid::no_rounding);
}

// Finer details than 2^-36 of the largest coordinate, and a segment whose parts beside a point are
// too short for the points that it has on the usual grid.
TEST(Domain, ChoosesAFinerOrACoarserGrid) {
    const auto bits_of = [](const Surface& s, bool rounds = false) {
        MeshedDomain domain;
        give(domain, s);
        domain.settings().rounds_points = rounds;
        std::vector<double> heard;
        domain.settings().progress_user = &heard;
        domain.settings().progress = [](double fraction, void* user) {
            static_cast<std::vector<double>*>(user)->push_back(fraction);
            return std::int32_t{0};
        };
        domain.build();
        domain.check();
        EXPECT_TRUE(std::is_sorted(heard.begin(), heard.end()));
        EXPECT_EQ(heard.back(), 1);
        EXPECT_EQ(domain.mesh().is_rounded, rounds);
        for (std::size_t i = 0; i < s.points.size() && !rounds; ++i)
            EXPECT_EQ(domain.mesh().points[i], s.points[i]);
        return domain.mesh().grid.bits();
    };
    EXPECT_EQ(bits_of(cube()), 36);
    Surface fine = cube();
    fine.point(0.3, 0.2, 0.1);
    fine.point(0.3 + 1e-12, 0.2, 0.1);
    EXPECT_EQ(bits_of(fine), 44);
    {
        // Places are in regions and holes on that grid as well.
        MeshedDomain domain;
        give(domain, fine);
        domain.input().regions.push_back({{0.5, 0.5, 0.5}, 7});
        domain.build();
        domain.check();
        ASSERT_EQ(domain.mesh().region_markers.size(), 1u);
        EXPECT_EQ(domain.mesh().region_markers[0], 7);
        domain.input().holes.push_back({{0.9, 0.5, 0.5}, 0});
        try {
            domain.build();
            ADD_FAILURE() << "the hole leaves nothing";
        } catch (const Error& e) {
            EXPECT_EQ(e.status, MGDT_ERR_OPEN_BOUNDARY);
        }
    }
    for (const double distance : {1e-3, 1e-7, 3e-8}) {
        Surface s = cube();
        const double a[3] = {0.0512341, 0.1000317, 0.2003411}, b[3] = {0.9123127, 0.8001231, 0.7};
        s.segments.push_back(s.point(a[0], a[1], a[2]));
        s.segments.push_back(s.point(b[0], b[1], b[2]));
        // Points around a place of the segment.
        const double d[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
        const double across[4][3] = {
            {d[1], -d[0], 0}, {-d[1], d[0], 0}, {0, d[2], -d[1]}, {0, -d[2], d[1]}};
        for (int i = 0; i < 4; ++i) {
            const double t = 0.4321 + 0.3 * i * distance;
            const double* const n = across[i];
            s.point(a[0] + t * d[0] + distance * n[0], a[1] + t * d[1] + distance * n[1],
                    a[2] + t * d[2] + distance * n[2]);
        }
        const int bits = bits_of(s, true);
        EXPECT_TRUE(distance > 1e-4 ? bits == 36 : bits < 36) << distance << ": " << bits;
        bits_of(s);
    }
}

TEST(Domain, OfPointsInAPlaneIsEmpty) {
    Surface s("square");
    for (int i = 0; i < 4; ++i) s.point(i / 2, i % 2, 0);
    s.facet({0, 1, 3, 2});
    MeshedDomain domain;
    give(domain, s);
    domain.settings().takes_open_surfaces = true;
    domain.build();
    domain.check();
    EXPECT_EQ(domain.mesh().tetrahedron_count(), 0u);
    MeshedDomain nothing;
    nothing.settings().takes_open_surfaces = true;
    nothing.build();
    nothing.check();
}

TEST(Domain, SaysWhereASurfaceIsOpen) {
    const auto expect_open = [](const Surface& s, std::size_t edges, const char* words) {
        MeshedDomain domain;
        give(domain, s);
        const Error error = error_of([&] { domain.build(); });
        EXPECT_EQ(error.status, MGDT_ERR_OPEN_BOUNDARY) << s.name;
        EXPECT_NE(std::string(error.message).find(words), std::string::npos) << error.message;
        EXPECT_EQ(domain.open_edges().size(), edges) << s.name;
        domain.validate();
        EXPECT_EQ(domain.open_edges().size(), edges) << s.name;
    };
    expect_open(Surface("nothing"), 0, "no facets");
    Surface s = cube();
    s.facets.pop_back();
    s.markers.pop_back();
    expect_open(s, 4, "4 such edges");
    // A second surface that is open is left out; its edges are named.
    Surface both = cube();
    const auto first = static_cast<std::uint32_t>(both.points.size() / 3);
    for (const double x : {10.0, 11.0, 12.0}) both.point(x, x * x, 0);
    both.facet({first, first + 1, first + 2});
    MeshedDomain domain;
    give(domain, both);
    domain.build();
    domain.check();
    EXPECT_EQ(domain.mesh().tetrahedron_count(), 6u);
    ASSERT_EQ(domain.open_edges().size(), 3u);
    EXPECT_EQ(domain.open_edges()[1].facet, 6u);
    EXPECT_EQ(domain.open_edges()[1].ends[1], first + 2);
}

// Coordinates at the ends of the range of doubles.
TEST(Domain, MeshesLargeAndSmallCoordinates) {
    for (const double size : {1e300, 1e-300, 0x1p1023, 0x1p-1000, 0x1.fffffffffffffp1023, 1e-310}) {
        Surface s = schoenhardt(0.5);
        for (double& x : s.points) x *= size;
        MeshedDomain domain;
        give(domain, s);
        domain.build();
        domain.check();
        EXPECT_GT(domain.mesh().tetrahedron_count(), 0u);
    }
}

// The check finds every change of a single number of a mesh.
TEST(Domain, CheckFindsChanges) {
    MeshedDomain domain;
    Surface s = schoenhardt(0.5);
    s.markers[3] = 7;
    give(domain, s);
    domain.build();
    const auto expect_found = [&](auto& array, std::size_t i, auto value) {
        const auto before = array[i];
        if (before == value) return;
        array[i] = value;
        EXPECT_EQ(error_of([&] { domain.check(); }).status, MGDT_ERR_CHECK_FAILED) << i;
        array[i] = before;
    };
    SolidMesh& m = domain.mesh();
    for (Buffer<std::uint32_t>* const of :
         {&m.tetrahedra, &m.neighbors, &m.faces, &m.face_tetrahedra, &m.face_facets, &m.edges,
          &m.steiner_edges})
        for (std::size_t i = 0; i < of->size(); ++i) {
            expect_found(*of, i, (*of)[i] + 1);
            expect_found(*of, i, (*of)[i] == 0 ? 1u : 0u);
            expect_found(*of, i, no_index);
        }
    for (std::size_t i = 0; i < m.steiner_parameters.size(); ++i)
        expect_found(m.steiner_parameters, i, m.steiner_parameters[i] / 2);
    for (std::size_t i = 0; i < m.points.size(); ++i) expect_found(m.points, i, 1e9);
    for (std::size_t i = 0; i < m.exact_points.size(); ++i) expect_found(m.exact_points, i, 3.0);
    for (std::size_t i = 0; i < m.face_markers.size(); ++i) expect_found(m.face_markers, i, 3);
    domain.check();
}

// Meshes that every face and every tetrahedron by itself would pass.
TEST(Domain, CheckFindsWhatIsLeftOut) {
    const auto expect_found = [&](const MeshedDomain& domain, const char* message) {
        const Error error = error_of([&] { domain.check(); });
        EXPECT_EQ(error.status, MGDT_ERR_CHECK_FAILED);
        EXPECT_NE(std::string(error.message).find(message), std::string::npos) << error.message;
    };
    const auto append = [](auto& to, const auto& from, std::uint32_t add) {
        for (const auto of : from)
            to.push_back(of == no_index ? of : static_cast<std::uint32_t>(of) + add);
    };
    const double centre[3] = {0.5, 0.25, 0.125};
    {
        // A point inside.
        MeshedDomain domain;
        give(domain, cube());
        domain.build();
        SolidMesh& m = domain.mesh();
        for (const double x : centre) {
            domain.input().points.push_back(x);
            m.points.push_back(x);
            m.exact_points.push_back(m.grid.round(x));
        }
        m.point_origins.push_back(8);
        expect_found(domain, "meets the surroundings of the domain at point 8");
    }
    {
        // A segment inside, between opposite corners that no tetrahedron joins.
        MeshedDomain domain;
        give(domain, cube());
        domain.build();
        SolidMesh& m = domain.mesh();
        for (std::uint32_t a = 0; a < 4; ++a) {
            const std::uint32_t b = 7 - a;
            bool is_edge = false;
            for (std::size_t t = 0; t < m.tetrahedra.size(); t += 4) {
                const std::uint32_t* const v = m.tetrahedra.begin() + t;
                is_edge = is_edge || (std::count(v, v + 4, a) != 0 && std::count(v, v + 4, b) != 0);
            }
            if (is_edge) continue;
            for (const std::uint32_t end : {a, b}) {
                domain.input().segments.push_back(end);
                m.edges.push_back(end);
            }
            domain.input().segment_markers.push_back(0);
            m.edge_markers.push_back(0);
            m.edge_segments.push_back(0);
            expect_found(domain, "meets the surroundings");
            break;
        }
        EXPECT_EQ(domain.input().segment_count(), 1u);
    }
    {
        // The outer of two cubes is filled as if the inner one were not there.
        Surface both = nested_shells(2, false), outer("outer"), inner("inner");
        for (int k = 0; k < 2; ++k) {
            Surface& s = k == 0 ? outer : inner;
            s.points.assign(both.points.begin() + 24 * k, both.points.begin() + 24 * (k + 1));
            for (int f = 0; f < 6; ++f) {
                std::vector<std::uint32_t> corners =
                    both.facets[static_cast<std::size_t>(6 * k + f)];
                for (std::uint32_t& v : corners) v -= static_cast<std::uint32_t>(8 * k);
                s.facet(corners);
            }
        }
        // On one grid.
        for (const double x : {-2.5, -2.5, -2.5}) inner.points.push_back(x);
        outer.points.insert(outer.points.end(), {-2.5, -2.5, -2.5});
        both.points.insert(both.points.begin() + 24, {-2.5, -2.5, -2.5});
        both.points.insert(both.points.end(), {-2.5, -2.5, -2.5});
        for (std::size_t f = 6; f < 12; ++f)
            for (std::uint32_t& v : both.facets[f]) ++v;
        MeshedDomain domain, one, two;
        give(domain, both);
        give(one, outer);
        give(two, inner);
        domain.build();
        domain.check();
        one.build();
        two.build();
        SolidMesh& m = domain.mesh();
        for (Buffer<std::uint32_t>* const of :
             {&m.tetrahedra, &m.neighbors, &m.faces, &m.face_tetrahedra, &m.face_facets, &m.edges})
            of->clear();
        m.regions.clear();
        m.face_markers.clear();
        m.edge_segments.clear();
        m.edge_markers.clear();
        const auto tetrahedra = static_cast<std::uint32_t>(one.mesh().tetrahedron_count());
        for (const MeshedDomain* const d : {&one, &two}) {
            const SolidMesh& from = d->mesh();
            const bool is_second = d == &two;
            append(m.tetrahedra, from.tetrahedra, is_second ? 9 : 0);
            append(m.neighbors, from.neighbors, is_second ? tetrahedra : 0);
            append(m.regions, from.regions, is_second ? 1 : 0);
            append(m.faces, from.faces, is_second ? 9 : 0);
            append(m.face_tetrahedra, from.face_tetrahedra, is_second ? tetrahedra : 0);
            append(m.face_facets, from.face_facets, is_second ? 6 : 0);
            append(m.edges, from.edges, is_second ? 9 : 0);
            append(m.edge_segments, from.edge_segments, 0);
            for (const std::int32_t marker : from.face_markers) m.face_markers.push_back(marker);
            for (const std::int32_t marker : from.edge_markers) m.edge_markers.push_back(marker);
        }
        expect_found(domain, "meets the surroundings");
    }
    {
        // A tetrahedron in a hole, and a region with another marker.
        MeshedDomain domain;
        give(domain, cube());
        domain.build();
        domain.input().regions.push_back({{0.5, 0.25, 0.125}, 3});
        expect_found(domain, "region 0 has the marker 0, not 3");
        domain.input().regions.clear();
        domain.input().holes.push_back({{0.5, 0.25, 0.125}, 0});
        expect_found(domain, "is in a hole");
    }
}

TEST(Domain, NamesTheSegmentThatDoublesCannotDivide) {
    // Needles that meet at a point of a face, nearly in its plane.
    Surface s("fan");
    s.point(0, 0, 0);
    for (int i = 0; i < 60; ++i) {
        const double a = 1e-7 * i;
        s.point(std::cos(a), std::sin(a), 1e-9 * (i % 2));
        s.segments.push_back(0);
        s.segments.push_back(static_cast<std::uint32_t>(i + 1));
    }
    s.point(0, 0, 1);
    MeshedDomain domain;
    give(domain, s);
    domain.settings().index_base = 1;
    domain.settings().takes_open_surfaces = true;
    const Error error = error_of([&] { domain.build(); });
    EXPECT_TRUE(error.status == MGDT_OK || error.status == MGDT_ERR_RESOLUTION) << error.message;
    if (error.status == MGDT_OK) domain.check();
}

// Polygons that touch themselves, and polygons with repeated corners.
TEST(Domain, FillsPolygonsThatTouchThemselves) {
    const auto area_of = [](const std::vector<double>& points,
                            const std::vector<std::uint32_t>& corners) {
        Allocator allocator;
        Buffer<std::uint32_t> triangles(allocator);
        if (!triangulate_polygon(points.data(), corners.data(), corners.size(), triangles))
            return -1.0;
        double sum = 0;
        for (std::size_t t = 0; t < triangles.size(); t += 3) {
            const auto at = [&](std::size_t k, std::size_t c) {
                return points[3 * std::size_t{triangles[t + k]} + c];
            };
            const double part = (at(1, 0) - at(0, 0)) * (at(2, 1) - at(0, 1)) -
                                (at(1, 1) - at(0, 1)) * (at(2, 0) - at(0, 0));
            if (part <= 0) return -2.0;
            sum += part / 2;
        }
        return sum;
    };
    const std::vector<double> points = {0, 0, 0, 4, 0, 0, 4, 4, 0, 3, 2, 0, 2, 3, 0, 0, 4, 0};
    // A square from which a kite is cut that touches two of its corners.
    EXPECT_EQ(area_of(points, {0, 1, 2, 3, 0, 4, 3, 2, 5}), 16 - 2.5);
    EXPECT_EQ(area_of(points, {0, 1, 2, 5}), 16);
    EXPECT_EQ(area_of(points, {0, 2, 1, 5}), -1);  // it crosses itself
    Surface s = cube();
    s.facets[0] = {0, 0, 2, 3, 3, 1, 0};
    MeshedDomain domain;
    give(domain, s);
    domain.build();
    domain.check();
    EXPECT_EQ(domain.mesh().tetrahedron_count(), 6u);
}

}  // namespace
}  // namespace mgdt
