// SPDX-License-Identifier: MIT
// Results: vectors and buffers, of both widths, against definitions and brute force.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#if __cplusplus >= 202002L
#include <span>
#endif

#include "random_points.hpp"

using namespace cxx_test;
using mgdt::Triangulation;

namespace {

template <class Int>
class CxxResults : public ::testing::Test {};
using Widths = ::testing::Types<std::int64_t, std::int32_t>;
struct WidthNames {
    template <class Int>
    static std::string GetName(int) {
        return sizeof(Int) == 8 ? "Int64" : "Int32";
    }
};
TYPED_TEST_SUITE(CxxResults, Widths, WidthNames);

double squared_distance(const mgdt::Point& a, const mgdt::Point& b) {
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += (a[k] - b[k]) * (a[k] - b[k]);
    return sum;
}

}  // namespace

TYPED_TEST(CxxResults, TetrahedraFillTheHull) {
    const auto points = points_in_cube(size(3000));
    const Triangulation t = triangulated(points);
    const auto tetrahedra = t.tetrahedra<TypeParam>();
    const auto neighbors = t.neighbors<TypeParam>();
    ASSERT_EQ(std::int64_t(tetrahedra.size()), t.tetrahedron_count());
    ASSERT_EQ(neighbors.size(), tetrahedra.size());
    double sum = 0;
    std::size_t outside = 0;
    for (std::size_t k = 0; k < tetrahedra.size(); ++k) {
        const auto& [a, b, c, d] = tetrahedra[k];
        const double v = volume(points[std::size_t(a)], points[std::size_t(b)],
                                points[std::size_t(c)], points[std::size_t(d)]);
        EXPECT_GT(v, 0);
        sum += v;
        for (const TypeParam n : neighbors[k]) {
            if (n == -1) {
                ++outside;
                continue;
            }
            const auto& back = neighbors[std::size_t(n)];
            EXPECT_EQ(std::count(back.begin(), back.end(), TypeParam(k)), 1);
        }
    }
    EXPECT_NEAR(sum, 1, 1e-12);
    EXPECT_EQ(std::int64_t(outside), t.hull_facet_count());

    // The hull is a sphere of triangles: half as many vertices less two, the area of a cube.
    const auto facets = t.hull_facets<TypeParam>();
    std::set<TypeParam> corners;
    for (const auto& f : facets) corners.insert(f.begin(), f.end());
    EXPECT_EQ(facets.size(), 2 * corners.size() - 4);

    std::set<std::array<TypeParam, 2>> expected;
    for (const auto& e : tetrahedra)
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t j = 0; j < i; ++j)
                expected.insert({std::min(e[i], e[j]), std::max(e[i], e[j])});
    const auto edges = t.edges<TypeParam>();
    EXPECT_EQ(std::int64_t(edges.size()), t.edge_count());
    EXPECT_EQ((std::set<std::array<TypeParam, 2>>(edges.begin(), edges.end())), expected);
    EXPECT_EQ(edges.size(), expected.size());
}

TYPED_TEST(CxxResults, WeightsInEitherBase) {
    const auto points = points_in_cube(200);
    std::vector<double> values;
    for (const mgdt::Point& p : points) values.push_back(p[0] - 2 * p[1]);
    const std::vector<mgdt::Point> places = {{.5, .5, .5}, {2, 2, 2}, {.4, .6, .5}};
    for (const int base : {0, 1}) {
        Triangulation t;
        t.set_index_base(base);
        t.insert(points);
        for (const mgdt::Method method : {mgdt::Method::sibson, mgdt::Method::sibson_c1}) {
            const auto rows =
                t.interpolation_weights<TypeParam>(method, mgdt::Outside::none, places);
            const auto at = t.interpolate(method, mgdt::Outside::none, values, places);
            ASSERT_EQ(rows.offsets.size(), 4u);
            EXPECT_EQ(rows.offsets[0], base);
            EXPECT_EQ(rows.offsets[1], rows.offsets[2]);
            EXPECT_TRUE(std::isnan(at[1]));
            for (const std::size_t i : {0u, 2u}) {
                double value = 0;
                for (TypeParam k = rows.offsets[i] - base; k < rows.offsets[i + 1] - base; ++k)
                    value += rows.weights[std::size_t(k)] *
                             values[std::size_t(rows.points[std::size_t(k)] - base)];
                EXPECT_NEAR(value, places[i][0] - 2 * places[i][1], 1e-13);
                EXPECT_NEAR(at[i], value, 1e-14);
            }
        }
        const auto gradients = t.gradients(values);
        for (std::size_t k = 0; k < 600; ++k)
            EXPECT_NEAR(gradients[k], k % 3 == 0 ? 1 : k % 3 == 1 ? -2 : 0, 1e-12);
        values.pop_back();
        EXPECT_THROW((void)t.gradients(values), mgdt::Error);
        values.push_back(points[199][0] - 2 * points[199][1]);
    }
}

TYPED_TEST(CxxResults, VertexTetrahedraInEitherBase) {
    const auto points = points_in_cube(200);
    for (const int base : {0, 1}) {
        Triangulation t;
        t.set_index_base(base);
        t.insert(points);
        t.insert({points[3]});
        std::map<std::size_t, std::vector<TypeParam>> expected;
        const auto tetrahedra = t.tetrahedra<TypeParam>();
        for (std::size_t k = 0; k < tetrahedra.size(); ++k)
            for (const TypeParam v : tetrahedra[k])
                expected[std::size_t(v) - std::size_t(base)].push_back(TypeParam(k) +
                                                                       TypeParam(base));
        const auto around = t.vertex_tetrahedra<TypeParam>();
        EXPECT_EQ(around.offsets.size(), 202u);
        EXPECT_EQ(std::int64_t(around.list.size()), t.vertex_tetrahedra_count());
        for (std::size_t k = 0; k < 200; ++k) {
            const mgdt::Span<const TypeParam> found = around[k];
            EXPECT_EQ(std::vector<TypeParam>(found.begin(), found.end()), expected[k]);
        }
        EXPECT_TRUE(around[200].empty());
        std::vector<std::vector<TypeParam>> joined(201);
        for (const std::array<TypeParam, 2>& e : t.edges<TypeParam>())
            for (std::size_t i = 0; i < 2; ++i)
                joined[std::size_t(e[i]) - std::size_t(base)].push_back(e[1 - i]);
        EXPECT_EQ(t.spanning_tree<TypeParam>().size(), 199u);
        const auto edges = t.edges<TypeParam>(), gabriel = t.gabriel_edges<TypeParam>();
        const std::set<std::array<TypeParam, 2>> all(edges.begin(), edges.end());
        EXPECT_GT(gabriel.size(), 199u);
        for (const std::array<TypeParam, 2>& e : gabriel) EXPECT_EQ(all.count(e), 1u);
        const auto faces = t.cell_measures(mgdt::Measure::faces);
        const auto volumes = t.cell_measures(mgdt::Measure::volume, {{1, 0, 0, 1},
                                                                     {-1, 0, 0, 0},
                                                                     {0, 1, 0, 1},
                                                                     {0, -1, 0, 0},
                                                                     {0, 0, 1, 1},
                                                                     {0, 0, -1, 0}});
        EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0), 1, 1e-13);
        const auto neighbors = t.vertex_neighbors<TypeParam>();
        EXPECT_EQ(std::int64_t(neighbors.list.size()), t.vertex_neighbors_count());
        for (std::size_t k = 0; k < 201; ++k) {
            std::sort(joined[k].begin(), joined[k].end());
            EXPECT_EQ(std::vector<TypeParam>(neighbors[k].begin(), neighbors[k].end()), joined[k]);
            EXPECT_LE(faces[k], static_cast<double>(joined[k].size()));
        }
        EXPECT_EQ(t.point_map<TypeParam>().back(), 3 + base);
    }
}

TYPED_TEST(CxxResults, BuffersGetWhatVectorsHold) {
    using Int = TypeParam;
    const auto points = points_in_cube(100);
    const Triangulation t = triangulated(points);
    const auto tetrahedra = t.tetrahedra<Int>();
    const auto rows = [](const auto& arrays) {
        std::vector<Int> all;
        for (const auto& a : arrays) all.insert(all.end(), a.begin(), a.end());
        return all;
    };

    std::vector<Int> plain(4 * tetrahedra.size());
    t.tetrahedra(plain);
    EXPECT_EQ(plain, rows(tetrahedra));
    std::vector<std::array<Int, 4>> arrays(tetrahedra.size());
    t.tetrahedra(arrays);
    EXPECT_EQ(arrays, tetrahedra);
    std::vector<Int> larger(plain.size() + 3, Int(-7));
    t.tetrahedra(mgdt::Span<Int>(larger));
    EXPECT_TRUE(std::equal(plain.begin(), plain.end(), larger.begin()));
    EXPECT_EQ(std::count(larger.begin(), larger.end(), Int(-7)), 3);
#if __cplusplus >= 202002L
    std::vector<Int> spanned(plain.size());
    t.tetrahedra(std::span(spanned));
    EXPECT_EQ(spanned, plain);
#endif

    t.neighbors(arrays);
    EXPECT_EQ(arrays, t.neighbors<Int>());
    std::vector<std::array<Int, 3>> facets(std::size_t(t.hull_facet_count()));
    t.hull_facets(facets);
    EXPECT_EQ(facets, t.hull_facets<Int>());
    std::vector<std::array<Int, 2>> edges(std::size_t(t.edge_count()));
    t.edges(edges);
    EXPECT_EQ(edges, t.edges<Int>());
    Int map[100];
    t.point_map(map);
    EXPECT_EQ(std::vector<Int>(map, map + 100), t.point_map<Int>());
    std::vector<Int> offsets(101), list(plain.size());
    t.vertex_tetrahedra(offsets, list);
    EXPECT_EQ(offsets, t.vertex_tetrahedra<Int>().offsets);
    EXPECT_EQ(list, t.vertex_tetrahedra<Int>().list);
}

TYPED_TEST(CxxResults, BuffersThatAreTooSmallAreNotTouched) {
    using Int = TypeParam;
    const auto points = points_in_cube(30);
    const Triangulation t = triangulated(points);
    const std::size_t n = std::size_t(t.tetrahedron_count());
    const auto refused = [](std::size_t count, auto write) {
        std::vector<Int> buffer(count, 77);
        EXPECT_EQ(status_of([&] { write(buffer); }), MGDT_ERR_BUFFER_TOO_SMALL);
        EXPECT_EQ(std::count(buffer.begin(), buffer.end(), 77), std::ptrdiff_t(count));
    };
    refused(4 * n - 1, [&](auto& b) { t.tetrahedra(b); });
    refused(4 * n - 1, [&](auto& b) { t.neighbors(b); });
    refused(std::size_t(3 * t.hull_facet_count()) - 1, [&](auto& b) { t.hull_facets(b); });
    refused(std::size_t(2 * t.edge_count()) - 1, [&](auto& b) { t.edges(b); });
    refused(29, [&](auto& b) { t.point_map(b); });
    std::vector<Int> enough(4 * n);
    refused(30, [&](auto& b) { t.vertex_tetrahedra(b, enough); });
    refused(4 * n - 1, [&](auto& b) { t.vertex_tetrahedra(enough, b); });
    refused(29, [&](auto& b) { t.locate_points(points, b); });
    std::vector<double> weights(4 * 30 - 1, 77.);
    EXPECT_EQ(status_of([&] { t.locate_points(points, enough, weights); }),
              MGDT_ERR_BUFFER_TOO_SMALL);
    EXPECT_EQ(std::count(weights.begin(), weights.end(), 77.), 119);
}

TYPED_TEST(CxxResults, LocationAndWeights) {
    using Int = TypeParam;
    const auto points = points_in_cube(size(2000));
    const auto asked = points_in_cube(size(1000), 2);
    const Triangulation t = triangulated(points);
    const auto tetrahedra = t.tetrahedra<Int>();
    const auto found = t.locate_points<Int>(asked);
    const auto located = t.locate_with_weights<Int>(asked);
    EXPECT_EQ(located.tetrahedra, found);
    ASSERT_EQ(located.weights.size(), asked.size());
    for (std::size_t k = 0; k < asked.size(); ++k) {
        ASSERT_GE(found[k], 0);
        mgdt::Point sum{};
        for (std::size_t i = 0; i < 4; ++i) {
            const double w = located.weights[k][i];
            EXPECT_GT(w, -1e-9);
            for (std::size_t axis = 0; axis < 3; ++axis)
                sum[axis] += w * points[std::size_t(tetrahedra[std::size_t(found[k])][i])][axis];
        }
        EXPECT_LT(squared_distance(sum, asked[k]), 1e-20);
    }

    std::vector<Int> numbers(asked.size() + 1, Int(-9));
    std::vector<double> weights(4 * asked.size());
    t.locate_points(asked, numbers, weights);
    EXPECT_TRUE(std::equal(found.begin(), found.end(), numbers.begin()));
    EXPECT_EQ(numbers.back(), -9);
    std::vector<std::array<double, 4>> grouped(asked.size());
    t.locate_points(asked, numbers, grouped);
    EXPECT_EQ(grouped, located.weights);
    for (std::size_t k = 0; k < asked.size(); ++k)
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(weights[4 * k + i], located.weights[k][i]);

    const auto outside = t.locate_with_weights<Int>(std::vector<double>{2, 2, 2});
    EXPECT_EQ(outside.tetrahedra, std::vector<Int>{-1});
    EXPECT_EQ(outside.weights[0], (std::array<double, 4>{}));
    EXPECT_TRUE(t.locate_points<Int>(std::vector<double>()).empty());
}

TEST(CxxQueries, OnePointAtATime) {
    const auto points = points_in_cube(size(1000));
    const Triangulation t = triangulated(points);
    const auto tetrahedra = t.tetrahedra();
    for (const mgdt::Point& p : points_in_cube(50, 3)) {
        const std::int64_t inside = t.locate(p);
        ASSERT_GE(inside, 0);
        const auto& v = tetrahedra[std::size_t(inside)];
        for (std::size_t i = 0; i < 4; ++i) {
            mgdt::Point corner[4];
            for (std::size_t j = 0; j < 4; ++j) corner[j] = points[std::size_t(v[j])];
            corner[i] = p;
            EXPECT_GT(volume(corner[0], corner[1], corner[2], corner[3]), -1e-14);
        }
        std::size_t nearest = 0;
        for (std::size_t k = 1; k < points.size(); ++k)
            if (squared_distance(points[k], p) < squared_distance(points[nearest], p)) nearest = k;
        EXPECT_EQ(t.nearest_vertex(p), std::int64_t(nearest));
    }
    EXPECT_EQ(t.locate({-1, 0, 0}), -1);
    EXPECT_EQ(status_of([&] { (void)t.locate({0, INFINITY, 0}); }), MGDT_ERR_NOT_FINITE);
    EXPECT_EQ(status_of([&] { (void)t.nearest_vertex({NAN, 0, 0}); }), MGDT_ERR_NOT_FINITE);
    EXPECT_EQ(status_of([&] {
                  (void)t.locate_points(std::vector<double>{0, 0, NAN});
              }),
              MGDT_ERR_NOT_FINITE);
    EXPECT_EQ(Triangulation().nearest_vertex({0, 0, 0}), -1);
    // Many at once, of both kinds of integers.
    const std::vector<std::int64_t> all = t.nearest_vertices(points);
    const std::vector<std::int32_t> all32 = t.nearest_vertices<std::int32_t>(points);
    for (std::size_t k = 0; k < points.size(); ++k) {
        EXPECT_EQ(all[k], t.nearest_vertex(points[k]));
        EXPECT_EQ(all32[k], all[k]);
    }
    std::vector<std::int64_t> few(points.size() - 1);
    EXPECT_EQ(status_of([&] { t.nearest_vertices(points, few); }), MGDT_ERR_BUFFER_TOO_SMALL);
    EXPECT_EQ(Triangulation().locate({0, 0, 0}), -1);
}

template <class Int>
void leave_and_move() {
    auto points = points_in_cube(size(400));
    const std::size_t n = points.size();
    Triangulation t = triangulated(points);
    std::vector<Int> some, others;
    std::vector<mgdt::Point> places;
    for (std::size_t k = 0; k < n; k += 2) {
        some.push_back(Int(k));
        if (k + 1 == n) continue;
        others.push_back(Int(k + 1));
        points[k + 1] = {points[k + 1][0] / 2, points[k + 1][1], points[k + 1][2] + 1};
        places.push_back(points[k + 1]);
    }
    t.move(others, places);
    t.remove(some);
    EXPECT_EQ(t.vertex_count(), std::int64_t(others.size()));
    t.move(points);
    EXPECT_EQ(t.statistic(mgdt::Statistic::points_moved), double(others.size()));
    const std::vector<Int> index = t.renumber<Int>();
    for (std::size_t k = 0; k < n; ++k) EXPECT_EQ(index[k], k % 2 ? Int(k / 2) : -1);
    t.set_canonical_output(true);
    Triangulation fresh = triangulated(places);
    fresh.set_canonical_output(true);
    EXPECT_EQ(t.tetrahedra(), fresh.tetrahedra());
    t.check();
    EXPECT_EQ(status_of([&] { t.remove(std::vector<Int>{3, 3}); }), MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([&] { t.move(std::vector<Int>{3}, places); }), MGDT_ERR_INVALID_ARGUMENT);
    t.remove(std::vector<Int>());
    t.move(std::vector<Int>(), std::vector<mgdt::Point>());
}

TEST(CxxChanges, LeaveAndMove) {
    leave_and_move<std::int64_t>();
    leave_and_move<std::int32_t>();
    Triangulation t = triangulated(points_in_cube(20));
    t.remove({1, 2});
    t.move({3}, std::vector<double>{0.5, 0.5, 0.5});
    t.set_progress([](double) -> bool { throw 42; });
    EXPECT_THROW(t.remove({4}), int);
    EXPECT_THROW(t.move({4}, std::vector<double>{1, 2, 3}), int);
    EXPECT_EQ(t.vertex_count(), 18);
}

TEST(CxxFigures, AddUp) {
    const auto points = points_in_cube(size(1000));
    Triangulation t = triangulated(points);
    t.insert({points[0]});
    const auto stat = [&](mgdt::Statistic key) { return t.statistic(key); };
    EXPECT_EQ(stat(mgdt::Statistic::points_inserted), double(points.size()));
    EXPECT_EQ(stat(mgdt::Statistic::duplicates), 1);
    EXPECT_EQ(std::int64_t(points.size()), t.vertex_count());
    EXPECT_GT(stat(mgdt::Statistic::tetrahedra_created),
              stat(mgdt::Statistic::tetrahedra_removed) + double(t.tetrahedron_count()) - 1);
    EXPECT_GE(stat(mgdt::Statistic::peak_memory_bytes), stat(mgdt::Statistic::memory_bytes));
    for (const mgdt::Check level :
         {mgdt::Check::combinatorial, mgdt::Check::geometric, mgdt::Check::canonical})
        t.check(level);
    t.check();
}
