// SPDX-License-Identifier: MIT
// Contracts an edge: one of its ends leaves the mesh, and the tetrahedra at it go to the other end.
#pragma once

#include "improvement/flexible_mesh.hpp"
#include "improvement/vertex_star.hpp"

namespace mgdt {

class EdgeContraction {
  public:
    explicit EdgeContraction(const FlexibleMesh& mesh) : mesh_(mesh), star_(mesh.allocator()) {}

    // Contracts the edge between corners i and j of tetrahedron t to corner j. Returns whether the
    // tetrahedra that come are all better than the worst one at the vertex that leaves.
    bool find(std::uint32_t t, unsigned i, unsigned j, Change& change);

  private:
    bool find_ends(std::uint32_t leaving, std::uint32_t kept, std::uint32_t (&ends)[2]) const;

    const FlexibleMesh& mesh_;
    VertexStar star_;
};

}  // namespace mgdt
