// SPDX-License-Identifier: MIT
// How an insertion has access to the mesh: alone, or as one of several threads, in a zone of its
// own or among the others; with spheres that are kept, or computed whenever they are wanted. The
// walk, the cavity and the star are compiled for each.
#pragma once

#include "kernel/island.hpp"
#include "kernel/sphere_source.hpp"
#include "kernel/thread_state.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// The whole mesh is mine.
template <class Spheres>
struct SerialAccess {
    using SphereSource = Spheres;
    static constexpr bool is_alone = true, has_mark_table = false;
    MGDT_ALWAYS_INLINE bool try_own(const Tetrahedron&) const noexcept { return true; }
    bool owns(VertexId) const noexcept { return true; }
    MGDT_ALWAYS_INLINE void reserve_slots(std::size_t taken, std::size_t freed) const {
        mesh.reserve_slots(taken, freed);
    }
    MGDT_ALWAYS_INLINE void take_slots(FacetCode* slots, std::size_t count) const noexcept {
        mesh.take_slots(slots, count);
    }
    MGDT_ALWAYS_INLINE void free_slot(TetId t) const noexcept { mesh.free_slot(t); }
    MGDT_ALWAYS_INLINE void count_ghosts(std::size_t made, std::size_t gone) const noexcept {
        mesh.ghost_count = mesh.ghost_count + made - gone;
    }
    MGDT_ALWAYS_INLINE void made_ghost(TetId t) const noexcept { mesh.a_ghost = t; }
    MGDT_ALWAYS_INLINE void set_vertex_hint(VertexId v, TetId t) const noexcept {
        mesh.vertex_hint[v] = t;
    }
    Mesh& mesh;
};

// Other threads insert too, in zones of their own. Tetrahedra of which some vertices are in one
// zone and some in another are closed: they stay, their spheres leave every test open, and a thread
// may read them, and write their links to its own. All others that it comes to are its own alone,
// since two neighbours have three vertices in common.
class ZoneAccess {
  public:
    using SphereSource = KeptSpheres;
    static constexpr bool is_alone = false, has_mark_table = false;

    MGDT_ALWAYS_INLINE ZoneAccess(Mesh& mesh, ThreadState& thread_state) noexcept
        : mesh_(mesh), thread_state_(thread_state) {}

    MGDT_ALWAYS_INLINE bool try_own(const Tetrahedron& t) const noexcept {
        return !TetrahedronStore::sphere_of(t).is_closed();
    }
    bool owns(VertexId) const noexcept { return true; }
    MGDT_ALWAYS_INLINE void reserve_slots(std::size_t taken, std::size_t freed) const {
        thread_state_.reserve_slots(taken, freed);
    }
    MGDT_ALWAYS_INLINE void take_slots(FacetCode* slots, std::size_t count) const noexcept {
        thread_state_.take_slots(slots, count);
    }
    MGDT_ALWAYS_INLINE void free_slot(TetId t) const noexcept { thread_state_.free_slot(t); }
    MGDT_ALWAYS_INLINE void count_ghosts(std::size_t made, std::size_t gone) const noexcept {
        thread_state_.count_ghosts(made, gone);
    }
    MGDT_ALWAYS_INLINE void made_ghost(TetId t) const noexcept { thread_state_.a_ghost = t; }
    // All vertices of a star are in one zone, but for the one at infinity, which is in each.
    MGDT_ALWAYS_INLINE void set_vertex_hint(VertexId v, TetId t) const noexcept {
        if (v != infinite_vertex) mesh_.vertex_hint[v] = t;
    }

  private:
    Mesh& mesh_;
    ThreadState& thread_state_;
};

// Other threads insert wherever they are.
template <class Spheres>
class ConcurrentAccess {
  public:
    using SphereSource = Spheres;
    static constexpr bool is_alone = false, has_mark_table = true;

    MGDT_ALWAYS_INLINE ConcurrentAccess(Mesh& mesh, ThreadState& thread_state) noexcept
        : mesh_(mesh), thread_state_(thread_state), mine_(thread_state.blocks.mine()) {}

    // Whether a vertex, or a tetrahedron, is mine, now if not before.
    MGDT_ALWAYS_INLINE bool try_own(VertexId v) const noexcept {
        return MGDT_LIKELY(mine_(v)) || thread_state_.blocks.try_own(v);
    }
    MGDT_ALWAYS_INLINE bool try_own(const Tetrahedron& t) const noexcept {
        return try_own(t.v[0]) && try_own(t.v[1]);
    }
    bool owns(VertexId v) const noexcept { return mine_(v); }
    MGDT_ALWAYS_INLINE void reserve_slots(std::size_t taken, std::size_t freed) const {
        thread_state_.reserve_slots(taken, freed);
    }
    MGDT_ALWAYS_INLINE void take_slots(FacetCode* slots, std::size_t count) const noexcept {
        thread_state_.take_slots(slots, count);
    }
    MGDT_ALWAYS_INLINE void free_slot(TetId t) const noexcept { thread_state_.free_slot(t); }
    MGDT_ALWAYS_INLINE void count_ghosts(std::size_t made, std::size_t gone) const noexcept {
        thread_state_.count_ghosts(made, gone);
    }
    MGDT_ALWAYS_INLINE void made_ghost(TetId t) const noexcept { thread_state_.a_ghost = t; }
    MGDT_ALWAYS_INLINE void set_vertex_hint(VertexId v, TetId t) const noexcept {
        if (mine_(v)) mesh_.vertex_hint[v] = t;
    }

    MGDT_ALWAYS_INLINE MarkTable& marks() const noexcept { return thread_state_.marks; }

  private:
    Mesh& mesh_;
    ThreadState& thread_state_;
    const OwnedBlocks::Mine mine_;
};

// Nothing is changed: what an insertion would remove is found, as it is among other threads.
template <class Spheres>
struct ReadingAccess {
    using SphereSource = Spheres;
    static constexpr bool is_alone = false, has_mark_table = true;
    MGDT_ALWAYS_INLINE bool try_own(const Tetrahedron&) const noexcept { return true; }
    MGDT_ALWAYS_INLINE MarkTable& marks() const noexcept { return table; }
    MarkTable& table;
};

}  // namespace MGDT_ISLAND
}  // namespace mgdt
