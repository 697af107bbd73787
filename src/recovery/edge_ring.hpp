// SPDX-License-Identifier: MIT
// The tetrahedra around an edge.
#pragma once

#include "recovery/flip_mesh.hpp"

namespace mgdt {

// The edge goes from p to q. Its tetrahedra (p, q, v[i], v[i + 1]) are positive; the last one has
// v[0] as its last corner.
struct EdgeRing {
    static constexpr std::size_t no_limit = static_cast<std::size_t>(-1);

    explicit EdgeRing(Allocator& allocator)
        : v(allocator), tetrahedra(allocator), added_(allocator) {}

    // Collects the ring of an edge. Returns false if the edge does not exist or is on the hull, or
    // if it has more than `most` tetrahedra.
    bool collect(FlipMesh& mesh, std::uint32_t from, std::uint32_t to, std::size_t most = no_limit);

    // Removes the edge, and joins a new point near it to all that is around it. Returns false, and
    // changes nothing, if a tetrahedron would not be positive.
    bool join(FlipMesh& mesh, std::uint32_t point);

    std::uint32_t p = 0, q = 0;
    Buffer<std::uint32_t> v, tetrahedra;

  private:
    Buffer<FlipMesh::Corners> added_;
};

}  // namespace mgdt
