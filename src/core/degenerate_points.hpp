// SPDX-License-Identifier: MIT
// Vertices of a set that does not span space yet. There are no tetrahedra to find repeats with,
// so a hash table of coordinates does.
#pragma once

#include "mesh/mesh.hpp"
#include "platform/number_table.hpp"

namespace mgdt {

class DegeneratePoints {
  public:
    explicit DegeneratePoints(Allocator& allocator) : table_(allocator) {}

    // Makes the next `count` calls of add() infallible.
    void reserve(Mesh& mesh, std::size_t count);
    // The vertex at p: one that is there, or a new one with this index.
    VertexId add(Mesh& mesh, const double* p, std::uint32_t index) noexcept;
    void clear() noexcept { table_.reset(); }

  private:
    // Of vertex v as item v - 1, if it is at p; else that of a new vertex.
    std::uint32_t number(const Mesh& mesh, const double* p) noexcept;

    NumberTable table_;
};

}  // namespace mgdt
