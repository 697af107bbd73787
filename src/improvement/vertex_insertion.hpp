// SPDX-License-Identifier: MIT
// Inserts a vertex: a bad tetrahedron and some around it are replaced by those of a new vertex.
#pragma once

#include <algorithm>

#include "improvement/flexible_mesh.hpp"
#include "improvement/place_search.hpp"

namespace mgdt {

class VertexInsertion {
  public:
    explicit VertexInsertion(const FlexibleMesh& mesh)
        : mesh_(mesh),
          search_(mesh.allocator()),
          cavity_(mesh.allocator()),
          faces_(mesh.allocator()) {}

    // Finds a cavity around tetrahedron t and a place for a vertex in it. Returns whether the new
    // tetrahedra are all better than the worst one of the cavity. The cavity grows through the face
    // whose tetrahedron is the worst (after Klingner and Shewchuk, "Aggressive tetrahedral mesh
    // improvement", 2007).
    bool find(std::uint32_t t, double goal, Change& change);

  private:
    // A face of the cavity: the new vertex, v[0], v[1] and v[2] are positive.
    struct Face {
        std::uint32_t v[3];
        std::uint32_t code;  // in the tetrahedron of the cavity
        double quality;      // of the new tetrahedron
    };

    // Whether the cavity has a tetrahedron.
    bool has(std::uint32_t t) const noexcept {
        return std::find(cavity_.begin(), cavity_.end(), t) != cavity_.end();
    }
    void begin(std::uint32_t t);
    void add(std::uint32_t t);
    bool grow();
    double move(double goal);
    bool keeps_vertices_and_edges() const;

    const FlexibleMesh& mesh_;
    PlaceSearch search_;
    Buffer<std::uint32_t> cavity_;  // in the order in which they have been added
    Buffer<Face> faces_;
    double place_[3] = {};
};

}  // namespace mgdt
