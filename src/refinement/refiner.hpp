// SPDX-License-Identifier: MIT
// Divides bad tetrahedra until none is left that can be divided.
#pragma once

#include <optional>

#include "parallel/per_member.hpp"
#include "parallel/work_queue.hpp"
#include "refinement/wall_refiner.hpp"
#include "refinement/zone_division.hpp"
#include "refinement/zone_refiner.hpp"

namespace mgdt {

class Refiner {
  public:
    Refiner(RefinedMesh& mesh, const CubicLattice& lattice, const Kernel& kernel, Team& team,
            Allocator& allocator)
        : mesh_(mesh),
          team_(team),
          calls_(kernel.with_spheres),
          refiners_(team, allocator, &mesh, &lattice, &kernel, &allocator),
          division_(allocator),
          queue_(allocator, team.size()),
          supplies_(allocator),
          slots_(allocator),
          vertices_(allocator) {}

    // Lets facets and segments be divided.
    void divide_walls() { walls_.emplace(mesh_, slots_.allocator()); }
    void run(StageProgress& progress);

    std::size_t most_points = static_cast<std::size_t>(-1);  // that are inserted
    std::size_t inserted = 0, passes = 0;

  private:
    void judge_all(StageProgress& progress);
    bool prepare(std::size_t pass);
    void supply(std::size_t most);
    void run_zones(StageProgress& progress);
    void take_back();
    std::size_t count_inserted() const noexcept;

    RefinedMesh& mesh_;
    Team& team_;
    const KernelCalls& calls_;
    PerMember<ZoneRefiner> refiners_;
    ZoneDivision division_;
    WorkQueue queue_;
    Buffer<ZoneSupply> supplies_;  // of each zone
    Buffer<TetId> slots_;
    Buffer<VertexId> vertices_;
    std::optional<WallRefiner> walls_;
    bool is_single_ = false;  // whether the next pass has one zone
};

}  // namespace mgdt
