// SPDX-License-Identifier: MIT
// Policies of access to the mesh: by one thread alone, by one of several threads in its zone, or by
// one of several threads anywhere; each with stored spheres or with spheres that are computed on
// demand. One more is for meshes with walls, where a cavity is looked at before it is filled. The
// walk, the cavity and the star are templates, and compiled for each policy.
#pragma once

#include "kernel/island.hpp"
#include "kernel/kernel.hpp"
#include "kernel/sphere_source.hpp"
#include "kernel/thread_state.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// One thread has the whole mesh.
template <class Spheres>
struct SerialAccess {
    using SphereSource = Spheres;
    static constexpr bool is_alone = true, has_mark_table = false, has_walls = false;
    MGDT_ALWAYS_INLINE bool try_own(const Tetrahedron&) const noexcept { return true; }
    bool owns(const Tetrahedron&) const noexcept { return true; }
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

// The common part of both policies for several threads: slots and ghost counts are thread-local.
class SharedAccess {
  public:
    static constexpr bool is_alone = false, has_walls = false;

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

  protected:
    MGDT_ALWAYS_INLINE SharedAccess(Mesh& mesh, ThreadState& thread_state) noexcept
        : mesh_(mesh), thread_state_(thread_state) {}

    Mesh& mesh_;
    ThreadState& thread_state_;
};

// Access in a zone, while tetrahedra between zones are closed. Every tetrahedron that the thread
// reaches belongs to this thread unless it is closed. The thread may read a closed tetrahedron, and
// may write its neighbour entry at a facet of the zone.
class ZoneAccess : public SharedAccess {
  public:
    using SphereSource = KeptSpheres;
    static constexpr bool has_mark_table = false;

    MGDT_ALWAYS_INLINE ZoneAccess(Mesh& mesh, ThreadState& thread_state) noexcept
        : SharedAccess(mesh, thread_state) {}

    MGDT_ALWAYS_INLINE bool try_own(const Tetrahedron& t) const noexcept {
        return !TetrahedronStore::sphere_of(t).is_closed();
    }
    bool owns(const Tetrahedron& t) const noexcept { return try_own(t); }
    // All vertices of a star are in one zone, except for the vertex at infinity, which is in every
    // zone and gets no hint.
    MGDT_ALWAYS_INLINE void set_vertex_hint(VertexId v, TetId t) const noexcept {
        if (v != infinite_vertex) mesh_.vertex_hint[v] = t;
    }
};

// Access anywhere in the mesh: the thread may change a tetrahedron whose guards it owns.
template <class Spheres>
class ConcurrentAccess : public SharedAccess {
  public:
    using SphereSource = Spheres;
    static constexpr bool has_mark_table = true;

    MGDT_ALWAYS_INLINE ConcurrentAccess(Mesh& mesh, ThreadState& thread_state) noexcept
        : SharedAccess(mesh, thread_state), mine_(thread_state.blocks.mine()) {}

    // Acquires a vertex, or the guards of a tetrahedron. Returns false if another thread owns a
    // vertex that is needed.
    MGDT_ALWAYS_INLINE bool try_own(VertexId v) const noexcept {
        return MGDT_LIKELY(mine_(v)) || thread_state_.blocks.try_own(v);
    }
    MGDT_ALWAYS_INLINE bool try_own(const Tetrahedron& t) const noexcept {
        return try_own(t.v[0]) && try_own(t.v[1]);
    }
    // Whether this thread owns the tetrahedron already.
    bool owns(const Tetrahedron& t) const noexcept {
        return mine_(t.v[0]) && mine_(unmarked(t.v[1]));
    }
    MGDT_ALWAYS_INLINE void set_vertex_hint(VertexId v, TetId t) const noexcept {
        if (mine_(v)) mesh_.vertex_hint[v] = t;
    }

    MGDT_ALWAYS_INLINE MarkTable& marks() const noexcept { return thread_state_.marks; }

  private:
    const OwnedBlocks::Mine mine_;
};

// Read-only access, which finds the cavity that an insertion would have. Several threads may read
// one mesh at the same time.
template <class Spheres>
struct ReadingAccess {
    using SphereSource = Spheres;
    static constexpr bool is_alone = false, has_mark_table = true, has_walls = false;
    MGDT_ALWAYS_INLINE bool try_own(const Tetrahedron&) const noexcept { return true; }
    MGDT_ALWAYS_INLINE MarkTable& marks() const noexcept { return table; }
    MarkTable& table;
};

// Access of one of several threads in its zone of a mesh with walls, which are faces that no cavity
// grows through. Bit i of walls[t] says whether face i of tetrahedron t is one. Tetrahedra between
// zones are closed, as for ZoneAccess. Slots come from a stack, and vertices get no hints.
class WalledAccess {
  public:
    using SphereSource = KeptSpheres;
    static constexpr bool is_alone = false, has_mark_table = false, has_walls = true;

    WalledAccess(Mesh& mesh, const std::uint8_t* walls, TetId** slots) noexcept
        : mesh_(mesh), walls_(walls), slots_(slots) {}

    MGDT_ALWAYS_INLINE bool try_own(const Tetrahedron& t) const noexcept {
        return !TetrahedronStore::sphere_of(t).is_closed();
    }
    bool owns(const Tetrahedron& t) const noexcept { return try_own(t); }
    // The faces of a member of a cavity that are walls.
    MGDT_ALWAYS_INLINE std::uint32_t walls_of(FacetCode member) const noexcept {
        return walls_[tetrahedron_of(member)];
    }
    MGDT_ALWAYS_INLINE void reserve_slots(std::size_t, std::size_t) const noexcept {}
    MGDT_ALWAYS_INLINE void take_slots(FacetCode* slots, std::size_t count) const noexcept {
        for (std::size_t i = 0; i < count; ++i) slots[i] = first_facet(*--*slots_);
    }
    MGDT_ALWAYS_INLINE void free_slot(TetId t) const noexcept {
        mesh_.tetrahedra[t].kill();
        *(*slots_)++ = t;
    }
    MGDT_ALWAYS_INLINE void count_ghosts(std::size_t, std::size_t) const noexcept {}
    MGDT_ALWAYS_INLINE void made_ghost(TetId) const noexcept {}
    MGDT_ALWAYS_INLINE void set_vertex_hint(VertexId, TetId) const noexcept {}

  private:
    Mesh& mesh_;
    const std::uint8_t* const walls_;
    TetId** const slots_;  // the end of the stack
};

}  // namespace MGDT_ISLAND
}  // namespace mgdt
