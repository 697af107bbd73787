// SPDX-License-Identifier: MIT
// Recovers a boundary in a mesh: afterwards every segment is an edge and every triangle a face.
#pragma once

#include "platform/stop_request.hpp"
#include "recovery/crossing_walk.hpp"
#include "recovery/flips.hpp"
#include "recovery/patch_recovery.hpp"
#include "recovery/segment_chain.hpp"
#include "recovery/triangle_sheet.hpp"

namespace mgdt {

// What is recovered, in the vertices of a mesh.
struct RecoveryInput {
    explicit RecoveryInput(Allocator& allocator) : segments(allocator), triangles(allocator) {}
    Buffer<std::uint32_t> segments;   // 2 ends for each; those of the triangles are among them
    Buffer<std::uint32_t> triangles;  // 3 corners for each
};

// How much is tried before a segment counts as lost. Flips look at the ring of tetrahedra around
// an edge, so their work is counted in rings.
struct RecoveryEffort {
    std::size_t rings[Flips::most_depth + 1];  // for a segment, by the depth of the flips
    std::size_t rings_of_point;                // for the flips that follow the insertion of a point
    std::size_t most_rings;                    // in all, for each missing segment
    bool reverses;                             // whether the longest segments come first
};

class BoundaryRecovery {
  public:
    BoundaryRecovery(FlipMesh& mesh, const RecoveryInput& input, const RecoveryEffort& effort,
                     const StopRequest& stop, Allocator& allocator);

    // Recovers segments and triangles. Returns false if one of them is lost.
    bool run();

    // The ends of a segment that is missing, or those of a side of a triangle that is.
    const std::uint32_t (&lost_edge() const noexcept)[2] { return lost_edge_; }

  private:
    void find_missing_segments();
    void find_missing_triangles();
    bool recover_segments();
    bool recover_triangles();
    template <class Recover>
    void keep_missing(const Recover& recover);
    void set_budget(std::size_t rings);
    void spend_budget();
    bool recover_segment(std::uint32_t a, std::uint32_t b, unsigned depth);
    bool flip_segment(std::uint32_t a, std::uint32_t b, const Crossings& crossings, unsigned depth);
    bool insert_point(std::uint32_t a, std::uint32_t b, const Crossings& crossings);
    bool reduce_segment(const Crossings& crossings, unsigned depth);
    bool recover_triangle(const std::uint32_t (&v)[3], unsigned depth);

    FlipMesh& mesh_;
    const RecoveryInput& input_;
    const RecoveryEffort effort_;
    const StopRequest stop_;
    const std::uint32_t first_added_;
    PairTable kept_;  // the segments, with their numbers
    Flips flips_;
    CrossingWalk walk_;
    TriangleWalk over_;
    PatchRecovery patch_;
    SegmentChain chain_;
    TriangleSheet sheet_;
    std::uint32_t lost_edge_[2] = {no_index, no_index};
    bool adds_points_ = false;  // whether points may be added
    // How many rings deep flips may still look at, and how many of these the flips have at hand.
    std::size_t rings_left_ = 0, budget_ = 0;
    Buffer<std::uint32_t> missing_;  // segments, or triangles, by their numbers
    Buffer<Crossing> tried_;
};

}  // namespace mgdt
