// SPDX-License-Identifier: MIT
// The cavity of a point that refinement would insert, and whether it should.
#pragma once

#include "kernel/kernel.hpp"
#include "mesh/numbers.hpp"
#include "refinement/new_point.hpp"

namespace mgdt {

// The search of one thread.
class CavitySearch {
  public:
    explicit CavitySearch(Allocator& allocator)
        : workspace(allocator), members_(allocator), removed_(allocator) {}

    enum class Outcome : std::uint8_t {
        found,    // the cavity is in the workspace, and its members are marked
        refused,  // refusal() says why
        closed    // the cavity needs a closed tetrahedron
    };
    // Finds the cavity of a point. The size of the point may become less.
    Outcome find(RefinedMesh& mesh, const KernelCalls& kernel, NewPoint& point);
    Refusal refusal() const noexcept { return refusal_; }
    // The wall that is between a tetrahedron and a point, or else the one whose plane is next to
    // the point, of those at the boundary of its cavity; no_index if there is none.
    FacetCode find_wall(RefinedMesh& mesh, const KernelCalls& kernel, const NewPoint& point);

    Workspace workspace;

  private:
    Outcome walk(const WalledMesh& mesh, const NewPoint& point) noexcept;
    Refusal judge(const RefinedMesh& mesh, NewPoint& point);
    bool sees(const Mesh& mesh, FacetCode outside, const double* q) const noexcept;
    bool sees_all(const Mesh& mesh, const double* q) const noexcept;
    Refusal shrink(WalledMesh& mesh, const double* q);
    bool dig_within_members(const WalledMesh& mesh, TetId first, const double* q);
    bool keeps_all(const WalledMesh& mesh);
    Refusal judge_vertices(const RefinedMesh& mesh, NewPoint& point) const noexcept;
    bool is_near_wall(const WalledMesh& mesh, const NewPoint& point) const noexcept;
    bool is_gain(const RefinedMesh& mesh, const NewPoint& point) const noexcept;

    Refusal refusal_ = Refusal::none;
    Numbers members_;
    Buffer<std::uint8_t> removed_;      // of members: whether the cavity has shrunk from them
    FacetCode wall_ = no_index;         // at which the last walk has ended
    TetId container_ = no_tetrahedron;  // the tetrahedron that contains the point
    std::uint32_t vertices_ = 0;        // of the cavity
};

}  // namespace mgdt
