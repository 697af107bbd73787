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

    // Triangulates the vertices. Their numbers ascend, and the array has to exist as long as the
    // result is used.
    void set(const ConstrainedMesh& mesh, const Buffer<std::uint32_t>& vertices);
    // The corner d of the positive tetrahedron abcd that has the face abc; no_index if there is
    // none.
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
