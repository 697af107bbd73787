// SPDX-License-Identifier: MIT
// The thread-local state of an insertion by several threads: blocks of vertices that the thread
// owns, a supply of slots, and the marks of its cavity.
#pragma once

#include <mutex>

#include "mesh/mesh.hpp"
#include "parallel/block_ownership.hpp"

namespace mgdt {

// The supply of slots of a mesh while several threads insert. The storage of the mesh is not moved,
// and each thread takes a range of slots at a time.
class SlotSupply {
  public:
    SlotSupply(Mesh& mesh, std::uint32_t slots_at_once)
        : mesh_(mesh), slots_at_once_(slots_at_once) {}
    // open() is called before the threads start, and close() after they have ended.
    void open() noexcept;
    void close() noexcept;

    struct SlotRange {
        TetId begin, end;
    };
    // take() takes a range of at least `least` slots. It throws NoSlots if there are fewer.
    struct NoSlots {};
    SlotRange take(std::size_t least);
    // The largest range that take(least) may return.
    std::size_t most(std::size_t least) const noexcept {
        return least > slots_at_once_ ? least : slots_at_once_;
    }
    // Reserves room for `more` further slots in the mesh's list of free slots.
    void promise(std::size_t more);
    // Moves at most `most` free slots of the mesh to `list`, which must have room for them.
    void take_free(Buffer<TetId>& list, std::size_t most) noexcept;

  private:
    Mesh& mesh_;
    Atomic<TetId> next_{0};
    const std::uint32_t slots_at_once_;
    std::mutex mutex_;
    std::size_t promised_ = 0;
};

// The set of tetrahedra in the cavity of a thread. Marks in the tetrahedra themselves would be seen
// by other threads, which may test the same tetrahedra.
//
// The set is a hash table with entries of 32 bits. The lowest bits of a tetrahedron's number are
// its position in the table; the other bits are in the entry, below the stamp of the insertion.
// Entries with an older stamp are free, so the table need not be cleared. There is no probing: if
// two tetrahedra of a cavity have the same position, the second one goes to a list.
class MarkTable {
  public:
    explicit MarkTable(Allocator& allocator) noexcept
        : entries_(allocator), displaced_(allocator) {}
    // Empties the set and makes room for `members`. The table shrinks, too, because entries that
    // are spread over a large table would not stay in the cache.
    MGDT_ALWAYS_INLINE void begin(std::size_t members) {
        view_.stamp += one_stamp;
        view_.mask = least - 1;
        view_.position_bits = least_bits;
        displaced_count_ = 0;
        if (MGDT_UNLIKELY(4 * members > least || entries_.empty() || view_.stamp == 0))
            resize(members);
    }
    // Makes room for more members. The first `marked` of `codes` are in the set.
    void grow(std::size_t members, const FacetCode* codes, std::size_t marked);
    // The number of members that there is room for.
    MGDT_ALWAYS_INLINE std::size_t capacity() const noexcept {
        return (std::size_t{view_.mask} + 1) / 4;
    }
    static constexpr std::size_t least_capacity = 256;
    static constexpr unsigned stamp_shift = 20;

    // A view of the set. A local copy stays in registers while entries are written.
    struct View {
        bool has(TetId t) const noexcept;
        // Adds t if `is_in` is 1. Returns 1 if t was not in the set, whatever `is_in` is.
        MGDT_ALWAYS_INLINE std::uint32_t put(TetId t, std::uint32_t is_in) const noexcept {
            std::uint32_t& entry = data[t & mask];
            const std::uint32_t key = key_of(t), there = entry;
            if (MGDT_UNLIKELY(is_collision(there, key))) return put_displaced(t, is_in);
            entry = there ^ ((there ^ key) & (0 - is_in));
            return there != key;
        }
        MGDT_ALWAYS_INLINE std::uint32_t key_of(TetId t) const noexcept {
            return stamp | t >> position_bits;
        }
        // Whether an entry of the current stamp has another tetrahedron.
        static bool is_collision(std::uint32_t entry, std::uint32_t key) noexcept {
            return entry != key && (entry ^ key) >> stamp_shift == 0;
        }

        std::uint32_t* data = nullptr;
        std::uint32_t mask = 0;
        unsigned position_bits = 0;
        std::uint32_t stamp = 0;

      private:
        friend class MarkTable;
        bool is_displaced(TetId t) const noexcept;
        std::uint32_t put_displaced(TetId t, std::uint32_t is_in) const noexcept;

        TetId* displaced = nullptr;
        std::uint32_t* displaced_count = nullptr;
    };
    MGDT_ALWAYS_INLINE View view() const noexcept { return view_; }

  private:
    // Makes a table for `members` that has no entries of the current stamp.
    void resize(std::size_t members);

    static constexpr unsigned least_bits = 10;
    static constexpr std::size_t least = std::size_t{1} << least_bits;
    static_assert(least == 4 * least_capacity);
    static constexpr std::uint32_t one_stamp = std::uint32_t{1} << stamp_shift;
    static_assert((std::uint64_t{max_tetrahedra} - 1) >> least_bits < one_stamp);

    Buffer<std::uint32_t> entries_;
    Buffer<TetId> displaced_;  // room for every member
    std::uint32_t displaced_count_ = 0;
    View view_;
};

// The thread-local state of one thread that inserts.
class ThreadState {
  public:
    ThreadState(Mesh& mesh, BlockOwners& owners, std::uint8_t who, SlotSupply& supply)
        : blocks(mesh.vertices.allocator(), owners, who),
          marks(mesh.vertices.allocator()),
          mesh_(mesh),
          supply_(supply),
          free_slots_(mesh.vertices.allocator()) {}

    // Acquires a vertex, or both guards of a tetrahedron. Returns false if another thread owns a
    // vertex that is needed.
    bool try_own(VertexId v) noexcept { return blocks.mine()(v) || blocks.try_own(v); }
    bool try_own(const Tetrahedron& t) noexcept { return try_own(t.v[0]) && try_own(t.v[1]); }
    // Like the functions of Mesh with these names. reserve_slots() also throws SlotSupply::NoSlots.
    MGDT_ALWAYS_INLINE void reserve_slots(std::size_t taken, std::size_t freed) {
        if (MGDT_UNLIKELY(taken > slots_left() || slots_left() + freed > most_free_))
            grow_slots(taken, freed);
    }
    MGDT_ALWAYS_INLINE void take_slots(FacetCode* slots, std::size_t count) noexcept {
        while (count > 0 && !free_slots_.empty()) {
            *slots++ = first_facet(free_slots_.back());
            free_slots_.pop_back();
            --count;
        }
        write_run(slots, fresh_, count);
        fresh_ += static_cast<TetId>(count);
    }
    MGDT_ALWAYS_INLINE void free_slot(TetId t) noexcept {
        const std::size_t size = free_slots_.size();
        free_slots_.resize_within_capacity(size + 1);
        free_slots_[size] = t;
        mesh_.tetrahedra[t].kill();
    }
    MGDT_ALWAYS_INLINE void count_ghosts(std::size_t made, std::size_t gone) noexcept {
        ghosts += static_cast<std::int64_t>(made) - static_cast<std::int64_t>(gone);
    }
    // Gives the remaining slots to the mesh, after the threads have ended and the supply is closed.
    void return_slots() noexcept;

    OwnedBlocks blocks;
    MarkTable marks;
    std::int64_t ghosts = 0;         // ghosts created minus ghosts removed
    TetId a_ghost = no_tetrahedron;  // the newest ghost

  private:
    MGDT_ALWAYS_INLINE std::size_t slots_left() const noexcept {
        return free_slots_.size() + (end_ - fresh_);
    }
    void grow_slots(std::size_t taken, std::size_t freed);

    Mesh& mesh_;
    SlotSupply& supply_;
    Buffer<TetId> free_slots_;
    TetId fresh_ = 0, end_ = 0;  // the range of slots that were never used
    std::size_t most_free_ =
        0;  // the number of remaining slots that can be listed without allocation
};

}  // namespace mgdt
