// SPDX-License-Identifier: MIT
// Which points share a vertex, for a call that takes some of them away from it.
#pragma once

#include "mesh/tetrahedron.hpp"
#include "platform/memory.hpp"

namespace mgdt {

class EqualPoints {
  public:
    // `vertices`: how many there are at the beginning of the call.
    EqualPoints(Allocator& allocator, std::size_t vertices) noexcept
        : vertices_(vertices), points_(allocator), first_(allocator), joined_(allocator) {}

    // Takes note of all points at the vertices of those that will leave. Not needed where no
    // points are equal.
    void find(const Buffer<VertexId>& point_map, const Buffer<std::uint32_t>& leaving);
    // The least other point at the vertex of a point that leaves it now; no_index if it is alone.
    std::uint32_t least_other(const Buffer<VertexId>& point_map, VertexId v, std::uint32_t than);
    // A point comes to a vertex, which it does not leave again in this call. Throws std::bad_alloc
    // with nothing changed.
    void join(VertexId v, std::uint32_t point);

  private:
    struct PointOfVertex {
        VertexId vertex;
        std::uint32_t point;
        bool operator<(const PointOfVertex& other) const {
            return vertex != other.vertex ? vertex < other.vertex : point < other.point;
        }
    };

    std::size_t vertices_;
    Buffer<PointOfVertex> points_;  // sorted, those of vertices with several
    Buffer<std::uint32_t> first_;   // where a vertex's points begin, those gone since left out
    Buffer<std::uint32_t> joined_;  // by vertex, the least point that came; empty until one comes
};

}  // namespace mgdt
