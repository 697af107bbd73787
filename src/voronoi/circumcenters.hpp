// SPDX-License-Identifier: MIT
// The circumcentres of all tetrahedra, and which of them coincide.
#pragma once

#include "parallel/disjoint_sets.hpp"
#include "platform/compiler.hpp"
#include "platform/stage_progress.hpp"
#include "predicates/circumcenter.hpp"
#include "query/mesh_view.hpp"
#include "query/vertex_indices.hpp"

namespace mgdt {

class Circumcenters {
  public:
    Circumcenters(const MeshView& view, const VertexIndices& indices, StageProgress& progress);

    // The circumcentre of the finite tetrahedron in a slot. All coordinates carry the mesh's scale.
    const SplitPoint& operator[](TetId t) const noexcept { return centers_[t]; }
    // The corrections of coordinates carry this factor, a power of two.
    double factor() const noexcept { return factor_; }
    // The first slot of the tetrahedra that have the same circumcentre as the one in slot t. For a
    // ghost: the first slot of the ghosts that have the same ray.
    TetId first_equal(TetId t) const noexcept { return centers_[t].first; }
    void prefetch(TetId t) const noexcept { mgdt::prefetch(&centers_[t]); }

  private:
    struct Center : SplitPoint {
        TetId first;
    };
    static constexpr std::size_t slots_per_thread = 4096, ahead = 16;

    void set_factor(const MeshView& view);
    void set_centers(const MeshView& view, const VertexIndices& indices, StageProgress& progress);
    void join_tetrahedra(const Mesh& mesh, DisjointSets& sets, std::size_t begin, std::size_t end);
    static void join_ghosts(const Mesh& mesh, DisjointSets& sets, std::size_t begin,
                            std::size_t end);

    double factor_ = 1;
    Buffer<Center> centers_;
};

}  // namespace mgdt
