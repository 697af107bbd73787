// SPDX-License-Identifier: MIT
// Recovers a missing segment with all triangles around it that are missing too.
#pragma once

#include "platform/stop_request.hpp"
#include "recovery/crossing_walk.hpp"
#include "recovery/patch_cavity.hpp"
#include "recovery/plane_center.hpp"

namespace mgdt {

// A patch of the boundary that is flat, or nearly so, is visible from a place above it and from one
// below it. All that the patch crosses is replaced by tetrahedra at two points: vertices of what is
// around, or new points. So two points recover a fan of hundreds of triangles, whatever the mesh
// has in its place.
class PatchRecovery {
  public:
    // The edges `kept`, which has the sides of `triangles`, stay, and so do the vertices before
    // `first_added`.
    PatchRecovery(FlipMesh& mesh, const PairTable& kept, const Buffer<std::uint32_t>& triangles,
                  std::uint32_t first_added, const StopRequest& stop, Allocator& allocator)
        : mesh_(mesh),
          stop_(stop),
          patch_(mesh, kept, triangles, allocator),
          walk_(mesh, allocator),
          cavity_(mesh, kept, first_added, allocator),
          vertices_(allocator),
          added_(allocator),
          center_(allocator),
          failed_(allocator) {}

    // Makes the segment from a to b an edge. Returns false, and leaves the mesh as it was, if there
    // are no such points.
    bool recover(std::uint32_t a, std::uint32_t b);
    // A patch that could not be recovered, or another one with a triangle of it, is not tried again
    // before this call.
    void forget_failures() noexcept { failed_.clear(); }

  private:
    enum Failure : std::uint8_t { narrow = 1, wide = 2 };  // of narrow and of wide patches

    bool has_failed(Failure failure) const noexcept;
    void mark(Failure failure, std::size_t triangles) noexcept;
    bool try_patch(Failure failure);
    bool recover_patch();
    bool find_cavity();
    bool fill_side(PatchCavity::Side side);
    bool join(PatchCavity::Side side, std::uint32_t point, std::size_t first);
    std::uint32_t add_point(double share);
    void list(PatchCavity::Side side, std::uint32_t point, std::size_t first, bool is_whole);
    template <class Use>
    bool for_each_on_patch(PatchCavity::Side side, std::uint32_t point, const Use& use) const;

    FlipMesh& mesh_;
    const StopRequest stop_;
    BoundaryPatch patch_;
    CrossingWalk walk_;
    PatchCavity cavity_;
    Buffer<std::uint32_t> vertices_;
    Buffer<FlipMesh::Corners> added_;
    PlaneCenter center_;
    Buffer<std::uint8_t> failed_;  // of each triangle, flags of Failure
};

}  // namespace mgdt
