// SPDX-License-Identifier: MIT
// Points in parts through the C++ interface: results, callbacks, failures, life.
#include <gtest/gtest.h>

#include <algorithm>
#include <memory_resource>
#include <stdexcept>
#include <string>

#include "random_points.hpp"

using namespace cxx_test;
using mgdt::Parts;
using mgdt::PartsArray;
using mgdt::PartsNumber;
using mgdt::PartsOption;

namespace {

using Tetrahedra = std::vector<std::array<std::int64_t, 4>>;

constexpr std::int32_t part_count = 3;

std::vector<mgdt::Point> share(const std::vector<mgdt::Point>& points, std::int32_t part) {
    const auto from = [&](std::int32_t p) {
        return points.begin() + static_cast<std::ptrdiff_t>(points.size()) * p / part_count;
    };
    return {from(part), from(part + 1)};
}

Parts with_points(const std::vector<mgdt::Point>& points) {
    Parts parts(part_count);
    for (std::int32_t p = 0; p < part_count; ++p) parts.insert(share(points, p), p);
    return parts;
}

// The tetrahedra that a part owns, by ids.
void append_owned(const Parts& parts, std::int32_t part, Tetrahedra& all) {
    const auto ids = parts.array(PartsArray::vertex_ids, part);
    Tetrahedra corners = parts.rows(PartsArray::local_corners, part);
    corners.resize(static_cast<std::size_t>(parts.number(PartsNumber::own_tetrahedra, part)));
    for (auto& tetrahedron : corners) {
        for (auto& corner : tetrahedron) corner = ids[static_cast<std::size_t>(corner)];
        std::sort(tetrahedron.begin(), tetrahedron.end());
    }
    all.insert(all.end(), corners.begin(), corners.end());
}

Tetrahedra sorted(Tetrahedra all) {
    for (auto& tetrahedron : all) std::sort(tetrahedron.begin(), tetrahedron.end());
    std::sort(all.begin(), all.end());
    return all;
}

TEST(Parts, HaveTheTetrahedraOfOne) {
    const auto points = points_in_cube(size(2000));
    const Tetrahedra expected = sorted(triangulated(points).tetrahedra());
    Parts parts = with_points(points);
    parts.build();
    parts.check();
    Tetrahedra all;
    for (std::int32_t p = 0; p < part_count; ++p) {
        append_owned(parts, p, all);
        const auto at = parts.coordinates(p);
        const auto ids = parts.array(PartsArray::vertex_ids, p);
        ASSERT_EQ(at.size(), ids.size());
        for (std::size_t i = 0; i < at.size(); ++i)
            EXPECT_EQ(at[i], points[static_cast<std::size_t>(ids[i])]);
    }
    EXPECT_EQ(sorted(all), expected);
    EXPECT_EQ(parts.number(PartsNumber::all_tetrahedra, 0),
              static_cast<std::int64_t>(expected.size()));
}

TEST(Parts, AreShownOneAfterAnother) {
    const auto points = points_in_cube(size(2000));
    Parts parts = with_points(points);
    Tetrahedra all;
    std::int32_t next = 0;
    parts.build_each([&](const Parts& shown, std::int32_t part) {
        EXPECT_EQ(part, next++);
        append_owned(shown, part, all);
        EXPECT_EQ(status_of([&] { (void)shown.rows(PartsArray::neighbors, part); }),
                  MGDT_ERR_INVALID_ARGUMENT);
    });
    EXPECT_EQ(next, part_count);
    EXPECT_EQ(sorted(all), sorted(triangulated(points).tetrahedra()));
    EXPECT_THROW(parts.build_each([](const Parts&, std::int32_t part) { return part == 1; }),
                 mgdt::Cancelled);
    EXPECT_THROW(parts.build_each([](const Parts&, std::int32_t part) {
        if (part == 2) throw std::runtime_error("seen enough");
    }),
                 std::runtime_error);
    parts.build();
}

TEST(Parts, NeedNoNumberWhereThereIsOne) {
    Parts one(1);
    const std::vector<std::int64_t> ids{10, 20, 30, 40};
    one.insert({std::vector<mgdt::Point>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, ids);
    one.build();
    EXPECT_EQ(one.rows(PartsArray::corners).size(), 1u);
    std::vector<std::int64_t> found = one.array(PartsArray::vertex_ids);
    std::sort(found.begin(), found.end());
    EXPECT_EQ(found, ids);
    EXPECT_EQ(one.coordinates().size(), 4u);
    Parts several(2);
    EXPECT_EQ(status_of([&] { (void)several.number(PartsNumber::points); }),
              MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(several.number(PartsNumber::points, 1), 0);
}

TEST(Parts, FailWithStatusAndMessage) {
    EXPECT_EQ(status_of([] { Parts none(0); }), MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([] { Parts none(mgdt_transport{}); }), MGDT_ERR_INVALID_ARGUMENT);
    Parts parts(part_count);
    const auto points = points_in_cube(20);
    EXPECT_EQ(status_of([&] { parts.insert(points, std::vector<std::int64_t>(3), 0); }),
              MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([&] { parts.insert(points, 7); }), MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(parts.last_error(), "part 7 is not among those of this process, 0 to 2");
    EXPECT_EQ(status_of([&] { (void)parts.rows(PartsArray::vertex_ids, 0); }),
              MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(status_of([&] { parts.set_option(PartsOption::index_base, 2); }),
              MGDT_ERR_INVALID_ARGUMENT);
    parts.clear();
    for (std::int32_t p = 0; p < part_count; ++p) parts.insert(points, p);
    parts.set_option(PartsOption::memory_limit, 1000);
    EXPECT_EQ(parts.option(PartsOption::memory_limit), 1000);
    EXPECT_THROW(parts.build(), mgdt::OutOfMemory);
    parts.set_option(PartsOption::memory_limit, 0);
    parts.build();
    parts.check(mgdt::Check::geometric);
    parts.cancel();
    EXPECT_THROW(parts.build(), mgdt::Cancelled);
}

TEST(Parts, TellProgress) {
    Parts parts = with_points(points_in_cube(size(2000)));
    long calls = 0;
    parts.set_progress([&](double fraction) {
        ++calls;
        EXPECT_LE(fraction, 1);
        EXPECT_THROW((void)parts.number(PartsNumber::points, 0), mgdt::Busy);
        EXPECT_EQ(parts.release(), nullptr);
    });
    parts.build();
    EXPECT_GT(calls, 5);
    parts.set_progress([](double) -> bool { throw std::runtime_error("closed"); });
    EXPECT_THROW(parts.build(), std::runtime_error);
    parts.clear_progress();
    parts.build();
}

TEST(Parts, MoveAndTakeHandlesOver) {
    std::pmr::unsynchronized_pool_resource pool;
    Parts a(part_count, pool), b(1);
    EXPECT_TRUE(a);
    swap(a, b);
    EXPECT_EQ(b.number(PartsNumber::parts, 0), part_count);
    Parts c = std::move(b);
    EXPECT_FALSE(b);  // NOLINT(bugprone-use-after-move): what is left is documented
    EXPECT_EQ(status_of([&] { b.build(); }), MGDT_ERR_NULL_POINTER);
    EXPECT_EQ(b.last_error(), "");
    b.cancel();
    b = std::move(c);
    EXPECT_NE(b.handle(), nullptr);
    mgdt_parts* const handle = b.release();
    EXPECT_FALSE(b);
    const Parts again(handle);
    EXPECT_EQ(again.handle(), handle);
}

}  // namespace
