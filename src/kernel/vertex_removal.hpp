// SPDX-License-Identifier: MIT
// The removal of a vertex: the tetrahedra of its star leave a hole, which is filled with the
// tetrahedra of the Delaunay triangulation of the remaining points.
//
// All vertices of these tetrahedra are in the link of the vertex that goes, that is among the other
// vertices of its star. So the hole is filled facet by facet, inwards from its boundary. The
// tetrahedron at a facet is the one whose circumsphere has no vertex of the link inside: beyond the
// facet, spheres through it grow from one candidate to the next, and one pass over the link finds
// the least. Where no vertex is beyond, the facet is on the hull, and a ghost goes there. The
// kernel's find_apex() does this with vectors where floating-point arithmetic decides; elsewhere
// exact predicates do, and the perturbation leaves exactly one candidate. That takes time quadratic
// in the size of the link; a large one is triangulated by itself, and its tetrahedra inside the
// hole are sewn in. docs/theory.md, "Removing a vertex", proves that the result is the
// triangulation of all remaining points.
#pragma once

#include "kernel/kernel.hpp"
#include "platform/number_table.hpp"

namespace mgdt {

class VertexRemoval {
  public:
    explicit VertexRemoval(Allocator& allocator) noexcept;

    // Prepares the removal of vertex v, of which t is a tetrahedron: find() finds its star and its
    // link, then a fill finds what fills the hole. They throw std::bad_alloc, and a fill
    // MGDT_ERR_TOO_LARGE for too many tetrahedra; the mesh is unchanged in any case.
    void find(Mesh& mesh, VertexId v, TetId t);
    void fill(const Kernel& kernel, Mesh& mesh);
    // From a triangulation of the link, in which the points are in the order of link().
    void fill_from(const Mesh& triangulated_link, Mesh& mesh);
    // The vertices around the one that goes; perhaps that at infinity too.
    const Buffer<VertexId>& link() const noexcept { return link_; }
    // Whether the remaining points still span space. If not, there is nothing to replace.
    bool leaves_space() const noexcept { return leaves_space_; }
    // Gives back the room that is kept from one removal to the next.
    void reset() noexcept;
    // Vertices around the one that goes, without that at infinity.
    std::size_t link_size() const noexcept { return link_.size() - (infinite_ != no_index); }
    // Replaces the star by what was prepared; returns a tetrahedron that is new.
    TetId replace(Mesh& mesh) noexcept;
    // Keeps the star, so that undo() can put it back while nothing else has changed. Throws
    // std::bad_alloc; the mesh is unchanged in any case.
    void keep_star(const Mesh& mesh);
    // Returns a tetrahedron of the star.
    TetId undo(Mesh& mesh) noexcept;

  private:
    // A local number of a vertex of the link.
    using Number = std::uint32_t;
    // A tetrahedron as its record will be: the vertices of the facet from which it was found, and
    // the apex. Opposite the i-th vertex is the facet with this code. `is_outside`: a neighbour
    // that stays; else 4 * tetrahedron + face in the filling.
    struct Filling {
        Number v[4];
        FacetCode n[4];
        bool is_outside[4];
        Sphere sphere;
    };
    // A facet of the hole or of the filling, as the tetrahedron sees it that comes on its inner
    // side: (apex, v[0], v[1], v[2]) is positively oriented.
    struct Facet {
        Number v[3];
        FacetCode behind;  // the tetrahedron on its other side, as in Filling
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
    // The local number of a vertex of the link's triangulation.
    Number number_in(const Mesh& triangulated_link, VertexId u) const noexcept {
        if (u == infinite_vertex) return infinite_;
        const std::uint32_t i = triangulated_link.vertices[u].index;
        return i < infinite_ ? i : i + 1;
    }
    // Adds a facet; links the tetrahedra on its two sides when it comes for the second time.
    void join(const Number (&v)[3], FacetCode behind, bool is_outside);
    ApexResult apex_of(const Mesh& mesh, const Facet& facet) const;
    Sphere ghost_sphere(const Mesh& mesh, const Facet& facet) const;
    void close(const Mesh& mesh, std::size_t facet, ApexResult apex);
    const double* point(const Mesh& mesh, Number k) const noexcept { return mesh.point(link_[k]); }

    Buffer<TetId> star_;
    Buffer<VertexId> link_;   // by local number
    Buffer<double> columns_;  // x, y, z of the link, and what is skipped
    NumberTable numbers_;     // by vertex
    Buffer<Facet> facets_;
    NumberTable numbers_of_facets_;  // by their vertices
    Buffer<Filling> filling_;
    Buffer<FacetCode> slots_;
    Buffer<Tetrahedron> kept_;
    VertexId vertex_ = infinite_vertex;  // that goes
    TetId a_ghost_ = no_tetrahedron;     // of the mesh, when the star was kept
    std::size_t ghosts_gone_ = 0, ghosts_made_ = 0;
    Number infinite_ = no_index;  // the number of the vertex at infinity
    bool leaves_space_ = true;
};

}  // namespace mgdt
