// SPDX-License-Identifier: MIT
#include "platform/borrowed_arena.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <random>
#include <vector>

#include "parallel/team.hpp"

namespace {

using namespace mgdt;

struct Block {
    void* at;
    std::size_t bytes;
    unsigned char fill;
};

bool is_filled(const Block& block) {
    const auto* const bytes = static_cast<const unsigned char*>(block.at);
    for (std::size_t i = 0; i < block.bytes; ++i)
        if (bytes[i] != block.fill) return false;
    return true;
}

// Blocks of several threads come and go: each is aligned, holds what was written to it and
// overlaps no other, whether it lies in what was lent or beyond.
TEST(BorrowedArena, BlocksAreApart) {
    std::vector<unsigned char> lent(100000);
    Allocator beyond;
    BorrowedArena arena(lent.data() + 3, lent.size() - 3, beyond);
    Team team(4);
    Atomic<bool> is_good{true};
    Atomic<unsigned> inside{0}, outside{0};
    team.run(4, [&](unsigned member) {
        std::mt19937_64 random(member);
        std::vector<Block> blocks;
        for (unsigned turn = 0; turn < 4000; ++turn) {
            if (random() % 2 == 0 || blocks.empty()) {
                const std::size_t bytes = 1 + random() % 5000;
                const Block block{arena.allocator().allocate(bytes, 64), bytes,
                                  static_cast<unsigned char>(4 * turn + member)};
                std::memset(block.at, block.fill, bytes);
                if (reinterpret_cast<std::size_t>(block.at) % 64 != 0) is_good = false;
                ++(block.at >= lent.data() && block.at < lent.data() + lent.size() ? inside
                                                                                   : outside);
                blocks.push_back(block);
            } else {
                // Mostly the last one.
                const std::size_t k =
                    random() % 4 == 0 ? random() % blocks.size() : blocks.size() - 1;
                if (!is_filled(blocks[k])) is_good = false;
                arena.allocator().release(blocks[k].at, blocks[k].bytes, 64);
                blocks.erase(blocks.begin() + static_cast<std::ptrdiff_t>(k));
            }
        }
        for (const Block& block : blocks) {
            if (!is_filled(block)) is_good = false;
            arena.allocator().release(block.at, block.bytes, 64);
        }
    });
    EXPECT_TRUE(is_good);
    EXPECT_GT(inside, 0u);
    EXPECT_GT(outside, 0u);
    EXPECT_EQ(arena.allocator().bytes(), 0u);
    EXPECT_EQ(beyond.bytes(), 0u);
}

TEST(BorrowedArena, LastBlockServesAgain) {
    std::vector<unsigned char> lent(1000);
    Allocator beyond;
    BorrowedArena arena(lent.data(), lent.size(), beyond);
    for (int turn = 0; turn < 100; ++turn) {
        void* const p = arena.allocator().allocate(600, 64);
        EXPECT_EQ(beyond.bytes(), 0u);
        arena.allocator().release(p, 600, 64);
    }
}

TEST(BorrowedArena, NoMoreThanThereIs) {
    std::vector<unsigned char> lent(1000);
    Allocator beyond;
    beyond.set_limit(500);
    BorrowedArena arena(lent.data(), lent.size(), beyond);
    void* const first = arena.allocator().allocate(900, 64);
    void* const second = arena.allocator().allocate(500, 64);
    EXPECT_EQ(beyond.bytes(), 500u);
    EXPECT_THROW(arena.allocator().allocate(400, 64), std::bad_alloc);
    EXPECT_THROW(arena.allocator().allocate(static_cast<std::size_t>(-1), 64), std::bad_alloc);
    arena.allocator().release(second, 500, 64);
    arena.allocator().release(first, 900, 64);
    EXPECT_EQ(beyond.bytes(), 0u);
    EXPECT_EQ(arena.allocator().bytes(), 0u);
}

}  // namespace
