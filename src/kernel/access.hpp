// SPDX-License-Identifier: MIT
// How an insertion has access to the mesh: alone, or as one of several threads. The walk, the
// cavity and the star are compiled for each.
#pragma once

#include <mutex>

#include "mesh/mesh.hpp"
#include "parallel/blocks.hpp"

namespace mgdt {

// The mesh's storage while several threads insert: it stays where it is, and slots are taken from
// it a stretch at a time.
class SlotSupply {
  public:
    SlotSupply(Mesh& mesh, std::uint32_t slots_at_once)
        : mesh_(mesh), slots_at_once_(slots_at_once) {}
    // Before the threads start, and when they are done.
    void open() noexcept;
    void close() noexcept;

    struct Stretch {
        TetId begin, end;
    };
    // Of `least` slots or more; throws NoSlots where there are not so many.
    struct NoSlots {};
    Stretch take(std::size_t least);
    // How many that may be.
    std::size_t most(std::size_t least) const noexcept {
        return least > slots_at_once_ ? least : slots_at_once_;
    }
    // Makes sure that the mesh can list so many more free slots at the end.
    void promise(std::size_t more);
    // Moves free slots of the mesh to a list that has room for so many, which were promised.
    void take_free(Buffer<TetId>& list, std::size_t most) noexcept;

  private:
    Mesh& mesh_;
    std::atomic<TetId> next_{0};
    const std::uint32_t slots_at_once_;
    std::mutex mutex_;
    std::size_t promised_ = 0;
};

// What a thread among others needs of its own: blocks of vertices, and slots that no other takes.
class Territory {
  public:
    Territory(Mesh& mesh, BlockOwners& owners, std::uint8_t who, SlotSupply& supply)
        : claim(mesh.vertices.allocator(), owners, who),
          mesh_(mesh),
          supply_(supply),
          free_slots_(mesh.vertices.allocator()) {}

    // Whether a vertex, or a tetrahedron of these vertices, is mine, now if not before.
    MGDT_ALWAYS_INLINE bool enter(VertexId v) noexcept {
        return MGDT_LIKELY(claim.owns(v)) || claim.take(v);
    }
    MGDT_ALWAYS_INLINE bool enter(const VertexId v[4]) noexcept {
        return enter(v[0]) && enter(v[1] & ~in_cavity);
    }
    // Whether those neighbours of one of mine whose bits are set are mine. The guard of the facet
    // that they are reached through is; the other one is looked up for all four, without branches.
    MGDT_ALWAYS_INLINE bool enter(const Tetrahedron* tetrahedra, const FacetCode* neighbors,
                                  std::uint32_t bits) noexcept {
        VertexId other[4];
        std::uint32_t foreign = 0;
        for (unsigned k = 0; k < 4; ++k) {
            const FacetCode code = neighbors[k];
            other[k] = tetrahedra[code >> 2].v[(code & 3) != 0] & ~in_cavity;
            foreign |= std::uint32_t{!claim.owns(other[k])} << k;
        }
        foreign &= bits;
        if (MGDT_LIKELY(foreign == 0)) return true;
        for (unsigned k = 0; k < 4; ++k)
            if ((foreign >> k & 1) && !enter(other[k])) return false;
        return true;
    }

    // As those of Mesh; may throw SlotSupply::NoSlots.
    MGDT_ALWAYS_INLINE void reserve_slots(std::size_t taken, std::size_t freed) {
        if (MGDT_UNLIKELY(taken > slots_left() || slots_left() + freed > most_free_))
            grow_slots(taken, freed);
    }
    MGDT_ALWAYS_INLINE void take_slots(TetId* slots, std::size_t count) noexcept {
        while (count > 0 && !free_slots_.empty()) {
            *slots++ = free_slots_.back();
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
    // Hands the slots that are left to the mesh, when the threads are done and the supply is
    // closed.
    void settle() noexcept;

    Claim claim;
    std::int64_t ghosts = 0;         // made, less those removed
    TetId a_ghost = no_tetrahedron;  // the last one made

  private:
    std::size_t slots_left() const noexcept { return free_slots_.size() + (end_ - fresh_); }
    void grow_slots(std::size_t taken, std::size_t freed);

    Mesh& mesh_;
    SlotSupply& supply_;
    Buffer<TetId> free_slots_;
    TetId fresh_ = 0, end_ = 0;  // slots that were never used
    std::size_t most_free_ = 0;  // slots left that there is room to list
};

// The whole mesh is mine.
struct Alone {
    static constexpr bool is_shared = false;
    MGDT_ALWAYS_INLINE bool enter(const Tetrahedron&) const noexcept { return true; }
    MGDT_ALWAYS_INLINE bool enter(const FacetCode*, std::uint32_t) const noexcept { return true; }
    MGDT_ALWAYS_INLINE void reserve_slots(std::size_t taken, std::size_t freed) const {
        mesh.reserve_slots(taken, freed);
    }
    MGDT_ALWAYS_INLINE void take_slots(TetId* slots, std::size_t count) const noexcept {
        mesh.take_slots(slots, count);
    }
    MGDT_ALWAYS_INLINE void free_slot(TetId t) const noexcept { mesh.free_slot(t); }
    MGDT_ALWAYS_INLINE void count_ghosts(std::size_t made, std::size_t gone) const noexcept {
        mesh.ghost_count = mesh.ghost_count + made - gone;
    }
    MGDT_ALWAYS_INLINE void made_ghost(TetId t) const noexcept { mesh.a_ghost = t; }
    MGDT_ALWAYS_INLINE void set_near(VertexId v, TetId t) const noexcept { mesh.near[v] = t; }
    Mesh& mesh;
};

// Other threads insert too.
struct Shared {
    static constexpr bool is_shared = true;
    MGDT_ALWAYS_INLINE bool enter(const Tetrahedron& t) const noexcept {
        return territory.enter(t.v);
    }
    MGDT_ALWAYS_INLINE bool enter(const FacetCode* neighbors, std::uint32_t bits) const noexcept {
        return territory.enter(mesh.tetrahedra.data(), neighbors, bits);
    }
    MGDT_ALWAYS_INLINE void reserve_slots(std::size_t taken, std::size_t freed) const {
        territory.reserve_slots(taken, freed);
    }
    MGDT_ALWAYS_INLINE void take_slots(TetId* slots, std::size_t count) const noexcept {
        territory.take_slots(slots, count);
    }
    MGDT_ALWAYS_INLINE void free_slot(TetId t) const noexcept { territory.free_slot(t); }
    MGDT_ALWAYS_INLINE void count_ghosts(std::size_t made, std::size_t gone) const noexcept {
        territory.ghosts += static_cast<std::int64_t>(made) - static_cast<std::int64_t>(gone);
    }
    MGDT_ALWAYS_INLINE void made_ghost(TetId t) const noexcept { territory.a_ghost = t; }
    MGDT_ALWAYS_INLINE void set_near(VertexId v, TetId t) const noexcept {
        if (territory.claim.owns(v)) mesh.near[v] = t;
    }
    Mesh& mesh;
    Territory& territory;
};

}  // namespace mgdt
