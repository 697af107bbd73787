// SPDX-License-Identifier: MIT
// Divides facets and segments of a mesh whose boundary may change.
#pragma once

#include "platform/stage_progress.hpp"
#include "refinement/cavity_search.hpp"
#include "refinement/wall_insertion.hpp"

namespace mgdt {

class WallRefiner {
  public:
    WallRefiner(RefinedMesh& mesh, Allocator& allocator)
        : mesh_(mesh),
          edges_{mesh.walled},
          insertion_(mesh, allocator),
          search_(allocator),
          frames_(allocator),
          pinched_(allocator),
          bad_(allocator) {
        find_frames();
        find_pinched_edges();
    }

    // Divides walls and segments until they are as short as the sizes want.
    void divide_by_size(std::size_t most_points, StageProgress& progress);
    // Divides walls that keep points from tetrahedra that are refused for that.
    void divide_by_shape(const KernelCalls& kernel, std::size_t most_points,
                         StageProgress& progress);

    std::size_t inserted = 0;

  private:
    // Two edges of a triangle in the plane of a facet, from a corner.
    struct Frame {
        double origin[3];
        Vector<double> u, v;
        double area2 = -1;
    };
    struct BadWall {
        double excess;
        FacetCode wall;
        VertexId newest;
        bool operator<(const BadWall& other) const noexcept {
            return excess != other.excess ? excess < other.excess : wall > other.wall;
        }
    };

    void find_frames();
    void find_pinched_edges();
    void add(FacetCode wall);
    double excess_of(FacetCode wall, WallInsertion::Segment& longest) const noexcept;
    bool is_there(FacetCode wall, VertexId newest) const noexcept;
    bool divide(FacetCode wall);
    bool divide_segment(const WallInsertion::Segment& segment);
    bool find_center(FacetCode& wall, double (&x)[3], WallInsertion::Segment& hit) const noexcept;
    bool insert(const double* x, FacetCode wall, const WallInsertion::Segment* segment);
    bool find_size(const double* x, FacetCode wall, NewPoint& point) const noexcept;

    RefinedMesh& mesh_;
    const WallEdges edges_;
    WallInsertion insertion_;
    CavitySearch search_;
    Buffer<Frame> frames_;  // by label
    // Edges of the hull at which parts of the domain meet that are linked nowhere else. They are
    // not divided, since that would have to happen in each part.
    PairTable pinched_;
    Buffer<BadWall> bad_;  // a heap
};

}  // namespace mgdt
