// SPDX-License-Identifier: MIT
#include "mesh/tetrahedron_store.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "../support/aligned.h"

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
    for (std::uint32_t t = 0; t < count; ++t) store.sphere(t) = {{t, 2, 3}, 4};
    expect_filled(store);
    for (std::uint32_t t = 0; t < count; ++t) {
        ASSERT_EQ(store.sphere(t).w[0], t);
        ASSERT_EQ(store.sphere(t).e, 4u);
    }
    const std::size_t before = allocator.bytes();
    store.drop_spheres();
    EXPECT_FALSE(store.has_spheres());
    EXPECT_LE(3 * allocator.bytes(), 2 * before);
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
                return refuses ? nullptr : allocate_aligned(bytes, align);
            },
            [](void* p, std::size_t, std::size_t, void*) { free_aligned(p); }, nullptr);
        TetrahedronStore store(allocator);
        store.reserve(2 * count);
        fill(store);
        const std::size_t before = allocator.bytes();
        refuses = !shrinks;
        store.drop_spheres();
        refuses = false;
        EXPECT_EQ(allocator.bytes(), shrinks ? before / 3 * 2 : before);
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

// A sphere and the base vertex, which tests look at, are on one cache line but for every fourth
// tetrahedron; the view is of the same places.
TEST(TetrahedronStore, SpheresBesideTheirTetrahedra) {
    Allocator allocator;
    TetrahedronStore store(allocator);
    fill(store);
    for (std::uint32_t t = 0; t < count; t += 999) {
        const auto sphere = reinterpret_cast<std::uintptr_t>(&store.sphere(t)),
                   base = reinterpret_cast<std::uintptr_t>(&store[t].v[0]);
        EXPECT_EQ(sphere % 16, 0u);
        EXPECT_EQ(base, sphere + 16);
        EXPECT_EQ(sphere / 64 != base / 64, t % 4 == 1) << t;
        const auto view = store.view<true>();
        EXPECT_EQ(&view[t], &store[t]);
        EXPECT_EQ(&view.sphere(t), &store.sphere(t));
        EXPECT_EQ(&view.of(4 * t + 3), &store[t]);
        EXPECT_EQ(&view.record(4 * t)->sphere, &store.sphere(t));
        const FacetCode codes[4] = {4 * t, 1, 4 * t + 2, 7};
        const auto four = view.four(codes);
        EXPECT_EQ(&four[0], &store[t]);
        EXPECT_EQ(&four[1], &store[0]);
        EXPECT_EQ(&four.sphere(2), &store.sphere(t));
        EXPECT_EQ(&four[3], &store[1]);
    }
    store.drop_spheres();
    EXPECT_EQ(&store.view<false>()[7], &store[7]);
    EXPECT_EQ(&store.view<false>().of(29), &store[7]);
}

}  // namespace
}  // namespace mgdt
