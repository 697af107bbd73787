// SPDX-License-Identifier: MIT
#include "mesh/tetrahedron_store.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

namespace mgdt {
namespace {

constexpr std::uint32_t count = 100000;

void fill(TetrahedronStore& store) {
    store.resize(count);
    for (std::uint32_t t = 0; t < count; ++t)
        store[t] = {{t + 1, t + 2, t + 3, t + 4}, {4 * t, 4 * t + 1, 4 * t + 2, 4 * t + 3}};
}

void expect_filled(const TetrahedronStore& store) {
    ASSERT_EQ(store.size(), count);
    for (std::uint32_t t = 0; t < count; ++t)
        for (std::uint32_t i = 0; i < 4; ++i) {
            ASSERT_EQ(store[t].v[i], t + 1 + i);
            ASSERT_EQ(store[t].n[i], 4 * t + i);
        }
}

TEST(TetrahedronStore, SpheresComeAndGo) {
    Allocator allocator;
    TetrahedronStore store(allocator);
    fill(store);
    EXPECT_TRUE(store.has_spheres());
    for (std::uint32_t t = 0; t < count; ++t) store.sphere(t) = {{1.0 * t, 2, 3}, -4};
    expect_filled(store);
    for (std::uint32_t t = 0; t < count; ++t) ASSERT_EQ(store.sphere(t).w[0], t);
    const std::size_t before = allocator.bytes();
    store.drop_spheres();
    EXPECT_FALSE(store.has_spheres());
    EXPECT_LE(2 * allocator.bytes(), before);
    expect_filled(store);
    store.make_room_for_spheres();
    EXPECT_TRUE(store.has_spheres());
    EXPECT_GE(store.capacity(), store.size());
    expect_filled(store);
}

// Nor does the number of slots change, whether the block shrinks or not: it is what limits are
// compared with, and what was reserved.
TEST(TetrahedronStore, CapacityIsThatOfSlots) {
    for (const bool shrinks : {true, false}) {
        static bool refuses;
        refuses = false;
        Allocator allocator(
            [](std::size_t bytes, std::size_t align, void*) {
                return refuses ? nullptr
                               : std::aligned_alloc(align, (bytes + align - 1) / align * align);
            },
            [](void* p, std::size_t, std::size_t, void*) { std::free(p); }, nullptr);
        TetrahedronStore store(allocator);
        store.reserve(2 * count);
        fill(store);
        const std::size_t before = allocator.bytes();
        refuses = !shrinks;
        store.drop_spheres();
        refuses = false;
        EXPECT_EQ(allocator.bytes(), shrinks ? before / 2 : before);
        EXPECT_EQ(store.capacity(), 2 * count);
        expect_filled(store);
        store.make_room_for_spheres();
        EXPECT_EQ(store.capacity(), 2 * count);
        expect_filled(store);
    }
}

TEST(TetrahedronStore, NoRoomForSpheresChangesNothing) {
    Allocator allocator;
    TetrahedronStore store(allocator);
    store.drop_spheres();
    fill(store);
    allocator.set_limit(allocator.bytes() + 1000);
    EXPECT_THROW(store.make_room_for_spheres(), std::bad_alloc);
    EXPECT_FALSE(store.has_spheres());
    expect_filled(store);
    allocator.set_limit(0);
    store.make_room_for_spheres();
    expect_filled(store);
}

// With its sphere a tetrahedron is on one cache line; the view is of the same places.
TEST(TetrahedronStore, OneLineEach) {
    Allocator allocator;
    TetrahedronStore store(allocator);
    fill(store);
    for (std::uint32_t t = 0; t < count; t += 999) {
        EXPECT_EQ(reinterpret_cast<std::uintptr_t>(&store[t]) % 64, 0u);
        EXPECT_EQ(reinterpret_cast<char*>(&store.sphere(t)) - reinterpret_cast<char*>(&store[t]),
                  32);
        EXPECT_EQ(&store.view<true>()[t], &store[t]);
        EXPECT_EQ(&store.view<true>().sphere(t), &store.sphere(t));
    }
    store.drop_spheres();
    EXPECT_EQ(&store.view<false>()[7], &store[7]);
}

}  // namespace
}  // namespace mgdt
