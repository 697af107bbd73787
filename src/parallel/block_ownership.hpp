// SPDX-License-Identifier: MIT
// Ownership: which thread may change which tetrahedra while several threads insert.
//
// A vertex is owned by one thread or by none. Ownership comes in blocks of vertices that are
// consecutive in the order of insertion, and so near each other. The *guard* of a facet is its
// newest vertex; the thread that owns the guard owns the facet. The four facets of a tetrahedron
// have two guards: its newest vertex, v[0], and the second newest, v[1] (mesh/tetrahedron.hpp). A
// thread may change a tetrahedron only if it owns both guards, and with them all four facets. Then
// plain loads and stores suffice:
//
// - A neighbour of a tetrahedron that thread T owns shares a facet with it, so T owns one of the
//   neighbour's guards, and no other thread can change the neighbour. T may test it without owning
//   both guards, and may write its neighbour entry at the shared facet. Insertion tests no other
//   tetrahedra.
// - A new tetrahedron consists of the new vertex, which T owns, and a facet that T owns. So T owns
//   the new tetrahedron.
// - Releasing a block publishes the writes of its owner. The next owner acquires the block before
//   it accesses the tetrahedra that were written.
//
// The vertex at infinity is older than all others and guards nothing. A vertex of an early round
// has tetrahedra in many places, but guards few of them. A thread keeps its blocks for several
// insertions in the same place, so acquiring them costs little. No thread waits for a block: a
// point that needs a block of another thread is deferred.
#pragma once

#include <cstdint>

#include "parallel/atomic_array.hpp"
#include "platform/memory.hpp"

namespace mgdt {

class BlockOwners {
  public:
    // A table of the owners of items 0 to n - 1, where no item has an owner yet. `pause` is a hook
    // for tests: a function that is called before a block is acquired and after blocks are
    // released, or null.
    BlockOwners(Allocator& allocator, std::size_t n, void (*pause)());
    BlockOwners(const BlockOwners&) = delete;
    BlockOwners& operator=(const BlockOwners&) = delete;

  private:
    friend class OwnedBlocks;
    static constexpr std::uint8_t nobody = 0;
    // A block has 8 items, or up to 256 if the table would not fit into the cache otherwise.
    static constexpr unsigned least_shift = 3, most_shift = 8;
    static constexpr std::size_t most_blocks = std::size_t{1} << 19;

    static unsigned shift_for(std::size_t n) noexcept;

    void (*const pause_)();
    const unsigned shift_;
    AtomicArray<std::uint8_t> owners_;  // the owner of each block
};

// The blocks of one thread.
class OwnedBlocks {
  public:
    // `who` identifies the thread: 1 to 254, different for each thread.
    OwnedBlocks(Allocator& allocator, BlockOwners& owners, std::uint8_t who) noexcept;
    OwnedBlocks(const OwnedBlocks&) = delete;
    OwnedBlocks& operator=(const OwnedBlocks&) = delete;
    ~OwnedBlocks();

    // Tells whether this thread owns an item. The object has copies of the members, so that the
    // compiler can keep them in registers while other memory is written.
    struct Mine {
        MGDT_ALWAYS_INLINE bool operator()(std::uint32_t item) const noexcept {
            return owners[item >> shift].load(std::memory_order_relaxed) == who;
        }
        const Atomic<std::uint8_t>* owners;
        unsigned shift;
        std::uint8_t who;
    };
    MGDT_ALWAYS_INLINE Mine mine() const noexcept { return {owners_, shift_, who_}; }
    // Acquires the block of an item that this thread does not own. Returns false if another thread
    // owns the block, or if no memory is left to record it.
    bool try_own(std::uint32_t item) noexcept;
    // Releases all blocks but those of the `kept` items.
    void release(const std::uint32_t* kept = nullptr, std::size_t count = 0) noexcept;

  private:
    Atomic<std::uint8_t>* const owners_;
    const unsigned shift_;
    const std::uint8_t who_;
    void (*const pause_)();
    Buffer<std::uint32_t> blocks_;
};

}  // namespace mgdt
