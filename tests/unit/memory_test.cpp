// SPDX-License-Identifier: MIT
#include "platform/memory.hpp"

#include <gtest/gtest.h>
#if defined(__GLIBC__)
#include <malloc.h>
#include <sys/resource.h>
#endif

#include <algorithm>
#include <cstdint>
#include <vector>

#include "../support/small.h"

namespace mgdt {
namespace {

constexpr std::size_t small = 1000, medium = std::size_t{3} << 20, large = std::size_t{33} << 20;

unsigned char pattern(std::size_t i) {
    return static_cast<unsigned char>(i * 7 + i / 4096);
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define HAS_ALLOCATOR_OF_A_TOOL 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define HAS_ALLOCATOR_OF_A_TOOL 1
#endif
#endif

#if defined(__GLIBC__) && !defined(HAS_ALLOCATOR_OF_A_TOOL)
bool is_mapped(void* p) {
    return reinterpret_cast<std::uintptr_t>(p) % 4096 == 0;
}

// The C library maps pages for a first block of this size, or has it in its heap, ready for the
// next handle.
void set_mapped_by_library(bool is_mapped) {
    ASSERT_EQ(mallopt(M_MMAP_THRESHOLD, is_mapped ? 128 << 10 : 32 << 20), 1);
}

// Pages that the C library mapped are moved and not copied: copies would fault on each of the new
// ones. The first test, as others leave room for such a block in the heap.
TEST(Memory, MappedBlocksGrowWithoutACopy) {
    if (is_small()) GTEST_SKIP() << "tools have an allocator of their own";
    set_mapped_by_library(true);
    const auto faults = [] {
        rusage usage;
        getrusage(RUSAGE_SELF, &usage);
        return usage.ru_minflt;
    };
    Allocator allocator;
    const std::size_t bytes = 8 * medium, grown = 20 * medium;
    auto* p = static_cast<unsigned char*>(allocator.allocate(bytes, 64));
    for (std::size_t i = 0; i < bytes; ++i) p[i] = pattern(i);
    const long before = faults();
    p = static_cast<unsigned char*>(allocator.reallocate(p, bytes, bytes, grown, 64));
    EXPECT_LT(faults() - before, 100);
    EXPECT_EQ(allocator.bytes(), grown);
    EXPECT_EQ(allocator.peak(), grown);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < bytes; ++i) wrong += p[i] != pattern(i);
    EXPECT_EQ(wrong, 0u);
    allocator.release(p, grown, 64);
}

// A block from the heap that takes another's place is mapped by itself.
TEST(Memory, BlocksOfTheHeapThatMoveAreMapped) {
    if (is_small()) GTEST_SKIP() << "tools have an allocator of their own";
    set_mapped_by_library(false);
    Allocator allocator;
    void* p = allocator.allocate(medium, 64);
    EXPECT_FALSE(is_mapped(p));
    p = allocator.reallocate(p, medium, medium, 2 * medium, 64);
    EXPECT_TRUE(is_mapped(p));
    p = allocator.reallocate(p, 2 * medium, medium, medium, 64);
    EXPECT_TRUE(is_mapped(p));
    allocator.release(p, medium, 64);
    p = allocator.allocate(2 * medium, 64);
    EXPECT_FALSE(is_mapped(p));
    p = allocator.reallocate(p, 2 * medium, medium, medium, 64);
    EXPECT_TRUE(is_mapped(p));
    allocator.release(p, medium, 64);
    p = allocator.allocate(large, 64);
    EXPECT_TRUE(is_mapped(p));
    allocator.release(p, large, 64);
}
#endif

// Of any size to any other and to a third, what was in the block stays, and its alignment.
TEST(Memory, BlocksKeepWhatIsInThem) {
    std::vector<std::size_t> sizes;
    for (const std::size_t about : {small, medium / 3, medium, large - medium, large})
        for (const std::size_t more : {0u, 1u, 64u}) sizes.push_back(about + more);
    // Under tools that take ten times as long, what nearly all blocks have.
    std::vector<std::size_t> aligns = {64};
    if (!is_small()) aligns = {8, 64, 4096, 8192};
    for (const std::size_t align : aligns)
        for (const std::size_t first : sizes)
            for (const std::size_t second : {small, medium, large}) {
                Allocator allocator;
                std::size_t bytes = first;
                auto* p = static_cast<unsigned char*>(allocator.allocate(bytes, align));
                for (std::size_t i = 0; i < bytes; ++i) p[i] = pattern(i);
                std::size_t kept = bytes;
                for (const std::size_t next : {second, first + 100}) {
                    p = static_cast<unsigned char*>(
                        allocator.reallocate(p, bytes, kept, next, align));
                    bytes = next;
                    kept = std::min(kept, bytes);
                    ASSERT_EQ(reinterpret_cast<std::uintptr_t>(p) % align, 0u);
                    ASSERT_EQ(allocator.bytes(), bytes);
                    allocator.prefault(p + bytes / 2, bytes - bytes / 2, bytes, align);
                    std::size_t wrong = 0;
                    for (std::size_t i = 0; i < kept; ++i) wrong += p[i] != pattern(i);
                    ASSERT_EQ(wrong, 0u) << first << ' ' << second << ' ' << align;
                    p[bytes - 1] = 1;
                    kept = std::min(kept, bytes - 1);
                }
                allocator.release(p, bytes, align);
                ASSERT_EQ(allocator.bytes(), 0u);
            }
}

#if defined(__linux__)
// Where there is a limit, growth needs room for what is added alone.
TEST(Memory, BlocksGrowUpToTheLimit) {
    Allocator allocator;
    allocator.set_limit(2 * medium);
    void* p = allocator.allocate(medium + 4096, 64);
    p = allocator.reallocate(p, medium + 4096, medium, 2 * medium, 64);
    EXPECT_EQ(allocator.peak(), 2 * medium);
    EXPECT_THROW(allocator.reallocate(p, 2 * medium, medium, 2 * medium + 1, 64), std::bad_alloc);
    allocator.release(p, 2 * medium, 64);
}
#endif

}  // namespace
}  // namespace mgdt
