// SPDX-License-Identifier: MIT
// No function writes outside the arrays that it is given, or into any of them when it fails; none
// reads outside the arrays that it is given.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "../property/handle.hpp"
#include "canary_array.hpp"
#include "canary_functions.hpp"

namespace {

using namespace canaries;
using property::Handle;

std::vector<Handle> handles() {
    std::vector<Handle> all;
    std::mt19937_64 random(4);
    for (const std::size_t n : {0u, 1u, 3u, 20u, 4u, 5u, 33u, 700u}) {
        std::vector<double> xyz(3 * n);
        for (double& x : xyz) x = static_cast<double>(random() % 1000) / 1000;
        // Points 20 are flat.
        for (std::size_t i = 2; n == 20 && i < xyz.size(); i += 3) xyz[i] = 0;
        Handle t = property::create();
        EXPECT_EQ(mgdt_insert_points(t.get(), static_cast<std::int64_t>(n), xyz.data()), MGDT_OK);
        all.push_back(std::move(t));
    }
    return all;
}

struct Arrays {
    Arrays(const std::vector<Wanted>& wanted, Array::Place place) {
        for (std::size_t k = 0; k < wanted.size(); ++k) {
            arrays.emplace_back(static_cast<std::size_t>(wanted[k].elements),
                                wanted[k].element_size, place);
            given.array[k] = arrays[k].data();
            given.capacity[k] = wanted[k].elements;
            says_size.push_back(wanted[k].says_size);
        }
    }
    void expect_whole() const {
        for (const Array& a : arrays) EXPECT_TRUE(a.is_whole());
    }
    void expect_untouched() const {
        for (std::size_t k = 0; k < arrays.size(); ++k)
            EXPECT_TRUE(says_size[k] ? arrays[k].is_whole() : arrays[k].is_untouched());
    }
    std::vector<Array> arrays;
    std::vector<bool> says_size;
    Given given = {};
};

void expect_bounds(const Function& f, mgdt_triangulation* t, Array::Place place) {
    const std::vector<Wanted> wanted = f.wants(t);
    {
        const Arrays exact(wanted, place);
        EXPECT_EQ(f.call(t, exact.given), MGDT_OK) << property::error_of(t);
        exact.expect_whole();
        for (std::size_t k = 0; k < wanted.size(); ++k)
            EXPECT_TRUE(exact.arrays[k].is_written(wanted[k].element_size)) << k;
    }
    for (std::size_t k = 0; k < wanted.size(); ++k) {
        const bool is_needed = wanted[k].elements > 0 && !wanted[k].may_be_null;
        {
            Arrays none(wanted, place);
            none.given.array[k] = nullptr;
            EXPECT_EQ(f.call(t, none.given), is_needed ? MGDT_ERR_NULL_POINTER : MGDT_OK) << k;
            if (is_needed) none.expect_untouched();
            none.expect_whole();
        }
        if (!wanted[k].has_capacity) continue;
        for (const std::int64_t capacity :
             {wanted[k].elements - 1, std::int64_t{0}, std::int64_t{-1},
              std::numeric_limits<std::int64_t>::min()}) {
            if (capacity >= wanted[k].elements) continue;
            Arrays small(wanted, place);
            small.given.capacity[k] = capacity;
            EXPECT_EQ(f.call(t, small.given),
                      capacity < 0 ? MGDT_ERR_INVALID_ARGUMENT : MGDT_ERR_BUFFER_TOO_SMALL)
                << capacity;
            small.expect_untouched();
        }
        // More than it needs is not used.
        Arrays large(wanted, place);
        large.given.capacity[k] = std::numeric_limits<std::int64_t>::max();
        EXPECT_EQ(f.call(t, large.given), MGDT_OK);
        large.expect_whole();
    }
}

TEST(Canary, NothingOutsideTheArrays) {
    for (const Handle& t : handles())
        for (const std::int32_t base : {0, 1})
            for (const std::int32_t canonical : {0, 1}) {
                ASSERT_EQ(mgdt_set_index_base(t.get(), base), MGDT_OK);
                ASSERT_EQ(mgdt_set_canonical_output(t.get(), canonical), MGDT_OK);
                for (const Function& f : functions) {
                    if (!f.call) continue;
                    SCOPED_TRACE(std::string(f.name) + " of " +
                                 std::to_string(mgdt_point_count(t.get())) + " points");
                    for (const Array::Place place :
                         {Array::at_the_end, Array::at_the_begin, Array::off_by_one})
                        expect_bounds(f, t.get(), place);
                }
            }
}

TEST(Canary, NoHandle) {
    for (const Function& f : functions) {
        if (!f.call || std::string(f.name).find("create") != std::string::npos ||
            std::string(f.name).find("order_scheme") != std::string::npos)
            continue;
        const Arrays arrays({{8, 8, true, false}, {8, 8, true, false}}, Array::at_the_end);
        EXPECT_EQ(f.call(nullptr, arrays.given), MGDT_ERR_NULL_POINTER) << f.name;
        arrays.expect_untouched();
    }
}

TEST(Canary, Message) {
    const Handle t = property::create();
    ASSERT_EQ(mgdt_reserve(t.get(), -1), MGDT_ERR_INVALID_ARGUMENT);
    const std::string whole = property::error_of(t.get());
    ASSERT_GT(whole.size(), 10u);
    for (std::size_t capacity = 1; capacity < 300; ++capacity)
        for (const Array::Place place :
             {Array::at_the_end, Array::at_the_begin, Array::off_by_one}) {
            const Array a(capacity, 1, place);
            char* const text = static_cast<char*>(a.data());
            ASSERT_EQ(mgdt_get_error(t.get(), static_cast<std::int64_t>(capacity), text), MGDT_OK);
            EXPECT_TRUE(a.is_whole());
            EXPECT_EQ(std::string(text), whole.substr(0, capacity - 1));
        }
    const Array a(8, 1, Array::at_the_end);
    for (const std::int64_t capacity :
         {std::int64_t{0}, std::int64_t{-1}, std::numeric_limits<std::int64_t>::min()})
        EXPECT_EQ(mgdt_get_error(t.get(), capacity, static_cast<char*>(a.data())),
                  MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_TRUE(a.is_untouched());
}

// A query that is refused: nothing is written, wherever it stands.
TEST(Canary, RefusedQueries) {
    const std::vector<Handle> all = handles();
    mgdt_triangulation* const t = all.back().get();
    for (std::size_t bad = 0; bad < 3 * queries; bad += 11) {
        std::vector<double> xyz(query_points(), query_points() + 3 * queries);
        xyz[bad] = std::numeric_limits<double>::quiet_NaN();
        const Array found(queries, 8, Array::at_the_end),
            weights(4 * queries, 8, Array::at_the_end);
        EXPECT_EQ(
            mgdt_locate_points(t, queries, xyz.data(), static_cast<std::int64_t*>(found.data()),
                               static_cast<double*>(weights.data())),
            MGDT_ERR_NOT_FINITE);
        EXPECT_EQ(
            mgdt_nearest_vertices(t, queries, xyz.data(), static_cast<std::int64_t*>(found.data())),
            MGDT_ERR_NOT_FINITE);
        EXPECT_TRUE(found.is_untouched());
        EXPECT_TRUE(weights.is_untouched());
    }
}

// Points are read where they are and nowhere else, and stay as they are.
TEST(Canary, Input) {
    std::mt19937_64 random(5);
    for (const std::size_t n : {1u, 2u, 3u, 4u, 5u, 7u, 8u, 64u, 65u, 1000u, 1001u})
        for (const Array::Place place : {Array::at_the_end, Array::at_the_begin}) {
            const Array a(3 * n, sizeof(double), place);
            double* const xyz = static_cast<double*>(a.data());
            for (std::size_t i = 0; i < 3 * n; ++i) xyz[i] = static_cast<double>(random() % 4096);
            const std::vector<double> copy(xyz, xyz + 3 * n);
            const std::int64_t count = static_cast<std::int64_t>(n);
            const Handle t = property::create(), reversed = property::create();
            EXPECT_EQ(mgdt_insert_points(t.get(), count, xyz), MGDT_OK);
            const double* const last = xyz + 3 * (n - 1);
            EXPECT_EQ(
                mgdt_insert_points_strided(reversed.get(), count, last, last + 1, last + 2, -3),
                MGDT_OK);
            EXPECT_EQ(mgdt_tetrahedron_count(t.get()), mgdt_tetrahedron_count(reversed.get()));
            std::vector<std::int64_t> found(n);
            EXPECT_EQ(mgdt_locate_points(t.get(), count, xyz, found.data(), nullptr), MGDT_OK);
            EXPECT_EQ(mgdt_nearest_vertex(t.get(), last, found.data()), MGDT_OK);
            EXPECT_EQ(mgdt_nearest_vertices(t.get(), count, xyz, found.data()), MGDT_OK);
            EXPECT_EQ(std::memcmp(copy.data(), xyz, copy.size() * sizeof(double)), 0);
            const Array list(n, sizeof(std::int64_t), place),
                list32(n, sizeof(std::int32_t), place);
            auto* const points = static_cast<std::int64_t*>(list.data());
            auto* const points32 = static_cast<std::int32_t*>(list32.data());
            for (std::size_t i = 0; i < n; ++i) {
                points[i] = static_cast<std::int64_t>(n - 1 - i);
                points32[i] = static_cast<std::int32_t>(points[i]);
            }
            EXPECT_EQ(mgdt_move_points(t.get(), count, points, xyz), MGDT_OK);
            EXPECT_EQ(mgdt_move_points_i32(reversed.get(), count, points32, xyz), MGDT_OK);
            EXPECT_EQ(mgdt_move_points(t.get(), count, nullptr, xyz), MGDT_OK);
            EXPECT_EQ(std::memcmp(copy.data(), xyz, copy.size() * sizeof(double)), 0);
            EXPECT_EQ(mgdt_remove_points(t.get(), count, points), MGDT_OK);
            EXPECT_EQ(mgdt_remove_points_i32(reversed.get(), count, points32), MGDT_OK);
            for (std::size_t i = 0; i < n; ++i) {
                EXPECT_EQ(points[i], static_cast<std::int64_t>(n - 1 - i));
                EXPECT_EQ(points32[i], static_cast<std::int32_t>(n - 1 - i));
            }
        }
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::string(argv[1]) == "--list") {
        for (const Function& f : functions) std::puts(f.name);
        return 0;
    }
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
