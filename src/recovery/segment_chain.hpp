// SPDX-License-Identifier: MIT
// The last resort for a missing segment: a chain of edges along it, of which the inner vertices are
// then taken out.
#pragma once

#include "recovery/crossing_walk.hpp"
#include "recovery/edge_ring.hpp"
#include "recovery/withdrawal.hpp"

namespace mgdt {

// A segment that crosses the insides of faces alone passes through tetrahedra one after the other.
// A point in each of them, near the segment, is joined to the next one by a flip of the face
// between them. So there is a chain of edges from one end of the segment to the other, from which
// one vertex after the other is withdrawn. An edge that the segment crosses is
// replaced first, by edges to a new point beside it.
class SegmentChain {
  public:
    SegmentChain(FlipMesh& mesh, Allocator& allocator)
        : mesh_(mesh),
          walk_(mesh, allocator),
          ring_(allocator),
          withdrawal_(mesh, allocator),
          chain_(allocator),
          removed_(allocator),
          added_(allocator) {}

    // Makes the segment from a to b an edge. Returns false, and leaves the mesh as it was, if
    // doubles do not suffice.
    bool recover(std::uint32_t a, std::uint32_t b);

  private:
    bool recover_straight(std::uint32_t a, std::uint32_t b);
    bool replace_edges(std::uint32_t a, std::uint32_t b);
    bool replace_edge(std::uint32_t p, std::uint32_t q, const double (&on)[3]);
    bool build(std::uint32_t a, std::uint32_t b, const Buffer<Crossing>& crossings);
    bool join(std::uint32_t from, std::uint32_t to, const std::uint32_t (&face)[3]);

    FlipMesh& mesh_;
    CrossingWalk walk_;
    EdgeRing ring_;
    Withdrawal withdrawal_;
    Buffer<std::uint32_t> chain_;  // the inner vertices
    Buffer<std::uint32_t> removed_;
    Buffer<FlipMesh::Corners> added_;
};

}  // namespace mgdt
