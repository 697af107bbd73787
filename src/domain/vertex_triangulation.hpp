// SPDX-License-Identifier: MIT
// The Delaunay triangulation of some vertices of a mesh.
#pragma once

#include "domain/constrained_mesh.hpp"
#include "platform/objects.hpp"
#include "query/visit_queue.hpp"

namespace mgdt {

class VertexTriangulation {
  public:
    explicit VertexTriangulation(Allocator& allocator)
        : triangulation_(allocator, 1, &Allocator::allocate_from, &Allocator::release_to,
                         static_cast<void*>(&allocator)),
          xyz_(allocator),
          star_(allocator) {}

    // Triangulates the vertices, whose numbers ascend and which have to stay.
    void set(const ConstrainedMesh& mesh, const Buffer<std::uint32_t>& vertices);
    // The corner d of the tetrahedron abcd, if a positive one has this face; otherwise no_index.
    std::uint32_t apex(std::uint32_t a, std::uint32_t b, std::uint32_t c);
    void clear() noexcept;

  private:
    // The vertex of the triangulation for a vertex of the mesh.
    VertexId vertex(std::uint32_t v) const;

    Objects<Triangulation> triangulation_;
    const Buffer<std::uint32_t>* vertices_ = nullptr;
    Buffer<double> xyz_;
    VisitQueue star_;
};

}  // namespace mgdt
