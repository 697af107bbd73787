// SPDX-License-Identifier: MIT
// Lists of the points that share a vertex, for calls that remove or move one point. A call with
// many points looks through all of them once instead, see EqualPoints.
#pragma once

#include <cassert>

#include "mesh/tetrahedron.hpp"
#include "platform/memory.hpp"

namespace mgdt {

class EqualPointLists {
  public:
    explicit EqualPointLists(Allocator& allocator) noexcept : next_(allocator) {}

    // Makes sure that the points given since the last call are in the lists, in a time that is
    // proportional to their number, but for the first call. Throws std::bad_alloc.
    void update(const Buffer<VertexId>& point_map, const Buffer<Vertex>& vertices);
    // Empties the lists, for calls that may join or renumber points.
    void forget() noexcept { next_.reset(); }
    // Whether each of `points` points is in a list.
    bool have_all(std::size_t points) const noexcept { return next_.size() == points; }

    // Calls f(point) for each point at vertex v, in ascending order.
    template <class F>
    void for_each(const Buffer<VertexId>& point_map, const Vertex& vertex, VertexId v, F f) const {
        for (std::uint32_t i = vertex.index; i != no_index;) {
            const std::uint32_t next = next_[i];
            if (point_map[i] == v) f(i);
            i = next;
        }
    }
    // The least point at vertex v other than `than`, or no_index.
    std::uint32_t least_other(const Buffer<VertexId>& point_map, const Vertex& vertex, VertexId v,
                              std::uint32_t than) const {
        assert(point_map[than] == v && "the point is at another vertex");
        if (vertex.index != than) return vertex.index;
        std::uint32_t i = next_[than];
        while (i != no_index && point_map[i] != v) i = next_[i];
        return i;
    }

  private:
    void make_anew(const Buffer<VertexId>& point_map, const Buffer<Vertex>& vertices);

    // For each point a later one, or no_index. The list of a vertex begins at its least point. It
    // has all points at the vertex, and may have points that were at the vertex.
    Buffer<std::uint32_t> next_;
};

}  // namespace mgdt
