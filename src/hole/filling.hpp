// SPDX-License-Identifier: MIT
// The tetrahedra that fill a hole, a part of a triangulation from which all tetrahedra are taken.
//
// All vertices of these tetrahedra are among given ones, which have local numbers. So the hole is
// filled facet by facet, inwards from its boundary. The tetrahedron at a facet joins the facet to
// an apex: a vertex on the inner side of the facet. The circumsphere of this tetrahedron has none
// of the vertices inside, so one pass over them finds the apex: a vertex inside the sphere of the
// best candidate becomes the best. If no vertex is on the inner side, the facet is on the hull and
// gets a ghost. The kernel's find_apex() finds the apex with vector instructions where
// floating-point arithmetic decides. Elsewhere exact predicates decide, and the perturbation leaves
// exactly one apex. Filling facet by facet takes time quadratic in the number of vertices. Where
// there are many, they are triangulated by themselves, and the tetrahedra inside the hole are
// copied.
#pragma once

#include "kernel/kernel.hpp"

namespace mgdt {

class Filling {
  public:
    // The local number of a vertex.
    using Number = std::uint32_t;
    // A tetrahedron, with its vertices in the order of the record. n[i] is the facet code on the
    // other side of the facet opposite vertex i: of a neighbour outside the hole if is_outside[i],
    // otherwise of one of the tetrahedra of the filling.
    struct Element {
        Number v[4];
        FacetCode n[4];
        bool is_outside[4];
        Sphere sphere;
    };

    explicit Filling(Allocator& allocator) noexcept
        : columns_(allocator), facets_(allocator), heads_(allocator), elements_(allocator) {}

    // Begins to fill a hole. The vertex with local number k is vertices[k]; `infinite` is the local
    // number of the vertex at infinity, or no_index.
    void begin(const Buffer<VertexId>& vertices, Number infinite);
    // Adds a facet of the boundary, oriented for the tetrahedron on its inner side: (apex, v[0],
    // v[1], v[2]) is positively oriented. `behind` is the facet code outside the hole.
    void add_boundary(const Number (&v)[3], FacetCode behind) { join(v, behind, true); }
    // Fill the hole, the second function from a triangulation whose points are the finite vertices,
    // in the same order. They throw std::bad_alloc.
    void fill(const Kernel& kernel, const Mesh& mesh);
    void fill_from(const Mesh& triangulated_vertices, const Mesh& mesh);

    const Buffer<Element>& elements() const noexcept { return elements_; }
    std::size_t ghosts() const noexcept { return ghosts_; }
    // Frees the memory that is kept from one hole to the next.
    void reset() noexcept;

  private:
    // A facet of the hole or of the filling, oriented like one of the boundary, its least number
    // first.
    struct Facet {
        Number v[3];
        FacetCode behind;    // the facet code on the other side, as in Element
        std::uint32_t next;  // the next facet with the same head, or no_index
        bool is_outside, is_closed;
    };

    // The index in heads_ of the facets that begin with the vertices a and b: in a matrix of all
    // pairs, or in a hash table if there are many vertices.
    std::size_t head_of(Number a, Number b) const noexcept { return (a * stride_ + b) & mask_; }
    // The number of a facet in this orientation, or no_index. The least number comes first.
    std::uint32_t facet(Number a, Number b, Number c) const noexcept {
        std::uint32_t i = heads_[head_of(a, b)];
        while (i != no_index &&
               (facets_[i].v[2] != c || facets_[i].v[0] != a || facets_[i].v[1] != b))
            i = facets_[i].next;
        return i;
    }
    // Adds a facet, or, if it is there as the boundary of the tetrahedron on its other side, links
    // the tetrahedra on its two sides.
    void join(const Number (&v)[3], FacetCode behind, bool is_outside);
    void link(std::uint32_t facet, FacetCode behind, bool is_outside) noexcept;
    HoleColumns columns(const Mesh& mesh);
    ApexResult apex_of(const Mesh& mesh, const Facet& facet) const;
    Sphere ghost_sphere(const Mesh& mesh, const Facet& facet) const;
    void close(const Mesh& mesh, std::uint32_t facet, ApexResult apex);
    void require_full() const;
    Buffer<FacetCode> boundary_in(const Mesh& triangulated_vertices);
    // The local number for vertex u of the triangulation of the vertices.
    Number number_in(const Mesh& triangulated_vertices, VertexId u) const noexcept {
        if (u == infinite_vertex) return infinite_;
        const std::uint32_t i = triangulated_vertices.vertices[u].index;
        return i < infinite_ ? i : i + 1;
    }
    const double* point(const Mesh& mesh, Number k) const noexcept {
        return mesh.point((*vertices_)[k]);
    }

    const Buffer<VertexId>* vertices_ = nullptr;
    Number infinite_ = no_index;
    Buffer<double> columns_;  // those of HoleColumns
    Buffer<Facet> facets_;
    Buffer<std::uint32_t> heads_;  // the newest facet of each head, or no_index
    std::size_t stride_ = 0, mask_ = 0;
    Buffer<Element> elements_;
    std::size_t ghosts_ = 0;
};

}  // namespace mgdt
