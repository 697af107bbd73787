// SPDX-License-Identifier: MIT
// The other points at the vertices that a call's points leave. The lists of equal points serve a
// call with one point; a call with several looks through all points once.
#pragma once

#include "core/equal_points.hpp"
#include "core/state.hpp"

namespace mgdt {

class OtherPoints {
  public:
    // `leaving` are the points that the call removes or moves. They have to stay as they are.
    OtherPoints(State& state, const Buffer<std::uint32_t>& leaving) noexcept
        : state_(state),
          leaving_(leaving),
          is_alone_(leaving.size() == 1 && state.statistics.duplicates != 0),
          among_(state.allocator, state.mesh.vertices.size()) {}

    // Finds them, before the first point leaves. Throws std::bad_alloc.
    void find();
    // The least point at vertex v other than `than`, the point that leaves v now. Returns no_index
    // if there is no other point.
    std::uint32_t least(VertexId v, std::uint32_t than);
    // Enters that a point comes to a vertex with other points. Throws std::bad_alloc with nothing
    // changed.
    void join(VertexId v, std::uint32_t point);

  private:
    State& state_;
    const Buffer<std::uint32_t>& leaving_;
    const bool is_alone_;  // one point leaves, and some points are equal
    EqualPoints among_;
};

}  // namespace mgdt
