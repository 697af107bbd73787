// SPDX-License-Identifier: MIT
// The faces that no region cuts. The corners of such a face are the circumcentres of the
// tetrahedra around an edge.
#pragma once

#include "parallel/per_member.hpp"
#include "platform/stage_progress.hpp"
#include "voronoi/circumcenters.hpp"
#include "voronoi/found_faces.hpp"

namespace mgdt {

// Finds the face of each edge, unless the cells of both ends may be cut. is_cut has a mark for each
// vertex whose cell may be cut.
class WholeFaces {
  public:
    WholeFaces(const MeshView& view, const VertexIndices& indices, const Circumcenters& centers,
               AtomicArray<std::uint8_t>& is_cut, StageProgress& progress)
        : view_(view), indices_(indices), centers_(centers), is_cut_(is_cut), progress_(progress) {}

    // Appends the faces. Each member of the team appends to its own list.
    void find(PerMember<FoundFaces>& found);

  private:
    class Finder;

    const MeshView& view_;
    const VertexIndices& indices_;
    const Circumcenters& centers_;
    AtomicArray<std::uint8_t>& is_cut_;
    StageProgress& progress_;
};

}  // namespace mgdt
