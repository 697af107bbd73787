// SPDX-License-Identifier: MIT
// Removes faces between two vertices: the tetrahedra on both sides of these faces are replaced by
// others around an edge between the vertices.
#pragma once

#include "improvement/flexible_mesh.hpp"

namespace mgdt {

class FaceRemoval {
  public:
    explicit FaceRemoval(const FlexibleMesh& mesh) : mesh_(mesh) {}

    // Finds the faces, that of corner i of tetrahedron t among them, whose removal gives the best
    // tetrahedra. Returns whether all of these are better than the worst one of those that leave.
    // The search is that of Shewchuk, "Two discrete optimization algorithms for the topological
    // improvement of tetrahedral meshes", 2002.
    bool find(std::uint32_t t, unsigned i, Change& change);

  private:
    static constexpr unsigned most_faces = 12;

    // The new tetrahedra beyond an edge of a removed face: one, or those of the next face.
    struct Edge {
        std::uint32_t p, q;
        std::uint32_t above, below;  // the tetrahedra at the face
        unsigned depth;
    };
    double look_beyond(const Edge& edge);

    const FlexibleMesh& mesh_;
    std::uint32_t a_ = 0, b_ = 0;  // the vertices above and below the faces
    double least_ = 0;             // what all new tetrahedra have to exceed
    // Tetrahedra above and below the removed faces, and edges around them with the qualities of
    // their tetrahedra. Both lists shrink where a search returns without a result.
    std::uint32_t removed_[2 * most_faces];
    unsigned removed_count_ = 0;
    Change::Tetrahedron added_[most_faces + 2];
    unsigned added_count_ = 0;
};

}  // namespace mgdt
