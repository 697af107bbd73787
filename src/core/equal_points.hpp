// SPDX-License-Identifier: MIT
// Finds which points share a vertex, for a call that removes or moves several of them. See also
// EqualPointLists, for calls with one point.
#pragma once

#include "mesh/tetrahedron.hpp"
#include "platform/memory.hpp"

namespace mgdt {

class EqualPoints {
  public:
    // `vertices`: the number of vertices at the beginning of the call.
    EqualPoints(Allocator& allocator, std::size_t vertices) noexcept
        : vertices_(vertices), points_(allocator), first_(allocator), joined_(allocator) {}

    // Lists all points at the vertices of the points that will leave. The call is not needed if all
    // points are distinct.
    void find(const Buffer<VertexId>& point_map, const Buffer<std::uint32_t>& leaving);
    // The least point at vertex v other than `than`, the point that leaves v now. Returns no_index
    // if there is no other point.
    std::uint32_t least_other(const Buffer<VertexId>& point_map, VertexId v, std::uint32_t than);
    // Adds a point to a vertex. The point does not leave it again in this call. Throws
    // std::bad_alloc with nothing changed.
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
    Buffer<PointOfVertex> points_;  // the points that find() listed, sorted
    Buffer<std::uint32_t> first_;   // at a vertex's first entry: that of its first remaining point
    // For each vertex, the least point that join() added, or no_index. Without such points, empty.
    Buffer<std::uint32_t> joined_;
};

}  // namespace mgdt
