// SPDX-License-Identifier: MIT
// Which thread may change what while several threads insert.
//
// Every vertex is owned by one thread or by none, together with a block of vertices next to it in
// the order of insertion, which lie near it. The guard of a facet is the newest of its vertices:
// the thread that owns the guard owns the facet. The facets of a tetrahedron have two guards among
// them, its newest vertex, v[0], and the newest of the other three, which is v[1]
// (mesh/tetrahedron.hpp). The rule: a thread that changes a tetrahedron owns both guards, and with
// them all its facets. It follows that plain loads and stores are enough:
//
// - The neighbour of a tetrahedron that is mine has a facet of mine, hence one of its guards is
//   mine, and no other thread can change it: it may be tested without owning both. Insertions test
//   no others. Its link through our facet is mine to write.
// - A new tetrahedron joins the new vertex, which is mine, to a facet of mine: it is mine.
// - Giving a block back publishes what was written to the thread that takes it next, which must
//   own the block before it reads or writes any of that.
//
// The vertex at infinity is older than all others and guards nothing. A vertex of early rounds,
// with tetrahedra far and wide, guards few of them. Blocks are kept for some insertions in one
// place, so taking them costs little. Nobody waits for a block: a point that needs one of another
// thread's is put off.
#pragma once

#include <cstdint>

#include "parallel/atomic_array.hpp"
#include "platform/memory.hpp"

namespace mgdt {

class BlockOwners {
  public:
    // Of items 0..n-1, all free. `pause`, if there is one, is called where threads may meet.
    BlockOwners(Allocator& allocator, std::size_t n, void (*pause)());
    BlockOwners(const BlockOwners&) = delete;
    BlockOwners& operator=(const BlockOwners&) = delete;

  private:
    friend class OwnedBlocks;
    static constexpr std::uint8_t nobody = 0;
    // Blocks of 8 items; larger ones where the table would not stay in the cache.
    static constexpr unsigned least_shift = 3, most_shift = 8;
    static constexpr std::size_t most_blocks = std::size_t{1} << 19;

    static unsigned shift_for(std::size_t n) noexcept;

    void (*const pause_)();
    const unsigned shift_;
    AtomicArray<std::uint8_t> owners_;  // by block
};

// The blocks of one thread.
class OwnedBlocks {
  public:
    // `who`: 1 to 254, another one for each thread.
    OwnedBlocks(Allocator& allocator, BlockOwners& owners, std::uint8_t who) noexcept;
    OwnedBlocks(const OwnedBlocks&) = delete;
    OwnedBlocks& operator=(const OwnedBlocks&) = delete;
    ~OwnedBlocks();

    // To look up what is mine, by value: nothing that is written elsewhere can change it.
    struct Mine {
        MGDT_ALWAYS_INLINE bool operator()(std::uint32_t item) const noexcept {
            return owners[item >> shift].load(std::memory_order_relaxed) == who;
        }
        const Atomic<std::uint8_t>* owners;
        unsigned shift;
        std::uint8_t who;
    };
    MGDT_ALWAYS_INLINE Mine mine() const noexcept { return {owners_, shift_, who_}; }
    // Takes the block of an item that is not mine, unless somebody has it.
    bool try_own(std::uint32_t item) noexcept;
    // Gives back all but the blocks of some items.
    void release(const std::uint32_t* kept = nullptr, std::size_t count = 0) noexcept;

  private:
    Atomic<std::uint8_t>* const owners_;
    const unsigned shift_;
    const std::uint8_t who_;
    void (*const pause_)();
    Buffer<std::uint32_t> blocks_;
};

}  // namespace mgdt
