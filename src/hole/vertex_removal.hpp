// SPDX-License-Identifier: MIT
// The removal of a vertex: the tetrahedra of its star leave a hole, which is filled with the
// tetrahedra of the Delaunay triangulation of the remaining points.
//
// All vertices of these tetrahedra are in the link of the removed vertex, that is among the other
// vertices of its star. So the hole is filled facet by facet, inwards from its boundary. The
// tetrahedron at a facet joins the facet to an apex: a vertex of the link on the inner side of the
// facet. The circumsphere of this tetrahedron has no vertex of the link inside, so one pass over
// the link finds the apex: a vertex inside the sphere of the best candidate becomes the best. If no
// vertex is on the inner side, the facet is on the hull and gets a ghost. The kernel's
// find_apex() finds the apex with vector instructions where floating-point arithmetic decides.
// Elsewhere exact predicates decide, and the perturbation leaves exactly one apex. Filling facet by
// facet takes time quadratic in the size of the link. A large link is therefore triangulated by
// itself, and its tetrahedra inside the hole are copied. docs/theory.md, "Removing a vertex",
// proves that the result is the triangulation of all remaining points.
#pragma once

#include "kernel/kernel.hpp"
#include "platform/number_table.hpp"

namespace mgdt {

class VertexRemoval {
  public:
    explicit VertexRemoval(Allocator& allocator) noexcept;

    // Prepare the removal of vertex v, where t is a tetrahedron of v. find() finds the star and the
    // link; then fill() or fill_from() finds the tetrahedra that fill the hole. All three throw
    // std::bad_alloc; fill() and fill_from() also throw MGDT_ERR_TOO_LARGE for too many tetrahedra.
    // The tetrahedra of the mesh do not change.
    void find(Mesh& mesh, VertexId v, TetId t);
    void fill(const Kernel& kernel, Mesh& mesh);
    // Takes the tetrahedra from a triangulation of the link. The points of that triangulation are
    // the finite vertices of link(), in the same order.
    void fill_from(const Mesh& triangulated_link, Mesh& mesh);
    // The vertices of the link, possibly with the vertex at infinity.
    const Buffer<VertexId>& link() const noexcept { return link_; }
    // Whether the remaining points still span space. If not, no finite tetrahedra would remain, and
    // callers do not call replace().
    bool leaves_space() const noexcept { return leaves_space_; }
    // Frees the memory that is kept from one removal to the next.
    void reset() noexcept;
    // The number of finite vertices in the link.
    std::size_t link_size() const noexcept { return link_.size() - (infinite_ != no_index); }
    // Replaces the star by the prepared tetrahedra. Returns one of them.
    TetId replace(Mesh& mesh) noexcept;
    // Saves the star, so that undo() can restore it if nothing else has changed. Throws
    // std::bad_alloc. The mesh does not change.
    void keep_star(const Mesh& mesh);
    // Restores the star. Returns one of its tetrahedra.
    TetId undo(Mesh& mesh) noexcept;

  private:
    // The local number of a vertex in the link.
    using Number = std::uint32_t;
    // A tetrahedron that fills the hole, with its vertices in the order of the record. n[i] is the
    // facet code on the other side of the facet opposite vertex i: of a neighbour outside the hole
    // if is_outside[i], otherwise of a tetrahedron in `filling_`.
    struct Filling {
        Number v[4];
        FacetCode n[4];
        bool is_outside[4];
        Sphere sphere;
    };
    // A facet of the hole or of the filling, oriented for the tetrahedron on its inner side:
    // (apex, v[0], v[1], v[2]) is positively oriented.
    struct Facet {
        Number v[3];
        FacetCode behind;  // the facet code on the other side, as in Filling
        bool is_outside, is_closed;
    };

    void find_star(Mesh& mesh, VertexId v, TetId t);
    void number_link(const Mesh& mesh, VertexId v);
    LinkColumns columns_of_link(const Mesh& mesh);
    Number number_of(VertexId v) const noexcept;
    void begin_filling(const Mesh& mesh);
    void end_filling(Mesh& mesh);
    void add_boundary(const Mesh& mesh);
    Buffer<FacetCode> boundary_in(const Mesh& triangulated_link);
    // The local number in the link for vertex u of the link's triangulation.
    Number number_in(const Mesh& triangulated_link, VertexId u) const noexcept {
        if (u == infinite_vertex) return infinite_;
        const std::uint32_t i = triangulated_link.vertices[u].index;
        return i < infinite_ ? i : i + 1;
    }
    // Adds a facet. When it is added for the second time, links the tetrahedra on its two sides.
    void join(const Number (&v)[3], FacetCode behind, bool is_outside);
    ApexResult apex_of(const Mesh& mesh, const Facet& facet) const;
    Sphere ghost_sphere(const Mesh& mesh, const Facet& facet) const;
    void close(const Mesh& mesh, std::size_t facet, ApexResult apex);
    const double* point(const Mesh& mesh, Number k) const noexcept { return mesh.point(link_[k]); }

    Buffer<TetId> star_;
    Buffer<VertexId> link_;   // the vertex of each local number
    Buffer<double> columns_;  // the columns of LinkColumns
    NumberTable numbers_;     // the local number of each vertex
    Buffer<Facet> facets_;
    NumberTable numbers_of_facets_;  // the number of each facet, by its vertices
    Buffer<Filling> filling_;
    Buffer<FacetCode> slots_;
    Buffer<Tetrahedron> kept_;
    VertexId vertex_ = infinite_vertex;  // the vertex to remove
    TetId a_ghost_ = no_tetrahedron;     // Mesh::a_ghost when the star was saved
    std::size_t ghosts_gone_ = 0, ghosts_made_ = 0;
    Number infinite_ =
        no_index;  // the local number of the vertex at infinity, if it is in the link
    bool leaves_space_ = true;
};

}  // namespace mgdt
