// SPDX-License-Identifier: MIT
// Removes added points that are no longer necessary.
#pragma once

#include "platform/stop_request.hpp"
#include "recovery/flips.hpp"

namespace mgdt {

// A point is removed by a contraction: it moves to one of its neighbours, if the tetrahedra that it
// takes there stay positive. If there is no such neighbour, edges at the point are removed first,
// so that fewer tetrahedra have it. Edges and faces of the boundary are not at added points, and
// stay.
class PointRemoval {
  public:
    PointRemoval(FlipMesh& mesh, Flips& flips, Allocator& allocator)
        : mesh_(mesh),
          flips_(flips),
          star_(allocator),
          neighbors_(allocator),
          added_(allocator),
          best_(allocator) {}

    // Removes points from number `first` on, in several passes.
    void run(std::uint32_t first, const StopRequest& stop);

  private:
    bool remove(std::uint32_t v);
    bool contract(std::uint32_t v);
    void collect_star(std::uint32_t v);
    double move_to(std::uint32_t v, std::uint32_t target);

    FlipMesh& mesh_;
    Flips& flips_;
    Buffer<std::uint32_t> star_, neighbors_;
    Buffer<FlipMesh::Corners> added_, best_;
};

}  // namespace mgdt
