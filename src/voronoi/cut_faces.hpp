// SPDX-License-Identifier: MIT
// The faces of cells that the region may cut.
#pragma once

#include "dual/cell_measurer.hpp"
#include "parallel/per_member.hpp"
#include "platform/stage_progress.hpp"
#include "voronoi/cut_corners.hpp"

namespace mgdt {

class CutFaces {
  public:
    CutFaces(const MeshView& view, const VertexIndices& indices, const Region& region,
             const Circumcenters& centers, AtomicArray<std::uint8_t>& is_cut, CutCorners& corners,
             AtomicArray<TetId>& first, std::size_t points, StageProgress& progress);

    // Marks the vertices whose cells may be cut.
    void mark();
    // Appends the faces between cells that may be cut, and those in planes of the region.
    void find(PerMember<FoundFaces>& found);

  private:
    // A face, given by the cycle of the planes that contain its edges.
    struct Cycle {
        std::uint32_t sides[2];  // as in FoundFace
        std::uint32_t size;
        std::size_t begin;
        std::size_t face;  // its number among the faces that were found, or no_face
    };
    static constexpr std::size_t no_face = static_cast<std::size_t>(-1);
    struct Cycles {
        explicit Cycles(Allocator& allocator) : faces(allocator), edges(allocator) {}
        Buffer<Cycle> faces;
        Buffer<std::uint32_t> edges;  // sites and planes, see CutCorners::Key
    };
    void find_cycles(PerMember<Cycles>& cycles);
    void find_corners(Cycles& cycles, FoundFaces& found);
    void measure(const Cycles& cycles, FoundFaces& found);
    FacePlane plane_of(const FoundFace& face) const;

    const MeshView& view_;
    const Mesh& mesh_;
    const VertexIndices& indices_;
    const Region& region_;
    const Circumcenters& centers_;
    AtomicArray<std::uint8_t>& is_cut_;
    CutCorners& corners_;
    AtomicArray<TetId>& first_;
    const std::size_t points_;  // vertices with larger indices have no cells
    StageProgress& progress_;
};

}  // namespace mgdt
