// SPDX-License-Identifier: MIT
// Refinement: the mesh stays a mesh of the same regions and faces, and its tetrahedra are within
// the bounds or are said to be beyond them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "../support/counting_allocator.h"
#include "flexible_meshes.hpp"
#include "improvable_meshes.hpp"
#include "one_thread.hpp"
#include "refinement/cubic_lattice.hpp"
#include "refinement/mesh_refinement.hpp"
#include "solid/mesh_check.hpp"
#include "unwatched.hpp"

namespace mgdt {
namespace {

struct Refined {
    explicit Refined(const SolidMesh& given) : copy(given), wishes(memory), report(memory) {}

    void refine(unsigned threads = 1) {
        Team team(threads);
        refine_mesh(copy.mesh, options, wishes, team, memory, Unwatched(), report);
    }
    const SolidMesh& mesh() const { return copy.mesh; }
    const double* point(std::uint32_t v) const {
        return copy.mesh.points.begin() + 3 * std::size_t{v};
    }
    ElementShape element(std::size_t t) const {
        const std::uint32_t* const v = copy.mesh.tetrahedra.begin() + 4 * t;
        return element_of(point(v[0]), point(v[1]), point(v[2]), point(v[3]));
    }

    Allocator memory;
    Copy copy;
    RefinementOptions options;
    SizeWishes wishes;
    RefinementReport report;
};

// The faces of a mesh with their facets and markers, each with its corners in ascending order.
std::multiset<std::array<std::int64_t, 5>> faces_of(const SolidMesh& mesh) {
    std::multiset<std::array<std::int64_t, 5>> all;
    for (std::size_t f = 0; f < mesh.face_facets.size(); ++f) {
        std::array<std::int64_t, 3> v = {mesh.faces[3 * f], mesh.faces[3 * f + 1],
                                         mesh.faces[3 * f + 2]};
        std::sort(v.begin(), v.end());
        all.insert({v[0], v[1], v[2], mesh.face_facets[f], mesh.face_markers[f]});
    }
    return all;
}

void expect_good_mesh(const SolidMesh& mesh) {
    Allocator memory;
    try {
        check_mesh(mesh, 0, memory, Unwatched());
    } catch (const Error& e) {
        ADD_FAILURE() << e.message;
    }
    expect_equal_volumes(mesh);
}

// Tetrahedra beyond the bounds are those that have a refusal.
void expect_bounds(const Refined& refined) {
    const RefinementOptions& options = refined.options;
    std::size_t beyond = 0;
    for (std::size_t t = 0; t < refined.mesh().tetrahedron_count(); ++t) {
        const ElementShape e = refined.element(t);
        double size = 0;
        for (std::size_t k = 4 * t; k < 4 * t + 4; ++k)
            size += refined.report.sizes[refined.mesh().tetrahedra[k]] / 4;
        const double rounding = 1e-9;
        const bool is_large = std::sqrt(e.radius2) > 0.8 * size * (1 + rounding),
                   is_small = std::sqrt(e.radius2) < 0.8 * size * (1 - rounding);
        const double ratio = std::sqrt(e.radius2 / e.shortest2);
        const bool is_refused = refined.report.refusals[t] != Refusal::none;
        if (is_large || ratio > options.radius_edge * (1 + rounding)) {
            EXPECT_TRUE(is_refused) << t;
        }
        if (is_small && ratio < options.radius_edge * (1 - rounding)) {
            EXPECT_FALSE(is_refused) << t;
        }
        beyond += is_refused;
    }
    EXPECT_EQ(beyond, refined.report.refused);
}

TEST(Refinement, KeepsRegionsAndFaces) {
    for_improvable_meshes([](const SolidMesh& given) {
        double low[3], high[3];
        for (int k = 0; k < 3; ++k) low[k] = high[k] = given.points[static_cast<std::size_t>(k)];
        for (std::size_t i = 0; i < given.points.size(); ++i) {
            low[i % 3] = std::min(low[i % 3], given.points[i]);
            high[i % 3] = std::max(high[i % 3], given.points[i]);
        }
        const double longest = std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
        for (const bool are_of_surface : {false, true}) {
            Refined refined(given);
            refined.options.size = longest / (are_of_surface ? 5 : 8);
            refined.options.sizes_of_surface = are_of_surface;
            refined.refine();
            expect_good_mesh(refined.mesh());
            expect_bounds(refined);
            EXPECT_EQ(faces_of(given), faces_of(refined.mesh()));
            EXPECT_EQ(refined.mesh().points.size() - given.points.size(),
                      3 * refined.report.inserted);
            for (std::size_t i = 0; i < given.points.size(); ++i)
                ASSERT_EQ(given.points[i], refined.mesh().points[i]);
            Refined other(given);
            other.options = refined.options;
            other.refine(3);
            expect_equal(refined.mesh(), other.mesh());
        }
    });
}

// Adds the sides of a cube of n^3 unit cubes.
void add_gridded_sides(Surface& to, int n, double origin) {
    const Surface box = gridded_box(n, n, n, 0, 1);
    std::map<std::uint32_t, std::uint32_t> number;
    for (std::size_t f = 0; f < box.facets.size(); ++f) {
        std::vector<std::uint32_t> corners = box.facets[f];
        for (std::uint32_t& v : corners) {
            const double* const x = box.points.data() + 3 * std::size_t{v};
            if (number.count(v) == 0)
                number[v] = to.point(origin + x[0], origin + x[1], origin + x[2]);
            v = number[v];
        }
        to.facet(corners, box.markers[f]);
    }
}

// A box whose sides have the wanted size is filled with edges near it.
TEST(Refinement, FillsABoxWithOneSize) {
    MeshedDomain domain;
    Surface hollow{"hollow box"};
    add_gridded_sides(hollow, 12, 0);
    give(domain, hollow);
    domain.build();
    Refined refined(domain.mesh());
    refined.options.size = 1.2;
    refined.refine();
    expect_good_mesh(refined.mesh());
    expect_bounds(refined);
    EXPECT_LT(refined.report.refused, 10u);
    std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (std::size_t t = 0; t < refined.mesh().tetrahedron_count(); ++t)
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const std::uint32_t a = refined.mesh().tetrahedra[4 * t + i],
                                    b = refined.mesh().tetrahedra[4 * t + j];
                edges.insert({std::min(a, b), std::max(a, b)});
            }
    std::size_t near = 0;
    for (const auto& [a, b] : edges) {
        const Vector<double> d = difference<double>(refined.point(a), refined.point(b));
        const double relative = std::sqrt(dot(d, d)) / refined.options.size;
        near += relative > std::sqrt(0.5) && relative < std::sqrt(2);
    }
    EXPECT_GT(static_cast<double>(near), 0.95 * static_cast<double>(edges.size()));
}

TEST(Refinement, StopsAtTheMostPoints) {
    MeshedDomain domain;
    give(domain, gridded_box(6, 6, 6, 0.3, 2));
    domain.build();
    for (const std::int32_t most : {1, 7, 100}) {
        Refined refined(domain.mesh());
        refined.options.size = 0.3;
        refined.options.most_points = most;
        refined.refine();
        EXPECT_EQ(refined.report.inserted, static_cast<std::size_t>(most));
        EXPECT_NE(std::count(refined.report.refusals.begin(), refined.report.refusals.end(),
                             Refusal::no_points_left),
                  0);
        expect_good_mesh(refined.mesh());
    }
}

TEST(Refinement, BoundsVolumes) {
    MeshedDomain domain;
    give(domain, gridded_box(4, 4, 4, 0.2, 2));
    domain.build();
    Refined refined(domain.mesh());
    refined.options.radius_edge = 0;
    refined.options.volume = 0.02;
    refined.refine();
    expect_good_mesh(refined.mesh());
    for (std::size_t t = 0; t < refined.mesh().tetrahedron_count(); ++t) {
        if (refined.report.refusals[t] == Refusal::none) {
            EXPECT_LE(refined.element(t).volume, 0.02 * (1 + 1e-12));
        }
    }
    EXPECT_LT(refined.report.refused, refined.mesh().tetrahedron_count() / 10);
}

TEST(Refinement, RefusesSizesThatAreTooSmall) {
    MeshedDomain domain;
    give(domain, gridded_box(3, 3, 3, 0.2, 2));
    domain.build();
    Refined refined(domain.mesh());
    for (const double size : {1e-3, 1e-100, 1e-300}) {
        refined.options.size = size;
        try {
            refined.refine();
            ADD_FAILURE() << "no error";
        } catch (const Error& e) {
            EXPECT_EQ(e.status, MGDT_ERR_TOO_LARGE);
        }
    }
    expect_equal(domain.mesh(), refined.mesh());
    EXPECT_FALSE(refined.report.is_made);
}

// Sizes grow from a small one by the gradation.
TEST(Refinement, LimitsSizesByTheGradation) {
    MeshedDomain domain;
    give(domain, gridded_box(8, 8, 8, 0.2, 2));
    domain.build();
    for (const double gradation : {0.2, 0.5}) {
        Refined refined(domain.mesh());
        refined.options.gradation = gradation;
        refined.wishes.of_points.resize(domain.mesh().points.size() / 3, 0.0);
        refined.wishes.of_points[0] = 0.1;
        refined.options.size = 2;
        refined.refine();
        expect_good_mesh(refined.mesh());
        expect_bounds(refined);
        const Buffer<double>& sizes = refined.report.sizes;
        EXPECT_NEAR(sizes[0], 0.1, 1e-12);
        EXPECT_EQ(*std::min_element(sizes.begin(), sizes.end()), sizes[0]);
        for (std::size_t t = 0; t < refined.mesh().tetrahedron_count(); ++t)
            for (std::size_t i = 4 * t; i < 4 * t + 4; ++i)
                for (std::size_t j = 4 * t; j < i; ++j) {
                    const std::uint32_t a = refined.mesh().tetrahedra[i],
                                        b = refined.mesh().tetrahedra[j];
                    const Vector<double> d = difference<double>(refined.point(a), refined.point(b));
                    EXPECT_LE(0.949 * sizes[a], sizes[b] + gradation * std::sqrt(dot(d, d)));
                    EXPECT_LE(0.949 * sizes[b], sizes[a] + gradation * std::sqrt(dot(d, d)));
                }
    }
}

TEST(Refinement, SizesOfTetrahedraAndRegions) {
    MeshedDomain domain;
    give(domain, gridded_box(6, 4, 4, 0.2, 2, true));
    domain.build();
    const SolidMesh& given = domain.mesh();
    ASSERT_EQ(given.region_markers.size(), 2u);
    const auto points_in = [](const SolidMesh& mesh, std::uint32_t region) {
        std::set<std::uint32_t> points;
        for (std::size_t t = 0; t < mesh.tetrahedron_count(); ++t)
            if (mesh.regions[t] == region)
                points.insert(mesh.tetrahedra.begin() + 4 * t, mesh.tetrahedra.begin() + 4 * t + 4);
        return points.size();
    };
    for (const bool are_of_regions : {true, false}) {
        Refined refined(given);
        if (are_of_regions) {
            refined.wishes.of_regions.push_back(0.4);
            refined.wishes.of_regions.push_back(0.0);
        } else {
            for (std::size_t t = 0; t < given.tetrahedron_count(); ++t)
                refined.wishes.of_tetrahedra.push_back(given.regions[t] == 0 ? 0.4 : 0.0);
        }
        refined.refine();
        expect_good_mesh(refined.mesh());
        expect_bounds(refined);
        EXPECT_GT(points_in(refined.mesh(), 0), 3 * points_in(refined.mesh(), 1));
    }
}

// The distance from a place inside of the box, and a size that grows with it.
double size_near_a_place(const double* x) {
    const double place[3] = {4.1, 3.2, 4.7};
    const Vector<double> d = difference<double>(x, place);
    return 0.15 + 0.25 * std::sqrt(dot(d, d));
}

void expect_edges_of_size(const Refined& refined) {
    std::size_t near = 0, all = 0;
    for (std::size_t t = 0; t < refined.mesh().tetrahedron_count(); ++t)
        for (std::size_t i = 4 * t; i < 4 * t + 4; ++i)
            for (std::size_t j = 4 * t; j < i; ++j) {
                const double* const a = refined.point(refined.mesh().tetrahedra[i]);
                const double* const b = refined.point(refined.mesh().tetrahedra[j]);
                const Vector<double> d = difference<double>(a, b);
                const double middle[3] = {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2};
                const double relative = std::sqrt(dot(d, d)) / size_near_a_place(middle);
                near += relative > 0.5 && relative < 1.6;
                ++all;
            }
    EXPECT_GT(static_cast<double>(near), 0.95 * static_cast<double>(all));
}

TEST(Refinement, SizesOfAFunction) {
    MeshedDomain domain;
    give(domain, gridded_box(8, 8, 8, 0, 2));
    domain.build();
    Refined refined(domain.mesh());
    std::size_t asked = 0;
    refined.wishes.varying.user = &asked;
    refined.wishes.varying.function = [](std::int64_t n, const double* xyz, double* sizes,
                                         void* user) -> std::int32_t {
        *static_cast<std::size_t*>(user) += static_cast<std::size_t>(n);
        for (std::int64_t i = 0; i < n; ++i) {
            EXPECT_EQ(sizes[i], 0);
            sizes[i] = size_near_a_place(xyz + 3 * i);
        }
        return 0;
    };
    refined.refine();
    expect_good_mesh(refined.mesh());
    expect_bounds(refined);
    expect_edges_of_size(refined);
    EXPECT_LT(asked, 10 * refined.report.inserted + 5000);
    Refined other(domain.mesh());
    other.wishes.varying.user = &asked;
    other.wishes.varying.function = refined.wishes.varying.function;
    other.refine(3);
    expect_equal(refined.mesh(), other.mesh());
}

TEST(Refinement, SizesOfAField) {
    MeshedDomain domain;
    give(domain, gridded_box(8, 8, 8, 0, 2));
    domain.build();
    Refined refined(domain.mesh());
    Buffer<double>& points = refined.wishes.varying.field_points;
    for (int i = 0; i < 11 * 11 * 11; ++i)
        for (const int step : {1, 11, 121}) points.push_back(i / step % 11 - 1);
    for (const double c : {4.1, 3.2, 4.7}) points.push_back(c);
    for (std::size_t i = 0; i < points.size(); i += 3)
        refined.wishes.varying.field_sizes.push_back(size_near_a_place(points.begin() + i));
    refined.refine();
    expect_good_mesh(refined.mesh());
    expect_bounds(refined);
    expect_edges_of_size(refined);
}

// A region with large elements between regions with small ones.
TEST(Refinement, SizesOfNestedRegions) {
    MeshedDomain domain;
    Surface boxes{"nested boxes"};
    for (const int inset : {0, 1, 8}) add_gridded_sides(boxes, 18 - 2 * inset, inset);
    give(domain, boxes);
    domain.build();
    ASSERT_EQ(domain.mesh().region_markers.size(), 3u);
    double volumes[3] = {0, 0, 0};
    for (std::size_t t = 0; t < domain.mesh().tetrahedron_count(); ++t)
        volumes[domain.mesh().regions[t]] += Refined(domain.mesh()).element(t).volume;
    std::size_t inserted[2];
    for (const bool are_equal : {false, true}) {
        Refined refined(domain.mesh());
        refined.options.gradation = 0.5;
        for (const double volume : volumes)
            refined.wishes.of_regions.push_back(volume > 3000 && !are_equal ? 4.0 : 1.2);
        refined.refine();
        expect_good_mesh(refined.mesh());
        expect_bounds(refined);
        inserted[are_equal] = refined.report.inserted;
    }
    EXPECT_LT(2 * inserted[0], inserted[1]);
}

// Whatever the library is refused, the mesh stays as it was, and nothing leaks.
TEST(Refinement, RunsOutOfMemory) {
    MeshedDomain domain;
    give(domain, gridded_box(3, 3, 3, 0.2, 2, true));
    domain.build();
    bool is_done = false;
    for (std::int64_t at = 1; !is_done; ++at) {
        Refined refined(domain.mesh());
        refined.options.size = 0.5;
        counting_allocator source = {};
        source.refuse_at = at;
        {
            Allocator memory(counted_allocate, counted_release, &source);
            RefinementReport report(refined.memory);
            try {
                refine_mesh(refined.copy.mesh, refined.options, refined.wishes, one_thread(),
                            memory, Unwatched(), report);
                is_done = true;
            } catch (const std::bad_alloc&) {
                EXPECT_FALSE(report.is_made);
                expect_equal(domain.mesh(), refined.mesh());
            }
        }
        EXPECT_EQ(source.blocks, 0);
    }
}

TEST(Verdicts, KeepWhatTheyAreGiven) {
    EXPECT_FALSE(Verdict().is_bad());
    EXPECT_FALSE(Verdict(1.0).is_bad());
    unsigned last = 0;
    for (double excess = 1.0001; excess < 1e300; excess *= 1.7) {
        Verdict verdict(excess);
        ASSERT_TRUE(verdict.is_bad()) << excess;
        EXPECT_GE(verdict.class_of(), last);
        last = verdict.class_of();
        EXPECT_LT(last, Verdict::n_classes);
        for (unsigned tries = 0; tries < 4; ++tries) {
            EXPECT_EQ(verdict.tries(), tries);
            EXPECT_TRUE(verdict.is_bad());
            EXPECT_EQ(verdict.class_of(), last);
            if (tries < 3) verdict.count_try();
        }
        EXPECT_EQ(verdict.refusal(), Refusal::none);
    }
    EXPECT_EQ(last + 1, unsigned{Verdict::n_classes});
    EXPECT_TRUE(Verdict(std::numeric_limits<double>::infinity()).is_bad());
    for (const Refusal refusal : {Refusal::hidden, Refusal::near_vertex, Refusal::near_wall,
                                  Refusal::shapeless, Refusal::no_points_left}) {
        EXPECT_FALSE(Verdict(refusal).is_bad());
        EXPECT_EQ(Verdict(refusal).refusal(), refusal);
    }
}

// The nearest point of the lattice, by a search of all points near it.
TEST(CubicLattice, SnapsToTheNearestPoint) {
    CubicLattice lattice;
    lattice.step = 0.7;
    for (int k = 0; k < 3; ++k) lattice.origin[k] = 0.01 * (k + 1);
    std::uint64_t state = 5;
    const auto number = [&] {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state >> 40) * 0x1p-24 * 8 - 4;
    };
    for (int i = 0; i < 300; ++i) {
        const double x[3] = {number(), number(), number()};
        double least = 1e300, snapped[3], distance = 0;
        for (int half = 0; half < 2; ++half)
            for (int a = -7; a <= 7; ++a)
                for (int b = -7; b <= 7; ++b)
                    for (int c = -7; c <= 7; ++c) {
                        const int at[3] = {a, b, c};
                        double d = 0;
                        for (int k = 0; k < 3; ++k)
                            d += std::pow(
                                lattice.origin[k] + (at[k] + 0.5 * half) * lattice.step - x[k], 2);
                        least = std::min(least, d);
                    }
        lattice.snap(x, snapped);
        for (int k = 0; k < 3; ++k) distance += std::pow(snapped[k] - x[k], 2);
        EXPECT_NEAR(std::sqrt(distance), std::sqrt(least), CubicLattice::jitter * lattice.step);
        // Every point of the lattice is moved always by the same.
        double again[3];
        lattice.snap(snapped, again);
        EXPECT_TRUE(std::equal(snapped, snapped + 3, again));
    }
}

}  // namespace
}  // namespace mgdt
