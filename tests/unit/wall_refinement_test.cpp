// SPDX-License-Identifier: MIT
// Refinement that divides facets and segments: the mesh fills the same domain with the same facets.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "flexible_meshes.hpp"
#include "improvable_meshes.hpp"
#include "one_thread.hpp"
#include "refinement/mesh_refinement.hpp"
#include "solid/mesh_check.hpp"
#include "unwatched.hpp"

namespace mgdt {
namespace {

struct Divided {
    Divided(const SolidMesh& given, double size) : copy(given), wishes(memory), report(memory) {
        options.divides_walls = true;
        options.size = size;
    }

    void refine(unsigned threads = 1) {
        Team team(threads);
        refine_mesh(copy.mesh, options, wishes, team, memory, Unwatched(), report);
    }
    const SolidMesh& mesh() const { return copy.mesh; }

    Allocator memory;
    Copy copy;
    RefinementOptions options;
    SizeWishes wishes;
    RefinementReport report;
};

const double* point(const SolidMesh& mesh, std::uint32_t v) {
    return mesh.points.begin() + 3 * std::size_t{v};
}

// The area vector of the faces of each facet.
std::map<std::uint32_t, Vector<double>> areas(const SolidMesh& mesh) {
    std::map<std::uint32_t, Vector<double>> all;
    for (std::size_t f = 0; f < mesh.face_facets.size(); ++f) {
        const double* const a = point(mesh, mesh.faces[3 * f]);
        const Vector<double> n = cross(difference<double>(point(mesh, mesh.faces[3 * f + 1]), a),
                                       difference<double>(point(mesh, mesh.faces[3 * f + 2]), a));
        Vector<double>& sum = all.insert({mesh.face_facets[f], {{0, 0, 0}}}).first->second;
        sum = sum + 0.5 * n;
    }
    return all;
}

void expect_same_facets(const SolidMesh& one, const SolidMesh& other) {
    const auto before = areas(one), after = areas(other);
    ASSERT_EQ(before.size(), after.size());
    for (const auto& [facet, area] : before) {
        const Vector<double> d = after.at(facet) - area;
        EXPECT_LT(dot(d, d), 1e-20 * dot(area, area)) << facet;
    }
}

// The length of all parts of each segment.
std::map<std::uint32_t, double> lengths(const SolidMesh& mesh) {
    std::map<std::uint32_t, double> all;
    for (std::size_t e = 0; e < mesh.edge_segments.size(); ++e) {
        const Vector<double> d =
            difference<double>(point(mesh, mesh.edges[2 * e]), point(mesh, mesh.edges[2 * e + 1]));
        all[mesh.edge_segments[e]] += std::sqrt(dot(d, d));
    }
    return all;
}

void expect_good(const SolidMesh& before, const Divided& refined) {
    Allocator memory;
    try {
        check_mesh(refined.mesh(), 0, memory, Unwatched());
    } catch (const Error& e) {
        ADD_FAILURE() << e.message;
    }
    expect_equal_volumes(refined.mesh());
    expect_same_facets(before, refined.mesh());
    const auto segments = lengths(refined.mesh());
    for (const auto& [segment, length] : lengths(before))
        EXPECT_NEAR(segments.at(segment), length, 1e-9 * length);
}

double longest_side(const SolidMesh& mesh) {
    double low[3], high[3], longest = 0;
    for (int k = 0; k < 3; ++k) low[k] = high[k] = mesh.points[static_cast<std::size_t>(k)];
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        low[i % 3] = std::min(low[i % 3], mesh.points[i]);
        high[i % 3] = std::max(high[i % 3], mesh.points[i]);
    }
    for (int k = 0; k < 3; ++k) longest = std::max(longest, high[k] - low[k]);
    return longest;
}

TEST(WallRefinement, DividesTheSidesOfBoxes) {
    for (const bool is_two : {false, true}) {
        MeshedDomain domain;
        Surface box{"box"};
        add_box(box, {0, 0, 0}, {3, 2, 1});
        if (is_two) add_box(box, {1, 0.5, 0.25}, {2, 1.5, 0.75});
        give(domain, box);
        domain.build();
        for (const double size : {1.0, 0.4, 0.2}) {
            Divided refined(domain.mesh(), size);
            refined.refine();
            expect_good(domain.mesh(), refined);
            EXPECT_LT(refined.report.refused, 5u);
            // Coordinates are small integers, so points are in the planes exactly.
            for (std::size_t i = 0; i < refined.mesh().faces.size(); ++i) {
                const double* const x = point(refined.mesh(), refined.mesh().faces[i]);
                const bool is_on_first = x[0] == 0 || x[0] == 3 || x[1] == 0 || x[1] == 2 ||
                                         x[2] == 0 || x[2] == 1,
                           is_on_second = x[0] == 1 || x[0] == 2 || x[1] == 0.5 || x[1] == 1.5 ||
                                          x[2] == 0.25 || x[2] == 0.75;
                ASSERT_TRUE(is_on_first || (is_two && is_on_second));
            }
        }
    }
}

TEST(WallRefinement, DividesWhatMeshesHave) {
    for_improvable_meshes([](const SolidMesh& given) {
        for (const double part : {0.0, 5.0, 12.0}) {
            Divided refined(given, part > 0 ? longest_side(given) / part : 0);
            refined.refine();
            expect_good(given, refined);
            Divided other(given, refined.options.size);
            other.refine(3);
            expect_equal(refined.mesh(), other.mesh());
        }
    });
}

// Two planes with an angle, down to a tenth of a degree.
TEST(WallRefinement, EndsInWedges) {
    for (const double degrees : {60.0, 30.0, 10.0, 3.0, 1.0, 0.3, 0.1}) {
        SCOPED_TRACE(degrees);
        const double rise = std::tan(degrees * std::acos(-1.0) / 180);
        Surface wedge{"wedge"};
        for (const double y : {0.0, 1.0}) {
            wedge.point(0, y, 0);
            wedge.point(1, y, 0);
            wedge.point(1, y, rise);
        }
        wedge.facet({0, 1, 2});
        wedge.facet({3, 5, 4});
        wedge.facet({0, 3, 4, 1});
        wedge.facet({1, 4, 5, 2});
        wedge.facet({2, 5, 3, 0});
        MeshedDomain domain;
        give(domain, wedge);
        domain.build();
        for (const double size : {0.0, 0.3, 0.1}) {
            Divided refined(domain.mesh(), size);
            refined.refine();
            expect_good(domain.mesh(), refined);
            EXPECT_LT(refined.report.inserted, 20000u);
        }
    }
}

TEST(WallRefinement, EndsInThinPlates) {
    for (const double height : {0.1, 1e-2, 1e-3, 1e-5}) {
        Surface plate{"plate"};
        add_box(plate, {0, 0, 0}, {1, 1, height});
        MeshedDomain domain;
        give(domain, plate);
        domain.build();
        for (const double size : {0.0, 0.2}) {
            Divided refined(domain.mesh(), size);
            refined.options.most_points = 100000;
            refined.refine();
            expect_good(domain.mesh(), refined);
        }
    }
}

}  // namespace
}  // namespace mgdt
