// SPDX-License-Identifier: MIT
// The removal of a vertex: the tetrahedra of its star leave a hole, which is filled with the
// tetrahedra of the Delaunay triangulation of the remaining points.
//
// All vertices of these tetrahedra are in the link of the removed vertex, that is among the other
// vertices of its star. docs/theory.md, "Removing a vertex", proves that the result is the
// triangulation of all remaining points.
#pragma once

#include "hole/filling.hpp"
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
    // A facet of the star's boundary, see Filling::add_boundary().
    struct BoundaryFacet {
        Filling::Number v[3];
        FacetCode behind;
    };

    void find_star(Mesh& mesh, VertexId v, TetId t);
    void number_link(const Mesh& mesh, VertexId v);
    void begin_filling();
    void make_room(Mesh& mesh);

    Buffer<TetId> star_;
    Buffer<VertexId> link_;  // the vertex of each local number
    NumberTable numbers_;    // the local number of each vertex
    Buffer<BoundaryFacet> boundary_;
    Filling filling_;
    Buffer<FacetCode> slots_;
    Buffer<Tetrahedron> kept_;
    VertexId vertex_ = infinite_vertex;  // the vertex to remove
    TetId a_ghost_ = no_tetrahedron;     // Mesh::a_ghost when the star was saved
    std::size_t ghosts_gone_ = 0;
    // The local number of the vertex at infinity, if it is in the link.
    Filling::Number infinite_ = no_index;
    bool leaves_space_ = true;
};

}  // namespace mgdt
