// SPDX-License-Identifier: MIT
// How an insertion has access to the mesh: alone, or as one of several threads; with spheres that
// are kept, or computed whenever they are wanted. The walk, the cavity and the star are compiled
// for each.
#pragma once

#include "kernel/isa.hpp"
#include "kernel/sphere_source.hpp"
#include "kernel/territory.hpp"

namespace mgdt {
inline namespace MGDT_ISA {

// The whole mesh is mine.
template <class Spheres>
struct Alone {
    using SphereSource = Spheres;
    static constexpr bool is_shared = false;
    MGDT_ALWAYS_INLINE bool enter(const Tetrahedron&) const noexcept { return true; }
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
    MGDT_ALWAYS_INLINE void set_near(VertexId v, TetId t) const noexcept { mesh.near[v] = t; }
    Mesh& mesh;
};

// Other threads insert too.
template <class Spheres>
class Shared {
  public:
    using SphereSource = Spheres;
    static constexpr bool is_shared = true;

    MGDT_ALWAYS_INLINE Shared(Mesh& mesh, Territory& territory) noexcept
        : mesh_(mesh), territory_(territory), mine_(territory.claim.mine()) {}

    // Whether a vertex, or a tetrahedron, is mine, now if not before.
    MGDT_ALWAYS_INLINE bool enter(VertexId v) const noexcept {
        return MGDT_LIKELY(mine_(v)) || territory_.claim.take(v);
    }
    MGDT_ALWAYS_INLINE bool enter(const Tetrahedron& t) const noexcept {
        return enter(t.v[0]) && enter(t.v[1]);
    }
    MGDT_ALWAYS_INLINE void reserve_slots(std::size_t taken, std::size_t freed) const {
        territory_.reserve_slots(taken, freed);
    }
    MGDT_ALWAYS_INLINE void take_slots(FacetCode* slots, std::size_t count) const noexcept {
        territory_.take_slots(slots, count);
    }
    MGDT_ALWAYS_INLINE void free_slot(TetId t) const noexcept { territory_.free_slot(t); }
    MGDT_ALWAYS_INLINE void count_ghosts(std::size_t made, std::size_t gone) const noexcept {
        territory_.ghosts += static_cast<std::int64_t>(made) - static_cast<std::int64_t>(gone);
    }
    MGDT_ALWAYS_INLINE void made_ghost(TetId t) const noexcept { territory_.a_ghost = t; }
    MGDT_ALWAYS_INLINE void set_near(VertexId v, TetId t) const noexcept {
        if (mine_(v)) mesh_.near[v] = t;
    }

    MGDT_ALWAYS_INLINE MarkTable& marks() const noexcept { return territory_.marks; }

  private:
    Mesh& mesh_;
    Territory& territory_;
    const Claim::Mine mine_;
};

}  // namespace MGDT_ISA
}  // namespace mgdt
