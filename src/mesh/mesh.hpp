// SPDX-License-Identifier: MIT
// The store of vertices and tetrahedra: slots, the free list and counts. It knows no geometry.
#pragma once

#include <cassert>

#include "mesh/tetrahedron_store.hpp"
#include "platform/memory.hpp"

namespace mgdt {

// Writes the first facet codes of consecutive slots, in blocks of 16, so that the branch at the end
// of the loop is predictable. The array has room for 16 more elements.
MGDT_ALWAYS_INLINE void write_run(FacetCode* slots, TetId first, std::size_t count) noexcept {
    constexpr std::size_t block = 16;
    for (std::size_t i = 0; i < count; i += block)
        for (std::size_t k = i; k < i + block; ++k)
            slots[k] = first_facet(first + static_cast<TetId>(k));
}

struct Mesh {
    explicit Mesh(Allocator& allocator)
        : vertices(allocator),
          vertex_hint(allocator),
          tetrahedra(allocator),
          free_slots(allocator) {}

    // Removes everything but the vertex at infinity. The scale stays.
    void clear();
    // Makes sure that the next `taken` slots can be taken and `freed` slots freed without
    // allocation. Throws std::bad_alloc, or MGDT_ERR_TOO_LARGE beyond max_tetrahedra, with nothing
    // changed.
    MGDT_ALWAYS_INLINE void reserve_slots(std::size_t taken, std::size_t freed) {
        if (MGDT_UNLIKELY(tetrahedra.size() + taken > prefaulted_slots + free_slots.size() ||
                          free_slots.size() + freed > free_slots.capacity()))
            grow_slots(taken, freed);
    }
    // The first live slot from t on, where slot 0 follows the last slot. The slot t of a hint may
    // be dead. After 1,000 dead slots, the result is a_ghost.
    TetId live_from(TetId t) const noexcept {
        assert(live_count() > 0 && "all tetrahedra are dead");
        for (unsigned tries = 0; tries < 1000; ++tries) {
            if (!tetrahedra[t].is_dead()) return t;
            t = t + 1 < tetrahedra.size() ? t + 1 : 0;
        }
        return a_ghost;
    }
    // Removes all tetrahedra; the vertices stay.
    void drop_tetrahedra() noexcept;
    // Gives unused storage back, if the allocator can shrink blocks.
    void shrink() noexcept;
    // Makes room for at least `count` tetrahedra, never for more than the limit.
    void reserve_tetrahedra(std::size_t count);
    // Takes slots, and writes the first facet code of each. The array has room for 16 elements more
    // than `count`.
    void take_slots(FacetCode* slots, std::size_t count) noexcept;
    void free_slot(TetId t) noexcept;

    std::size_t live_count() const noexcept {
        assert(free_slots.size() <= tetrahedra.size() && "more slots are free than there are");
        return tetrahedra.size() - free_slots.size();
    }
    std::size_t finite_count() const noexcept {
        assert(ghost_count <= live_count() && "more ghosts than tetrahedra");
        return live_count() - ghost_count;
    }
    MGDT_ALWAYS_INLINE const double* point(VertexId v) const noexcept { return vertices[v].x; }

    Buffer<Vertex> vertices;  // slot 0: the vertex at infinity
    // For each vertex, once there are tetrahedra: a slot near the vertex, or no_tetrahedron until
    // the vertex is inserted. The slot held a tetrahedron of the vertex once, and may have been
    // reused since. The hints are an array of their own, since a thread may write a hint while
    // other threads read coordinates.
    Buffer<TetId> vertex_hint;
    TetrahedronStore tetrahedra;
    Buffer<TetId> free_slots;  // slots of dead tetrahedra
    std::size_t ghost_count = 0;
    TetId a_ghost = no_tetrahedron;  // the newest ghost; removing a ghost creates a newer one
    int scale = 0;                   // coordinates carry the factor 2^scale, see mesh/scale.hpp
    // The number of slots whose pages are prefaulted. take_slots() beyond it goes through
    // grow_slots().
    std::size_t prefaulted_slots = 0;
    // Tests lower these limits. The highest bit of a vertex number is the mark in_cavity.
    std::uint32_t slot_limit = max_tetrahedra, vertex_limit = in_cavity;
    // Whether the two tetrahedra that share a facet always have the same guard (newest vertex) for
    // the facet. Removing a vertex makes this false.
    bool guards_agree = true;
    bool has_extremes = false;  // some vertex is outside the range where filters are proved

  private:
    void grow_slots(std::size_t taken, std::size_t freed);
};

MGDT_ALWAYS_INLINE void Mesh::take_slots(FacetCode* slots, std::size_t count) noexcept {
    if (MGDT_UNLIKELY(!free_slots.empty())) {
        while (count > 0 && !free_slots.empty()) {
            assert(tetrahedra[free_slots.back()].is_dead() && "a free slot is not dead");
            *slots++ = first_facet(free_slots.back());
            free_slots.pop_back();
            --count;
        }
    }
    const TetId end = static_cast<TetId>(tetrahedra.size());
    write_run(slots, end, count);
    tetrahedra.resize_within_capacity(tetrahedra.size() + count);
}

MGDT_ALWAYS_INLINE void Mesh::free_slot(TetId t) noexcept {
    const std::size_t size = free_slots.size();
    assert(size < free_slots.capacity() && "there is no room among the free slots");
    free_slots.resize_within_capacity(size + 1);
    free_slots[size] = t;
    tetrahedra[t].kill();
}

}  // namespace mgdt
