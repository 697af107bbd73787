// SPDX-License-Identifier: MIT
// Operations that improve a mesh: each keeps it a mesh of the same regions, and makes its worst
// tetrahedra better.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../support/counting_allocator.h"
#include "../support/small.h"
#include "flexible_meshes.hpp"
#include "improvable_meshes.hpp"
#include "improvement/explanation.hpp"
#include "improvement/mesh_improvement.hpp"
#include "solid/given_mesh.hpp"
#include "solid/mesh_check.hpp"

namespace mgdt {
namespace {

// Volumes of regions and areas of facets are the same, in rationals, where the vertices that move
// do so in planes with small integers.
TEST(Improvement, KeepsRegionsAndFacets) {
    for_improvable_meshes([](const SolidMesh& given) {
        const Sums before = sums_of(given);
        for (const bool slides : {false, true}) {
            Allocator memory;
            FlexibleMesh mesh(given, one_thread(), memory);
            const double worst = worst_of(mesh);
            improve(mesh, settings_for(25, slides), 1);
            expect_sound(mesh);
            EXPECT_GE(worst_of(mesh), worst);
            Copy written(given);
            mesh.write(written.mesh);
            try {
                check_mesh(written.mesh, 0, memory, Unwatched());
            } catch (const Error& e) {
                ADD_FAILURE() << e.message;
            }
            expect_equal_volumes(written.mesh);
            const Sums after = sums_of(written.mesh);
            if (!slides) {
                EXPECT_EQ(before.volumes, after.volumes);
                EXPECT_EQ(before.areas, after.areas);
            }
            for (const auto& [region, volume] : before.volumes)
                EXPECT_NEAR(static_cast<double>(after.volumes.at(region) / volume), 1, 1e-12);
            for (const auto& [facet, area] : before.areas)
                for (std::size_t k = 0; k < 3; ++k)
                    EXPECT_NEAR(static_cast<double>(after.areas.at(facet)[k] - area[k]), 0,
                                1e-12 * std::fabs(given.points[0]) + 1e-12);
        }
    });
}

TEST(Improvement, ReachesItsGoalInABox) {
    MeshedDomain domain;
    give(domain, gridded_box(8, 8, 8, 0.3, 11));
    domain.build();
    for (const auto& [slides, degrees] : {std::pair{false, 20.0}, {true, 25.0}, {true, 30.0}}) {
        Allocator memory;
        FlexibleMesh mesh(domain.mesh(), one_thread(), memory);
        const ImprovementSettings settings = settings_for(degrees, slides);
        EXPECT_LT(worst_of(mesh), std::pow(sine_of(2), 2));
        improve(mesh, settings, 1);
        EXPECT_GE(worst_of(mesh), settings.goal);
        // A second run has nothing to do but to raise the mean.
        Copy once(domain.mesh());
        mesh.write(once.mesh);
        ImprovementSettings again = settings;
        again.mean_passes = 0;
        improve(mesh, again, 1);
        Copy twice(domain.mesh());
        mesh.write(twice.mesh);
        expect_equal(once.mesh, twice.mesh);
    }
}

// A wedge with an angle of 15 degrees has a tetrahedron with a smaller one. Improvement ends.
TEST(Improvement, EndsBelowAGoalThatIsOutOfReach) {
    Surface wedge{"wedge"};
    const double angle = 15 * std::acos(-1.0) / 180;
    for (const double z : {0.0, 1.0}) {
        wedge.point(0, 0, z);
        wedge.point(1, 0, z);
        wedge.point(std::cos(angle), std::sin(angle), z);
    }
    wedge.facet({0, 2, 1});
    wedge.facet({3, 4, 5});
    wedge.facet({0, 1, 4, 3});
    wedge.facet({1, 2, 5, 4});
    wedge.facet({2, 0, 3, 5});
    MeshedDomain domain;
    give(domain, wedge);
    domain.build();
    Allocator memory;
    FlexibleMesh mesh(domain.mesh(), one_thread(), memory);
    const double before = worst_of(mesh);
    improve(mesh, settings_for(40, true), 1);
    expect_sound(mesh);
    EXPECT_GE(worst_of(mesh), before);
    EXPECT_LE(worst_of(mesh), std::pow(sine_of(15.01), 2));
    // Each tetrahedron that is left has a reason, and the wedge is one.
    Buffer<Reason> reasons(memory);
    explain(mesh, std::pow(sine_of(40), 2), reasons);
    int wedges = 0;
    for (std::size_t t = 0; t < reasons.size(); ++t) {
        if (mesh.tetrahedra[t].is_dead()) continue;
        EXPECT_EQ(reasons[t] == Reason::none, mesh.qualities[t] >= std::pow(sine_of(40), 2));
        wedges += reasons[t] == Reason::input_angle ? 1 : 0;
    }
    EXPECT_GT(wedges, 0);
    // With a lower goal the angle of the wedge is no reason.
    explain(mesh, std::pow(sine_of(14.9), 2), reasons);
    EXPECT_EQ(std::count(reasons.begin(), reasons.end(), Reason::input_angle), 0);
}

TEST(Improvement, NamesThinFacesAndFixedCorners) {
    const double goal = std::pow(sine_of(20), 2);
    Surface flat{"thin face"};  // a tetrahedron with a needle as one side
    flat.point(0, 0, 0);
    flat.point(1, 0, 0);
    flat.point(1, 0.1, 0);
    flat.point(0.5, 0, 0.8);
    flat.facet({0, 2, 1});
    flat.facet({0, 1, 3});
    flat.facet({1, 2, 3});
    flat.facet({2, 0, 3});
    MeshedDomain domain;
    give(domain, flat);
    domain.build();
    Allocator memory;
    FlexibleMesh mesh(domain.mesh(), one_thread(), memory);
    Buffer<Reason> reasons(memory);
    explain(mesh, goal, reasons);
    ASSERT_EQ(reasons.size(), 1u);
    EXPECT_EQ(reasons[0], Reason::input_angle);
    // Without facets, what is left are its corners, which are fixed; and if they are not, nothing.
    for (FlexibleMesh::Side& side : mesh.tetrahedra[0].facets) side = no_index;
    explain(mesh, goal, reasons);
    EXPECT_EQ(reasons[0], Reason::fixed_corners);
    mesh.classes[0] = free_vertex;
    explain(mesh, goal, reasons);
    EXPECT_EQ(reasons[0], Reason::other);
    // One face, which is thin.
    mesh.tetrahedra[0].facets[mesh.tetrahedra[0].position(3)] = 0;
    explain(mesh, goal, reasons);
    EXPECT_EQ(reasons[0], Reason::thin_face);
}

TEST(Improvement, IsTheSameForEachNumberOfThreads) {
    MeshedDomain domain;
    give(domain, is_small() != 0 ? gridded_box(5, 4, 4, 0.45, 12, true)
                                 : gridded_box(7, 6, 6, 0.45, 12, true));
    domain.build();
    Copy expected(domain.mesh());
    for (const unsigned threads : {1u, 2u, 3u, 5u, 16u}) {
        Allocator memory;
        FlexibleMesh mesh(domain.mesh(), one_thread(), memory);
        improve(mesh, settings_for(35, true), threads);
        Copy written(domain.mesh());
        mesh.write(written.mesh);
        if (threads == 1) mesh.write(expected.mesh);
        expect_equal(expected.mesh, written.mesh);
    }
}

// Each operation alone makes changes, and keeps the mesh sound.
TEST(Improvement, OperationsKeepTheMeshSound) {
    MeshedDomain domain;
    give(domain, is_small() != 0 ? gridded_box(5, 4, 4, 0.49, 15, true)
                                 : gridded_box(8, 6, 6, 0.49, 15, true));
    domain.build();
    const Sums before = sums_of(domain.mesh());
    for (int operation = 0; operation < 5; ++operation) {
        SCOPED_TRACE(operation);
        Allocator memory;
        FlexibleMesh mesh(domain.mesh(), one_thread(), memory);
        classify(mesh, true);
        Team team(1);
        const ImprovementSettings settings = settings_for(35, true);
        Improver improver(mesh, team, settings);
        std::size_t changes = 0;
        for (int pass = 0; pass < 3; ++pass) {
            improver.choose(operation == 4 ? above_all : settings.goal);
            changes += operation == 0   ? improver.flip(Unwatched())
                       : operation == 1 ? improver.contract(Unwatched())
                       : operation == 2 ? improver.insert(Unwatched())
                       : operation == 3 ? improver.smooth(Unwatched())
                                        : improver.smooth_mean(Unwatched());
            expect_sound(mesh);
        }
        EXPECT_GT(changes, is_small() != 0 ? 0u : 10u);
        Copy written(domain.mesh());
        mesh.write(written.mesh);
        EXPECT_NO_THROW(check_mesh(written.mesh, 0, memory, Unwatched()));
        const Sums after = sums_of(written.mesh);
        EXPECT_EQ(before.volumes, after.volumes);
        EXPECT_EQ(before.areas, after.areas);
    }
}

// A pass of moves that ends early, here because memory is refused, is taken back.
TEST(Improvement, KeepsNoMovesOfAnInterruptedPass) {
    MeshedDomain domain;
    give(domain, gridded_box(5, 5, 5, 0.49, 15));
    domain.build();
    int refused = 0;
    // The first pass is not interrupted, and counts the allocations.
    std::int64_t calls = 0;
    for (std::int64_t at = 0; at <= calls; ++at) {
        counting_allocator source = {};
        bool is_refused = false;
        {
            Allocator memory(counted_allocate, counted_release, &source);
            FlexibleMesh mesh(domain.mesh(), one_thread(), memory);
            classify(mesh, false);
            const std::vector<double> places(mesh.x.begin(), mesh.x.end()),
                qualities(mesh.qualities.begin(), mesh.qualities.end());
            Smoothing smoothing(mesh, one_thread());
            Buffer<std::uint32_t> all(memory);
            for (std::uint32_t t = 0; t < mesh.tetrahedra.size(); ++t) all.push_back(t);
            const std::int64_t before = source.calls;
            source.act_at = at == 0 ? 0 : before + at;
            source.act = [](void* on) { static_cast<Allocator*>(on)->set_limit(1); };
            source.on = &memory;
            try {
                smoothing.pass(all, {4, best_quality, best_quality, false}, {1, 1}, Unwatched());
            } catch (const std::bad_alloc&) {
                is_refused = true;
                ++refused;
            }
            calls = std::max(calls, source.calls - before);
            EXPECT_EQ(is_refused,
                      std::equal(places.begin(), places.end(), mesh.x.begin(), mesh.x.end()));
            EXPECT_EQ(is_refused, std::equal(qualities.begin(), qualities.end(),
                                             mesh.qualities.begin(), mesh.qualities.end()));
        }
        EXPECT_EQ(source.blocks, 0);
    }
    EXPECT_GT(refused, 20);
}

// Where memory runs out, nothing is lost but the improvement.
TEST(Improvement, EndsWhereMemoryDoes) {
    MeshedDomain domain;
    give(domain, gridded_box(4, 3, 3, 0.45, 22));
    domain.build();
    std::size_t needed = 0;
    {
        Allocator memory;
        FlexibleMesh mesh(domain.mesh(), one_thread(), memory);
        improve(mesh, settings_for(30, true), 1);
        needed = memory.peak();
        Copy written(domain.mesh());
        written.memory.set_limit(written.memory.bytes() + 1000);
        EXPECT_THROW(mesh.write(written.mesh), std::bad_alloc);
        expect_equal(domain.mesh(), written.mesh);
        EXPECT_TRUE(written.mesh.is_delaunay);
    }
    int refused = 0;
    for (int part = 1; part <= 20; ++part) {
        Allocator memory;
        memory.set_limit(needed * static_cast<std::size_t>(part) / 20);
        try {
            FlexibleMesh mesh(domain.mesh(), one_thread(), memory);
            improve(mesh, settings_for(30, true), 1);
        } catch (const std::bad_alloc&) {
            ++refused;
        }
        EXPECT_EQ(memory.bytes(), 0u);
    }
    EXPECT_GT(refused, 10);
}

// Vertices near corners of a box, between two edges of one line, leave: one edge takes the place of
// each two.
TEST(Improvement, ContractsEdgesAlongLines) {
    Surface s = gridded_box(3, 3, 3, 0.3, 21);
    for (const std::size_t v : {1u, 4u, 16u}) {  // the first points on the three axes
        ASSERT_EQ(s.points[3 * v] + s.points[3 * v + 1] + s.points[3 * v + 2], 1);
        for (std::size_t k = 0; k < 3; ++k) s.points[3 * v + k] /= 32;
    }
    MeshedDomain domain;
    give(domain, s);
    domain.build();
    ASSERT_EQ(domain.mesh().edge_segments.size(), 36u);
    Allocator memory;
    FlexibleMesh mesh(domain.mesh(), one_thread(), memory);
    classify(mesh, true);
    Team team(1);
    Improver improver(mesh, team, settings_for(20, true));
    for (int pass = 0; pass < 4; ++pass) {
        improver.choose(above_all);
        improver.contract(Unwatched());
        expect_sound(mesh);
    }
    Copy written(domain.mesh());
    mesh.write(written.mesh);
    EXPECT_LT(written.mesh.edge_segments.size(), 36u);
    // The edges are those of the box still: their lengths along each axis are 12 in all.
    double length[3] = {0, 0, 0};
    for (std::size_t e = 0; e < written.mesh.edges.size(); e += 2)
        for (std::size_t k = 0; k < 3; ++k)
            length[k] += std::fabs(written.mesh.points[3 * written.mesh.edges[e] + k] -
                                   written.mesh.points[3 * written.mesh.edges[e + 1] + k]);
    for (const double l : length) EXPECT_EQ(l, 12);
    EXPECT_NO_THROW(check_mesh(written.mesh, 0, memory, Unwatched()));
    EXPECT_EQ(volume(written.mesh), 27);
}

// A change whose tetrahedra do not fill the place of those that leave is refused, and leaves the
// mesh as it was.
TEST(Improvement, RefusesChangesThatDoNotFit) {
    MeshedDomain domain;
    give(domain, gridded_box(4, 4, 3, 0.4, 13, true));
    domain.build();
    Allocator memory;
    FlexibleMesh mesh(domain.mesh(), one_thread(), memory);
    classify(mesh, true);
    EdgeRemoval edges(mesh, true);
    EdgeContraction contractions(mesh);
    VertexInsertion insertions(mesh);
    FaceRemoval faces(mesh);
    std::mt19937_64 random(14);
    Copy before(domain.mesh());
    mesh.write(before.mesh);
    Change change(memory), wrong(memory);
    int refused = 0;
    for (std::uint32_t t = 0; t < mesh.tetrahedra.size(); ++t)
        for (unsigned i = 0; i < 4; ++i) {
            const unsigned operation = random() % 4;
            const bool is_found = operation == 0   ? edges.find(t, i, (i + 1) % 4, change)
                                  : operation == 1 ? faces.find(t, i, change)
                                  : operation == 2 ? contractions.find(t, i, (i + 1) % 4, change)
                                                   : insertions.find(t, above_all, change);
            if (!is_found) continue;
            wrong.clear();
            for (const std::uint32_t r : change.removed) wrong.removed.push_back(r);
            for (const Change::Tetrahedron& a : change.added) wrong.added.push_back(a);
            for (const Change::Face& f : change.faces) wrong.faces.push_back(f);
            wrong.more = change.more;
            const std::size_t kinds = change.faces.empty() ? 4 : 5;
            const std::size_t at = random() % wrong.added.size();
            switch (random() % kinds) {
                case 0:  // one too few
                    wrong.added[at] = wrong.added.back();
                    wrong.added.pop_back();
                    break;
                case 1: {  // twice
                    const Change::Tetrahedron copy = wrong.added[at];
                    wrong.added.push_back(copy);
                    break;
                }
                case 2:
                    std::swap(wrong.added[at].v[0], wrong.added[at].v[1]);
                    break;
                case 3:
                    wrong.removed.pop_back();
                    break;
                default:
                    wrong.faces.pop_back();
                    break;
            }
            EXPECT_FALSE(mesh.apply(wrong));
            ++refused;
        }
    EXPECT_GT(refused, 20);
    expect_sound(mesh);
    Copy after(domain.mesh());
    mesh.write(after.mesh);
    expect_equal(before.mesh, after.mesh);
}

// Two boxes whose surfaces nearly touch, with a dent that is nearly plane: a vertex that slides in
// one would run into the other.
TEST(Improvement, SlidingSurfacesDoNotMeet) {
    constexpr double dent = 0x1p-22, gap = 0x1p-40;
    Allocator memory;
    GivenMesh given(memory);
    for (const int upper : {0, 1}) {
        const auto first = static_cast<std::uint32_t>(given.points.size() / 3);
        for (std::uint32_t i = 0; i < 18; ++i) {
            const std::uint32_t x = i % 3, y = i / 3 % 3, z = i / 9;
            const bool is_inner = x == 1 && y == 1 && z != static_cast<std::uint32_t>(upper);
            given.points.push_back(is_inner ? 1.7 : x);
            given.points.push_back(is_inner ? 1.6 : y);
            given.points.push_back(z + upper * (1 + gap) - (is_inner ? dent : 0));
            if (x == 2 || y == 2 || z == 1) continue;
            std::array<std::uint32_t, 3> steps = {1, 3, 9};
            do {
                std::uint32_t v = first + i;
                given.tetrahedra.push_back(v);
                for (const std::uint32_t step : steps) given.tetrahedra.push_back(v += step);
            } while (std::next_permutation(steps.begin(), steps.end()));
        }
    }
    SolidMesh mesh(memory);
    link_mesh(given, 0, one_thread(), memory, Unwatched(), mesh);
    ASSERT_EQ(mesh.planar_facets, 12u);
    ImprovementOptions options;
    options.slides = true;
    ImprovementReport report(memory);
    Team team(1);
    const Buffer<std::uint32_t> fixed(memory);
    improve_mesh(mesh, options, fixed, team, memory, Unwatched(), report);
    EXPECT_EQ(report.moved_points, 0u);
    EXPECT_NO_THROW(check_mesh(mesh, 0, memory, Unwatched()));
    // Without the upper box the vertex slides.
    given.points.resize(54);
    given.tetrahedra.resize(given.tetrahedra.size() / 2);
    SolidMesh alone(memory);
    link_mesh(given, 0, one_thread(), memory, Unwatched(), alone);
    improve_mesh(alone, options, fixed, team, memory, Unwatched(), report);
    EXPECT_GT(report.moved_points, 0u);
    EXPECT_NO_THROW(check_mesh(alone, 0, memory, Unwatched()));
}

}  // namespace
}  // namespace mgdt
