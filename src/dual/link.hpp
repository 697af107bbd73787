// SPDX-License-Identifier: MIT
// The link of a vertex: for each tetrahedron at the vertex the face opposite the vertex. These
// triangles form a sphere.
#pragma once

#include "mesh/mesh.hpp"
#include "mesh/numbers.hpp"
#include "platform/no_index.hpp"

namespace mgdt {

struct LinkTriangle {
    // The corners, as numbers of neighbours. The vertex and the three corners in this order are a
    // positively oriented tetrahedron.
    std::uint32_t corner[3];
    std::uint32_t beyond[3];  // the adjacent triangle across the edge opposite corner k
};

// Gathers one link at a time and reuses its memory for the next.
class Link {
  public:
    explicit Link(Allocator& allocator)
        : triangles_(allocator), vertices_(allocator), tetrahedra_(allocator) {}

    // Gathers the link of v, which is a vertex of the tetrahedron `first`.
    void gather(const Mesh& mesh, VertexId v, TetId first);

    std::size_t neighbor_count() const noexcept { return vertices_.size(); }
    // The neighbour with this number. One neighbour may be the vertex at infinity.
    VertexId neighbor(std::size_t number) const noexcept {
        return vertices_.name(static_cast<std::uint32_t>(number));
    }
    const Buffer<LinkTriangle>& triangles() const noexcept { return triangles_; }
    // The tetrahedron of a triangle of the link.
    TetId tetrahedron(std::size_t triangle) const noexcept {
        return tetrahedra_.name(static_cast<std::uint32_t>(triangle));
    }

    // Sets first[b] to the triangle at which for_ring() starts around neighbour b. This is the
    // triangle for which the first neighbour that for_ring() passes to `visit` has the least index.
    // So the order of the ring does not depend on the order of the records.
    template <class IndexOf>
    void find_rings(IndexOf index_of, Buffer<std::uint32_t>& first) const {
        first.clear();
        first.resize(neighbor_count(), no_index);
        for (std::uint32_t i = 0; i < triangles_.size(); ++i)
            for (unsigned k = 0; k < 3; ++k) {
                std::uint32_t& of_corner = first[triangles_[i].corner[k]];
                if (of_corner == no_index ||
                    index_of(shared(i, k)) <
                        index_of(shared(of_corner, corner_of(of_corner, triangles_[i].corner[k]))))
                    of_corner = i;
            }
    }
    // Visits the triangles around neighbour b in cyclic order. `first` is a triangle with the
    // corner b. Calls visit(triangle, the neighbour that the triangle and the next one share
    // besides b).
    template <class Visit>
    void for_ring(std::uint32_t b, std::uint32_t first, Visit visit) const {
        std::uint32_t i = first;
        do {
            const LinkTriangle& t = triangles_[i];
            const unsigned k = corner_of(i, b);
            visit(i, shared(i, k));
            i = t.beyond[k == 2 ? 0 : k + 1];
        } while (i != first);
    }

  private:
    // The position of neighbour b among the corners of a triangle.
    unsigned corner_of(std::uint32_t triangle, std::uint32_t b) const noexcept {
        const std::uint32_t(&corner)[3] = triangles_[triangle].corner;
        return corner[0] == b ? 0 : corner[1] == b ? 1 : 2;
    }
    // The neighbour, other than corner k, that the triangle shares with the next triangle around
    // corner k.
    std::uint32_t shared(std::uint32_t triangle, unsigned k) const noexcept {
        return triangles_[triangle].corner[k == 0 ? 2 : k - 1];
    }

    Buffer<LinkTriangle> triangles_;
    Numbers vertices_, tetrahedra_;
};

}  // namespace mgdt
