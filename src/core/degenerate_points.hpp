// SPDX-License-Identifier: MIT
// The vertices of a set of points that does not span space yet. As there are no tetrahedra, repeats
// are found with a hash table of coordinates.
#pragma once

#include "mesh/mesh.hpp"
#include "platform/number_table.hpp"

namespace mgdt {

class DegeneratePoints {
  public:
    explicit DegeneratePoints(Allocator& allocator) : table_(allocator) {}

    // Makes the next `count` calls of add() infallible.
    void reserve(Mesh& mesh, std::size_t count);
    // Returns the vertex at p. If there is none, adds one with this index.
    VertexId add(Mesh& mesh, const double* p, std::uint32_t index) noexcept;
    void clear() noexcept { table_.reset(); }

  private:
    // The number of the item at p in the hash table, where vertex v is item v - 1. If no vertex is
    // at p, adds the item of a new vertex.
    std::uint32_t number(const Mesh& mesh, const double* p) noexcept;

    NumberTable table_;
};

}  // namespace mgdt
