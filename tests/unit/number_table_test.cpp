// SPDX-License-Identifier: MIT
// The hash table, against std::map: keys that collide, growth, generations, refused memory.
#include <gtest/gtest.h>

#include <map>
#include <random>
#include <vector>

#include "mesh/numbers.hpp"
#include "platform/hash.hpp"

namespace mgdt {
namespace {

TEST(NumberTable, NumbersItemsInTheirOrder) {
    std::mt19937 random(1);
    Allocator allocator;
    NumberTable table(allocator);
    // Bits of the key that the hash has: all collide, many do, none does.
    for (const std::uint32_t bits : {0u, 0xF0u, ~0u}) {
        for (int generation = 0; generation < 20; ++generation) {
            std::vector<std::uint32_t> keys;
            std::map<std::uint32_t, std::uint32_t> expected;
            table.clear(generation % 3 == 0 ? 100 : 0);
            for (int k = 0; k < 300; ++k) {
                const auto key = static_cast<std::uint32_t>(random() % 200);
                const auto is_same = [&](std::uint32_t i) { return keys.at(i) == key; };
                table.reserve(keys.size() + 1);
                const auto found = expected.find(key);
                ASSERT_EQ(table.find(key & bits, is_same),
                          found == expected.end() ? no_index : found->second);
                const std::uint32_t number = table.number(key & bits, is_same);
                if (found == expected.end()) {
                    ASSERT_EQ(number, keys.size());
                    expected[key] = number;
                    keys.push_back(key);
                } else {
                    ASSERT_EQ(number, found->second);
                }
            }
            ASSERT_EQ(table.size(), keys.size());
            ASSERT_GE(table.capacity(), keys.size());
        }
    }
    table.reset();
    EXPECT_EQ(table.size(), 0u);
    EXPECT_EQ(table.capacity(), 0u);
}

TEST(NumberTable, CoordinatesHashAlikeWhereTheyAreEqual) {
    const double zero[3] = {0.0, -0.0, 1}, same[3] = {-0.0, 0.0, 1}, other[3] = {0, 1, 0};
    EXPECT_EQ(hash_of_coordinates(zero), hash_of_coordinates(same));
    EXPECT_NE(hash_of_coordinates(zero), hash_of_coordinates(other));
    // The lowest bits differ for neighbours on a lattice.
    std::vector<int> hits(256, 0);
    for (int i = 0; i < 4096; ++i) {
        const double p[3] = {static_cast<double>(i % 16), static_cast<double>(i / 16 % 16),
                             static_cast<double>(i / 256)};
        ++hits[hash_of_coordinates(p) & 255];
    }
    for (const int n : hits) EXPECT_LT(n, 64);
}

TEST(Numbers, LookUpWhatHasCome) {
    Allocator allocator;
    Numbers numbers(allocator);
    for (int generation = 0; generation < 5; ++generation) {
        numbers.clear();
        for (std::uint32_t k = 0; k < 1000; ++k) {
            ASSERT_EQ(numbers.number(7 * k), k);
            ASSERT_EQ(numbers.number(7 * (k / 2)), k / 2);
            ASSERT_EQ(numbers.name(k), 7 * k);
        }
        const auto lookup = numbers.lookup();
        for (std::uint32_t k = 0; k < 7000; ++k)
            ASSERT_EQ(lookup(k), k % 7 == 0 ? k / 7 : no_index);
    }
}

TEST(NumberTable, RefusedMemoryChangesNothing) {
    static int left;
    const auto take = [](std::size_t bytes, std::size_t align, void*) -> void* {
        return left-- > 0 ? ::operator new(bytes, std::align_val_t(align), std::nothrow) : nullptr;
    };
    const auto give = [](void* p, std::size_t, std::size_t align, void*) {
        ::operator delete(p, std::align_val_t(align));
    };
    Allocator allocator(take, give, nullptr);
    NumberTable table(allocator);
    left = 1;
    table.reserve(8);
    const auto is_same = [](std::uint32_t) { return true; };
    for (std::uint32_t k = 0; k < 8; ++k) ASSERT_EQ(table.number(k, is_same), k);
    EXPECT_THROW(table.reserve(9), std::bad_alloc);
    for (std::uint32_t k = 0; k < 8; ++k) EXPECT_EQ(table.find(k, is_same), k);
    EXPECT_EQ(table.size(), 8u);
}

}  // namespace
}  // namespace mgdt
