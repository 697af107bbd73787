// SPDX-License-Identifier: MIT
// Recovers a boundary in a mesh: afterwards every segment is an edge and every triangle a face.
#pragma once

#include "platform/stop_request.hpp"
#include "recovery/crossing_walk.hpp"
#include "recovery/flips.hpp"
#include "recovery/segment_chain.hpp"
#include "recovery/triangle_sheet.hpp"

namespace mgdt {

// What is recovered, in the vertices of a mesh.
struct RecoveryInput {
    explicit RecoveryInput(Allocator& allocator) : segments(allocator), triangles(allocator) {}
    Buffer<std::uint32_t> segments;   // 2 ends for each; those of the triangles are among them
    Buffer<std::uint32_t> triangles;  // 3 corners for each
};

// How much is tried before a segment counts as lost: how many rings of edges are looked at in
// removals of each depth, and after a point has been inserted; and whether segments come in the
// opposite order.
struct RecoveryEffort {
    std::size_t rings[Flips::most_depth + 1];
    std::size_t rings_of_point;
    bool reverses;
};

class BoundaryRecovery {
  public:
    BoundaryRecovery(FlipMesh& mesh, const RecoveryInput& input, const RecoveryEffort& effort,
                     const StopRequest& stop, Allocator& allocator);

    // Returns whether everything was recovered.
    bool run();

    // The ends of a segment that is missing, or those of a side of a triangle that is.
    const std::uint32_t (&lost_edge() const noexcept)[2] { return lost_edge_; }

    struct Counts {
        std::size_t missing_segments[4] = {}, missing_triangles[4] = {};
    };
    Counts counts;

  private:
    bool recover_segment(std::uint32_t a, std::uint32_t b, unsigned depth);
    bool flip_segment(std::uint32_t a, std::uint32_t b, const Crossings& crossings, unsigned depth);
    bool insert_point(std::uint32_t a, std::uint32_t b, const Crossings& crossings, unsigned depth);
    bool reduce_segment(const Crossings& crossings, unsigned depth);
    bool recover_triangle(const std::uint32_t (&v)[3], unsigned depth);

    FlipMesh& mesh_;
    const RecoveryInput& input_;
    const RecoveryEffort effort_;
    const StopRequest stop_;
    const std::uint32_t first_added_;
    PairTable kept_;
    Flips flips_;
    CrossingWalk walk_;
    TriangleWalk over_;
    SegmentChain chain_;
    TriangleSheet sheet_;
    std::uint32_t lost_edge_[2] = {no_index, no_index};
    bool with_points_ = false;
    Buffer<std::uint32_t> missing_, left_;
    Buffer<Crossing> tried_;
};

}  // namespace mgdt
