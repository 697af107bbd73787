// SPDX-License-Identifier: MIT
// The walk over a missing triangle whose edges are edges of the mesh. It lists the edges that
// cross the triangle.
#pragma once

#include "recovery/flip_mesh.hpp"

namespace mgdt {

class TriangleWalk {
  public:
    TriangleWalk(FlipMesh& mesh, Allocator& allocator)
        : mesh_(mesh), edges_(allocator), tetrahedra_(allocator), stamps_(allocator) {}

    enum class Result {
        is_face,
        crosses,  // edges() has the edges that cross the triangle
        meets     // vertex() is in the triangle
    };

    Result run(const std::uint32_t (&v)[3]);

    // An edge of the mesh that crosses the triangle.
    struct Edge {
        std::uint32_t p, q;  // p < q
        friend bool operator<(const Edge& e, const Edge& f) {
            return e.p != f.p ? e.p < f.p : e.q < f.q;
        }
        friend bool operator==(const Edge& e, const Edge& f) { return e.p == f.p && e.q == f.q; }
    };
    const Buffer<Edge>& edges() const noexcept { return edges_; }
    // The tetrahedra that the triangle meets, other than at its edges.
    const Buffer<std::uint32_t>& tetrahedra() const noexcept { return tetrahedra_; }
    std::uint32_t vertex() const noexcept { return vertex_; }
    // The code of the face, if the triangle is one.
    std::uint32_t face() const noexcept { return face_; }

  private:
    Result begin(const std::uint32_t (&v)[3]);
    void enter(std::uint32_t t);
    bool is_inside(const std::uint32_t (&v)[3], std::uint32_t w) const noexcept;

    FlipMesh& mesh_;
    std::uint32_t vertex_ = no_index, face_ = no_index;
    Buffer<Edge> edges_;
    Buffer<std::uint32_t> tetrahedra_, stamps_;
    std::uint32_t walk_ = 0;
};

}  // namespace mgdt
