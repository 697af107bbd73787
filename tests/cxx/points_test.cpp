// SPDX-License-Identifier: MIT
// Points from every kind of container, and settings.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#if __cplusplus >= 202002L
#include <span>
#endif

#include "random_points.hpp"

using namespace cxx_test;
using mgdt::Triangulation;

struct Node {
    double x, y, z;
};
template <>
struct mgdt::is_point<Node> : std::true_type {};

namespace {

struct Record {
    int id;
    float weight;
    double x, y, z, temperature;
};

// The tetrahedra as a function of the points alone.
std::vector<std::array<std::int64_t, 4>> canonical(Triangulation& t) {
    t.set_canonical_output(true);
    t.check();
    return t.tetrahedra();
}

template <class... Arguments>
auto canonical_of(const Arguments&... arguments) {
    Triangulation t;
    t.insert(arguments...);
    return canonical(t);
}

}  // namespace

TEST(CxxPoints, EveryContainerGivesTheSame) {
    const auto points = points_in_cube(60);
    const auto xyz = flat(points);
    const auto expected = canonical_of(points);
    ASSERT_GT(expected.size(), 60u);

    EXPECT_EQ(canonical_of(xyz), expected);
    EXPECT_EQ(canonical_of(mgdt::Points(xyz.data(), 60)), expected);
    EXPECT_EQ(canonical_of(mgdt::Span<const double>(xyz)), expected);
    EXPECT_EQ(canonical_of(mgdt::Span<const mgdt::Point>(points)), expected);

    std::array<mgdt::Point, 60> fixed;
    double rows[60][3], plain[180];
    std::vector<Node> nodes;
    std::vector<double> x, y, z;
    std::vector<Record> records;
    for (std::size_t k = 0; k < 60; ++k) {
        const mgdt::Point& p = points[k];
        fixed[k] = p;
        std::copy(p.begin(), p.end(), rows[k]);
        std::copy(p.begin(), p.end(), plain + 3 * k);
        nodes.push_back({p[0], p[1], p[2]});
        x.push_back(p[0]);
        y.push_back(p[1]);
        z.push_back(p[2]);
        records.push_back({int(k), 1.f, p[0], p[1], p[2], 300.});
    }
    EXPECT_EQ(canonical_of(fixed), expected);
    EXPECT_EQ(canonical_of(rows), expected);
    EXPECT_EQ(canonical_of(plain), expected);
    EXPECT_EQ(canonical_of(nodes), expected);
    EXPECT_EQ(canonical_of(x, y, z), expected);

    Triangulation strided;
    static_assert(sizeof(Record) % sizeof(double) == 0);
    const std::int64_t stride = sizeof(Record) / sizeof(double);
    strided.insert_strided(60, &records[0].x, &records[0].y, &records[0].z, stride);
    EXPECT_EQ(canonical(strided), expected);

    Triangulation batches;
    batches.reserve(60);
    batches.insert(mgdt::Points(xyz.data(), 25));
    batches.insert(mgdt::Points(xyz.data() + 75, 35));
    EXPECT_EQ(canonical(batches), expected);

#if __cplusplus >= 202002L
    EXPECT_EQ(canonical_of(std::span(xyz)), expected);
    EXPECT_EQ(canonical_of(std::span<const mgdt::Point, 60>(fixed)), expected);
    const mgdt::Span<const double> ours(xyz);
    const std::span<const double> theirs(ours);
    EXPECT_EQ(theirs.size(), xyz.size());
#endif
}

TEST(CxxPoints, ListsAndNothing) {
    Triangulation t;
    t.insert({});
    t.insert(std::vector<double>());
    t.insert(std::vector<mgdt::Point>());
    EXPECT_EQ(t.point_count(), 0);
    EXPECT_EQ(t.dimension(), -1);
    t.insert({{0, 0, 0}});
    EXPECT_EQ(t.dimension(), 0);
    t.insert({{1, 0, 0}, {0, 1, 0}});
    EXPECT_EQ(t.dimension(), 2);
    EXPECT_TRUE(t.tetrahedra().empty());
    t.insert({{0, 0, 1}, {0, 0, 0}});
    EXPECT_EQ(t.dimension(), 3);
    EXPECT_EQ(t.point_count(), 5);
    EXPECT_EQ(t.vertex_count(), 4);
    EXPECT_EQ(t.tetrahedron_count(), 1);
    EXPECT_EQ(t.point_map(), (std::vector<std::int64_t>{0, 1, 2, 3, 0}));
    t.clear();
    EXPECT_EQ(t.point_count(), 0);
    EXPECT_EQ(t.dimension(), -1);
}

TEST(CxxPoints, NothingIsCopiedOrChanged) {
    const auto points = points_in_cube(500);
    const mgdt::Points view(points);
    EXPECT_EQ(view.data(), points[0].data());
    EXPECT_EQ(view.count(), 500u);
    auto before = points;
    Triangulation t;
    t.insert(before);
    EXPECT_EQ(before, points);
}

TEST(CxxPoints, WrongOnesAreRefused) {
    Triangulation t;
    EXPECT_EQ(status_of([&] { t.insert(std::vector<double>(7)); }), MGDT_ERR_INVALID_ARGUMENT);
    const std::vector<double> two(2), three(3);
    EXPECT_EQ(status_of([&] { t.insert(three, three, two); }), MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([&] { t.insert(two, three, three); }), MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([&] { t.insert_strided(2, two.data(), nullptr, two.data(), 1); }),
              MGDT_ERR_NULL_POINTER);
    EXPECT_EQ(status_of([&] { t.insert(mgdt::Points(nullptr, 1)); }), MGDT_ERR_NULL_POINTER);
    try {
        t.insert({{0, 0, 0}, {0, NAN, 0}});
        FAIL() << "no exception";
    } catch (const mgdt::Error& error) {
        EXPECT_EQ(error.status(), MGDT_ERR_NOT_FINITE);
        EXPECT_NE(std::string(error.what()).find('1'), std::string::npos) << error.what();
        EXPECT_EQ(error.what(), t.last_error());
    }
    EXPECT_EQ(t.point_count(), 0);
}

TEST(CxxSettings, EverySchemeGivesTheSame) {
    const auto points = points_in_cube(size(2000));
    const auto expected = canonical_of(points);
    const std::vector<mgdt::Order> all = mgdt::order_schemes();
    for (const mgdt::Order order : all) {
        Triangulation t;
        t.set_order_scheme(order);
        t.set_order_parameter(mgdt::Parameter::points_per_cell, 5);
        t.set_order_parameter(mgdt::Parameter::threshold, 50);
        t.set_order_parameter(mgdt::Parameter::separation, 0);
        t.set_order_parameter(mgdt::Parameter::round_ratio, 3);
        t.set_seed(7);
        t.set_threads(2);
        t.insert(points);
        EXPECT_EQ(canonical(t), expected) << mgdt::name(order);
        EXPECT_EQ(mgdt::order_from_name(mgdt::name(order)), order);
        EXPECT_EQ(mgdt::order_from_name(std::string(mgdt::name(order))), order);
    }
    ASSERT_GE(all.size(), 10u);
    EXPECT_EQ(all.front(), mgdt::Order::automatic);
    EXPECT_EQ(all.back(), mgdt::Order::multi_grid);
}

TEST(CxxSettings, IndexBaseAndInstructionSet) {
    const auto points = points_in_cube(50);
    const auto expected = canonical_of(points);
    Triangulation t;
    t.set_index_base(1);
    t.set_isa("baseline");
    EXPECT_STREQ(t.isa(), "baseline");
    t.insert(points);
    auto found = canonical(t);
    for (auto& tetrahedron : found)
        for (auto& v : tetrahedron) --v;
    EXPECT_EQ(found, expected);
    EXPECT_EQ(t.locate({9, 9, 9}), 0);
    t.set_isa(nullptr);
    EXPECT_EQ(status_of([&] { t.set_isa("abacus"); }), MGDT_ERR_INVALID_ARGUMENT);
}

TEST(CxxSettings, WrongOnesAreRefused) {
    Triangulation t;
    EXPECT_EQ(status_of([&] { t.set_order_scheme(mgdt::Order(5)); }), MGDT_ERR_UNKNOWN_SCHEME);
    EXPECT_EQ(status_of([&] { t.set_order_parameter(mgdt::Parameter(5), 1); }),
              MGDT_ERR_UNKNOWN_KEY);
    EXPECT_EQ(status_of([&] { t.set_order_parameter(mgdt::Parameter::threshold, -1); }),
              MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([&] { t.set_index_base(2); }), MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([&] { t.set_threads(-1); }), MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([&] { t.set_memory_limit(-1); }), MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([&] { t.reserve(-1); }), MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([&] { t.check(mgdt::Check(0)); }), MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([&] { (void)t.statistic(mgdt::Statistic(5)); }), MGDT_ERR_UNKNOWN_KEY);
    EXPECT_EQ(status_of([] { (void)mgdt::order_from_name("abacus"); }), MGDT_ERR_UNKNOWN_SCHEME);
    EXPECT_EQ(status_of([] { (void)mgdt::order_from_name(nullptr); }), MGDT_ERR_NULL_POINTER);
    t.insert({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    EXPECT_EQ(t.tetrahedron_count(), 1);
}

TEST(CxxNames, AsInTheCInterface) {
    EXPECT_STREQ(mgdt::name(mgdt::Statistic::walk_steps), mgdt_stat_name(MGDT_STAT_WALK_STEPS));
    EXPECT_EQ(mgdt::name(mgdt::Statistic(5)), nullptr);
    EXPECT_EQ(mgdt::name(mgdt::Order(5)), nullptr);
    EXPECT_STREQ(mgdt::status_string(MGDT_ERR_CANCELLED), mgdt_status_string(MGDT_ERR_CANCELLED));
    EXPECT_STREQ(mgdt::version(), mgdt_version_string());
    EXPECT_EQ(mgdt::abi_version(), 1);
}
