// SPDX-License-Identifier: MIT
// Divides the bad tetrahedra of one zone, on one thread.
#pragma once

#include "platform/stage_progress.hpp"
#include "refinement/bad_tetrahedra.hpp"
#include "refinement/cavity_search.hpp"
#include "refinement/cubic_lattice.hpp"

namespace mgdt {

// The slots and vertices that a zone may take.
struct ZoneSupply {
    TetId *first_slot, *slots_end;  // a stack, with room for all slots that become free
    const VertexId *next_vertex, *vertices_end;

    std::size_t slots() const noexcept { return static_cast<std::size_t>(slots_end - first_slot); }
};

class ZoneRefiner {
  public:
    ZoneRefiner(RefinedMesh* mesh, const CubicLattice* lattice, const Kernel* kernel,
                Allocator* allocator)
        : mesh_(*mesh),
          lattice_(*lattice),
          calls_(kernel->with_spheres),
          search_(*allocator),
          bad_(*allocator),
          facets_(*allocator) {}

    // Divides bad tetrahedra of the zone, worst ones first, until none is left or the supply is
    // used up. The result does not depend on what happens in other zones. Calls watch(i) for each
    // step i.
    template <class Watch>
    void run(const TetId* begin, const TetId* end, ZoneSupply& supply, const Watch& watch) {
        begin_zone(begin, end);
        for (std::size_t i = 0; !bad_.empty() && supply.next_vertex != supply.vertices_end; ++i) {
            watch(i);
            if (!divide(bad_.take(), supply)) break;
        }
    }

    std::size_t inserted = 0;

  private:
    void begin_zone(const TetId* begin, const TetId* end);
    bool divide(const BadTetrahedron& bad, ZoneSupply& supply);
    bool propose(TetId t, NewPoint& point) const noexcept;
    bool choose_place(TetId t, const ElementShape& e, NewPoint& point) const noexcept;
    void insert(const NewPoint& point, ZoneSupply& supply);

    // A facet of the cavity, and what is in the slot of a tetrahedron inside of it.
    struct Facet {
        bool is_wall;
        LinkedMesh::Side side;
    };

    RefinedMesh& mesh_;
    const CubicLattice& lattice_;
    const KernelCalls& calls_;
    CavitySearch search_;
    BadTetrahedra bad_;
    Buffer<Facet> facets_;
};

}  // namespace mgdt
