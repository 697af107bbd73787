// SPDX-License-Identifier: MIT
// The link of a vertex: the faces opposite it of the tetrahedra at it, a sphere of triangles.
#pragma once

#include "mesh/mesh.hpp"
#include "mesh/numbers.hpp"

namespace mgdt {

struct LinkTriangle {
    // Numbers of neighbours of the vertex, in the order that makes the vertex and these a
    // positively oriented tetrahedron.
    std::uint32_t corner[3];
    std::uint32_t beyond[3];  // the triangle across the edge opposite corner k
};

// One link after the other, in the same memory.
class Link {
  public:
    explicit Link(Allocator& allocator)
        : triangles_(allocator), vertices_(allocator), tetrahedra_(allocator) {}

    // Of v, a vertex of the tetrahedron `first`.
    void gather(const Mesh& mesh, VertexId v, TetId first);

    std::size_t neighbor_count() const noexcept { return vertices_.size(); }
    // By number. One may be the vertex at infinity.
    VertexId neighbor(std::size_t number) const noexcept {
        return vertices_.name(static_cast<std::uint32_t>(number));
    }
    const Buffer<LinkTriangle>& triangles() const noexcept { return triangles_; }
    // The tetrahedron of a triangle.
    TetId tetrahedron(std::size_t triangle) const noexcept {
        return tetrahedra_.name(static_cast<std::uint32_t>(triangle));
    }

    // By neighbour: the triangle from which on for_ring() meets the neighbour of the least index
    // first, so that nothing depends on the order of the records.
    template <class IndexOf>
    void find_rings(IndexOf index_of, Buffer<std::uint32_t>& first) const {
        constexpr std::uint32_t none = 0xffffffffu;
        first.clear();
        first.resize(neighbor_count(), none);
        for (std::uint32_t i = 0; i < triangles_.size(); ++i)
            for (unsigned k = 0; k < 3; ++k) {
                std::uint32_t& of_corner = first[triangles_[i].corner[k]];
                if (of_corner == none ||
                    index_of(shared(i, k)) <
                        index_of(shared(of_corner, place(of_corner, triangles_[i].corner[k]))))
                    of_corner = i;
            }
    }
    // The triangles around neighbour b in turn, from `first` on, which has it: visit(triangle, the
    // neighbour that it shares with the next).
    template <class Visit>
    void for_ring(std::uint32_t b, std::uint32_t first, Visit visit) const {
        std::uint32_t i = first;
        do {
            const LinkTriangle& t = triangles_[i];
            const unsigned k = place(i, b);
            visit(i, shared(i, k));
            i = t.beyond[k == 2 ? 0 : k + 1];
        } while (i != first);
    }

  private:
    // Where a triangle has a neighbour.
    unsigned place(std::uint32_t triangle, std::uint32_t b) const noexcept {
        const std::uint32_t(&corner)[3] = triangles_[triangle].corner;
        return corner[0] == b ? 0 : corner[1] == b ? 1 : 2;
    }
    // What it shares with the next triangle around its corner k.
    std::uint32_t shared(std::uint32_t triangle, unsigned k) const noexcept {
        return triangles_[triangle].corner[k == 0 ? 2 : k - 1];
    }

    Buffer<LinkTriangle> triangles_;
    Numbers vertices_, tetrahedra_;
};

}  // namespace mgdt
