// SPDX-License-Identifier: MIT
// The same set of tetrahedra as CGAL's Delaunay_triangulation_3 on every distribution, the
// degenerate and hostile ones included, for every order scheme and in 1, 2 and 7 batches.
//
//   cgal_equality_test [--size N] [--default-scheme] [--points FILE] [gtest options]
//
// CGAL's filters fall back to rational arithmetic, so it is exact from subnormals to 1e308 too.
// --points compares on the points of a file, too. Sets of quadratic size stay small.
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "cli/formats/format.hpp"
#include "handle.hpp"
#include "rows.hpp"

namespace {

using property::Keys;

struct Options {
    std::size_t size = is_small() ? 200 : 4000;
    bool every_scheme = true;
    std::string points;
} options;

// ------------------------------------------------------------------------------- CGAL's side

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_3<std::uint32_t, Kernel>;
using CellBase = CGAL::Delaunay_triangulation_cell_base_3<Kernel>;
using Structure = CGAL::Triangulation_data_structure_3<VertexBase, CellBase>;
using Delaunay = CGAL::Delaunay_triangulation_3<Kernel, Structure>;

struct Expected {
    int dimension = -1;
    Keys tetrahedra;
    std::vector<std::int64_t> map;  // first point with the same coordinates
};

std::vector<std::int64_t> first_of_equal(const std::vector<double>& xyz) {
    std::vector<std::uint32_t> order(xyz.size() / 3);
    std::iota(order.begin(), order.end(), 0u);
    const auto compare = [&](std::uint32_t i, std::uint32_t j) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double a = xyz[3 * std::size_t{i} + k], b = xyz[3 * std::size_t{j} + k];
            if (a != b) return a < b ? -1 : 1;
        }
        return 0;
    };
    std::sort(order.begin(), order.end(), [&](std::uint32_t i, std::uint32_t j) {
        const int c = compare(i, j);
        return c != 0 ? c < 0 : i < j;
    });
    std::vector<std::int64_t> map(order.size());
    std::uint32_t first = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        if (k == 0 || compare(order[k], first) != 0) first = order[k];
        map[order[k]] = first;
    }
    return map;
}

Expected triangulate_with_cgal(const std::vector<double>& xyz) {
    Expected out;
    out.map = first_of_equal(xyz);
    std::vector<std::pair<Delaunay::Point, std::uint32_t>> points;
    for (std::size_t i = 0; i < out.map.size(); ++i)
        if (out.map[i] == static_cast<std::int64_t>(i))
            points.emplace_back(Delaunay::Point(xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]),
                                static_cast<std::uint32_t>(i));
    const Delaunay delaunay(points.begin(), points.end());
    out.dimension = delaunay.dimension();
    EXPECT_EQ(delaunay.number_of_vertices(), points.size());
    if (out.dimension < 3) return out;
    for (auto c = delaunay.finite_cells_begin(); c != delaunay.finite_cells_end(); ++c) {
        property::Key key{};
        for (int k = 0; k < 4; ++k) key[static_cast<std::size_t>(k)] = c->vertex(k)->info();
        std::sort(key.begin(), key.end());
        out.tetrahedra.push_back(key);
    }
    std::sort(out.tetrahedra.begin(), out.tetrahedra.end());
    return out;
}

// -------------------------------------------------------------------------- the library's side

void compare(const std::vector<double>& xyz, const Expected& expected, std::int32_t scheme,
             std::size_t batches) {
    SCOPED_TRACE(std::string(mgdt_order_scheme_name(scheme)) + ", " + std::to_string(batches) +
                 " batches");
    const property::Handle t = property::create();
    ASSERT_EQ(mgdt_set_order_scheme(t.get(), scheme), MGDT_OK);
    ASSERT_EQ(property::insert(t.get(), xyz, property::equal_batches(xyz.size() / 3, batches)),
              MGDT_OK)
        << property::error_of(t.get());
    ASSERT_EQ(mgdt_dimension(t.get()), expected.dimension);
    ASSERT_EQ(mgdt_tetrahedron_count(t.get()),
              static_cast<std::int64_t>(expected.tetrahedra.size()));
    ASSERT_TRUE(property::point_map(t.get()) == expected.map);
    ASSERT_TRUE(property::keys(property::tetrahedra(t.get())) == expected.tetrahedra);
    ASSERT_EQ(mgdt_check(t.get(), MGDT_CHECK_CANONICAL), MGDT_OK) << property::error_of(t.get());
}

// The same points after others were there, and these were elsewhere.
void compare_after_changes(const std::vector<double>& xyz, const Expected& expected,
                           std::size_t batches) {
    SCOPED_TRACE("after changes in " + std::to_string(batches) + " batches");
    const std::size_t n = xyz.size() / 3;
    std::mt19937_64 random(n + batches);
    std::vector<double> first = xyz;
    // A third goes to where others are, or between them.
    std::vector<std::int64_t> moved, extra;
    for (std::size_t i = 0; i < n; ++i) {
        if (random() % 3 != 0) continue;
        const std::size_t j = random() % n;
        for (std::size_t k = 0; k < 3; ++k)
            first[3 * i + k] =
                random() % 2 == 0 ? xyz[3 * j + k] : xyz[3 * i + k] / 2 + xyz[3 * j + k] / 2;
        moved.push_back(static_cast<std::int64_t>(i));
    }
    for (std::size_t i = 0; i < n / 3; ++i) {
        const std::size_t j = random() % n, l = random() % n;
        for (std::size_t k = 0; k < 3; ++k)
            first.push_back(xyz[3 * j + k] / 2 + xyz[3 * l + k] / 2);
        extra.push_back(static_cast<std::int64_t>(n + i));
    }
    std::shuffle(moved.begin(), moved.end(), random);
    std::shuffle(extra.begin(), extra.end(), random);
    const property::Handle t = property::create();
    ASSERT_EQ(property::insert(t.get(), first, {0}), MGDT_OK) << property::error_of(t.get());
    for (std::size_t b = 0; b < batches; ++b) {
        const std::size_t m0 = moved.size() * b / batches, m1 = moved.size() * (b + 1) / batches;
        std::vector<double> places;
        for (std::size_t k = m0; k < m1; ++k)
            places.insert(places.end(), &xyz[3 * static_cast<std::size_t>(moved[k])],
                          &xyz[3 * static_cast<std::size_t>(moved[k])] + 3);
        ASSERT_EQ(mgdt_move_points(t.get(), static_cast<std::int64_t>(m1 - m0), moved.data() + m0,
                                   places.data()),
                  MGDT_OK)
            << property::error_of(t.get());
        const std::size_t e0 = extra.size() * b / batches, e1 = extra.size() * (b + 1) / batches;
        ASSERT_EQ(
            mgdt_remove_points(t.get(), static_cast<std::int64_t>(e1 - e0), extra.data() + e0),
            MGDT_OK)
            << property::error_of(t.get());
    }
    std::vector<std::int64_t> index(first.size() / 3);
    ASSERT_EQ(mgdt_renumber_points(t.get(), static_cast<std::int64_t>(index.size()), index.data()),
              MGDT_OK);
    ASSERT_EQ(mgdt_dimension(t.get()), expected.dimension);
    ASSERT_TRUE(property::point_map(t.get()) == expected.map);
    ASSERT_TRUE(property::keys(property::tetrahedra(t.get())) == expected.tetrahedra);
    ASSERT_EQ(mgdt_check(t.get(), MGDT_CHECK_CANONICAL), MGDT_OK) << property::error_of(t.get());
}

void compare_schemes(const std::vector<double>& xyz, const Expected& expected) {
    for (std::int32_t scheme : order_schemes) {
        if (!options.every_scheme && scheme != MGDT_ORDER_AUTO) continue;
        for (std::size_t batches : {1, 2, 7}) {
            compare(xyz, expected, scheme, batches);
            if (testing::Test::HasFatalFailure()) return;
        }
    }
    // In one call all is triangulated anew; in many, stars are filled one by one.
    for (const std::size_t batches : {std::size_t{1}, xyz.size() / 150 + 1}) {
        compare_after_changes(xyz, expected, batches);
        if (testing::Test::HasFatalFailure()) return;
    }
}

class EqualsCgal : public testing::TestWithParam<property::Row> {};

TEST_P(EqualsCgal, SameTetrahedra) {
    const std::vector<double> xyz = property::points(GetParam(), options.size);
    compare_schemes(xyz, triangulate_with_cgal(xyz));
}

INSTANTIATE_TEST_SUITE_P(Rows, EqualsCgal, testing::ValuesIn(property::rows),
                         [](const auto& info) { return std::string(info.param.name); });

// No common scale brings these into the range of a floating-point filter.
TEST(EqualsCgalMixed, ScalesInOneSet) {
    std::mt19937_64 random(7);
    std::vector<double> xyz;
    for (std::size_t i = 0; i < (is_small() ? 90u : 450u); ++i) {
        static constexpr double scale[] = {1e-300, 1, 1e300};
        xyz.push_back(scale[random() % 3] * (static_cast<double>(random() % 2001) - 1000));
    }
    const Expected expected = triangulate_with_cgal(xyz);
    for (std::int32_t scheme : order_schemes) compare(xyz, expected, scheme, 3);
}

// An axis far longer than another, a floor far below a terrain, one point far from all others.
struct FarScales {
    const char* name;
    double (*coordinate)(std::mt19937_64&, std::size_t point, int axis);
};
double unit(std::mt19937_64& random) {
    return static_cast<double>(random() >> 11) * 0x1p-53;
}
const FarScales far_scales[] = {
    {"FlatZ",
     [](std::mt19937_64& r, std::size_t, int axis) { return unit(r) * (axis == 2 ? 1e-300 : 1); }},
    {"LongXFlatZ",
     [](std::mt19937_64& r, std::size_t, int axis) {
         return unit(r) * (axis == 0 ? 1e150 : axis == 2 ? 1e-150 : 1);
     }},
    {"LongX",
     [](std::mt19937_64& r, std::size_t, int axis) { return unit(r) * (axis == 0 ? 1 : 1e-150); }},
    {"HalfSubnormal",
     [](std::mt19937_64& r, std::size_t point, int axis) {
         return unit(r) * (axis == 2 && point % 2 == 0 ? 1e-310 : 1);
     }},
    {"LatticeFlatZ",
     [](std::mt19937_64& r, std::size_t, int axis) {
         return static_cast<double>(r() % 9) * (axis == 2 ? 1e-300 : 1);
     }},
    {"LatticeOfThreeScales",
     [](std::mt19937_64& r, std::size_t, int axis) {
         return static_cast<double>(r() % 9) * (axis == 0 ? 1e150 : axis == 2 ? 1e-150 : 1);
     }},
    {"TerrainWithFloor",
     [](std::mt19937_64& r, std::size_t point, int axis) {
         return axis == 2 && point % 20 == 0 ? -DBL_MAX : unit(r) * (axis == 2 ? 0.1 : 1);
     }},
    {"LatticeTerrainWithFloor",
     [](std::mt19937_64& r, std::size_t point, int axis) {
         if (axis < 2) return static_cast<double>(r() % 25);
         return point % 20 == 0 ? -DBL_MAX : static_cast<double>(r() % 4);
     }},
    {"TenthFarUp", [](std::mt19937_64& r, std::size_t point,
                      int axis) { return unit(r) * (axis == 2 && point % 10 == 0 ? 1e300 : 1); }},
    {"OneFarAway",
     [](std::mt19937_64& r, std::size_t point, int) { return point == 100 ? 1e300 : unit(r); }},
    {"Nested", [](std::mt19937_64& r, std::size_t point,
                  int) { return std::ldexp(1 + unit(r), -static_cast<int>(4 * point % 1000)); }},
};

class EqualsCgalFarScales : public testing::TestWithParam<FarScales> {};

TEST_P(EqualsCgalFarScales, SameTetrahedra) {
    std::mt19937_64 random(11);
    std::vector<double> xyz;
    for (std::size_t i = 0; i < (is_small() ? 120u : 1500u); ++i)
        for (int axis = 0; axis < 3; ++axis) xyz.push_back(GetParam().coordinate(random, i, axis));
    const Expected expected = triangulate_with_cgal(xyz);
    for (std::int32_t scheme : order_schemes) compare(xyz, expected, scheme, 3);
}

INSTANTIATE_TEST_SUITE_P(Sets, EqualsCgalFarScales, testing::ValuesIn(far_scales),
                         [](const auto& info) { return std::string(info.param.name); });

void compare_file() {
    const mgdt::cli::InputFile file(options.points);
    const mgdt::cli::Source source = file.source();
    const std::vector<double> xyz =
        mgdt::cli::input_format(source, "").read(source, mgdt::cli::ReadOptions()).points;
    compare_schemes(xyz, triangulate_with_cgal(xyz));
}

class PointsOfFile : public testing::Test {
  public:
    void TestBody() override { compare_file(); }
};

}  // namespace

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    for (int i = 1; i < argc; ++i) {
        if (std::strcmp(argv[i], "--default-scheme") == 0) {
            options.every_scheme = false;
        } else if (std::strcmp(argv[i], "--size") == 0 && i + 1 < argc) {
            options.size = std::strtoull(argv[++i], nullptr, 10);
        } else if (std::strcmp(argv[i], "--points") == 0 && i + 1 < argc) {
            options.points = argv[++i];
        } else {
            std::fprintf(stderr, "unknown option %s\n", argv[i]);
            return 2;
        }
    }
    if (!options.points.empty())
        testing::RegisterTest("EqualsCgalFile", "SameTetrahedra", nullptr, options.points.c_str(),
                              __FILE__, __LINE__,
                              []() -> testing::Test* { return new PointsOfFile; });
    return RUN_ALL_TESTS();
}
