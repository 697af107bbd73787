// SPDX-License-Identifier: MIT
// The insertion of a point in a facet, or on a segment, of a mesh with walls.
#pragma once

#include "mesh/numbers.hpp"
#include "refinement/refined_mesh.hpp"
#include "refinement/wall_edges.hpp"

namespace mgdt {

// The cavity of the point is on all sides of the walls that it divides. These are chosen in the
// planes of their facets first; then the tetrahedra at them are members of the cavity, or the point
// is refused.
class WallInsertion {
  public:
    WallInsertion(RefinedMesh& mesh, Allocator& allocator)
        : mesh_(mesh),
          edges_{mesh.walled},
          divided_(allocator),
          rims_(allocator),
          members_(allocator),
          states_(allocator),
          queue_(allocator),
          boundary_(allocator),
          vertices_(allocator),
          star_edges_(allocator),
          star_(allocator),
          facets_(allocator),
          given_back_(allocator),
          around_(allocator) {}

    struct Segment {
        VertexId a = infinite_vertex, b = infinite_vertex;
        FacetCode wall = no_index;  // one that has it
    };
    // Finds the cavity of a point in a wall. A point that is near a segment around the walls that
    // it divides is refused, and `near` becomes that segment.
    Refusal find_in_wall(const double* q, FacetCode wall, Segment& near);
    Refusal find_on_segment(const double* q, const Segment& segment);
    // After one of them has found a cavity: the vertices of its boundary.
    const Numbers& vertices() const noexcept { return vertices_; }
    std::size_t slots_needed() const noexcept { return 2 * boundary_.size(); }
    // Inserts the point as vertex q, after one of them has found a cavity. take() gives a free
    // slot, and give(slot) takes one back.
    template <class Take, class Give>
    void insert(VertexId q, const Take& take, const Give& give) {
        given_back_.clear();
        list_facets();
        for (const TetId t : given_back_) give(t);
        star_.clear();
        for (std::size_t i = 0; i < facets_.size(); ++i) star_.push_back(take());
        fill(q);
        link(take);
    }
    // The tetrahedra of the last point that was inserted.
    const Buffer<TetId>& star() const noexcept { return star_; }

  private:
    // A divided wall's edge that stays, in the order of the wall's corners as seen from the side
    // `here`.
    struct Rim {
        VertexId x, y;
        FacetCode wall;
        LinkedMesh::Side here, there;
    };
    struct Facet {
        VertexId v[3];
        FacetCode outside;
        LinkedMesh::Side side;
        std::uint32_t region;
        bool is_wall;
    };
    struct StarEdge {
        VertexId x, y;
        FacetCode codes[2];  // of the faces of the star from x to y, and from y to x, or no_index
    };

    void clear();
    bool is_divided(FacetCode wall) const noexcept;
    // Adds the walls of a facet that the point divides to the list, beginning with `wall`, and adds
    // their rims.
    // Returns false if the point is near a segment, which `near` becomes then.
    bool divide_facet(const double* q, FacetCode wall, const Segment& divided, Segment* near);
    bool divide_at_segment(const double* q, FacetCode wall, const Segment& segment);
    Refusal dig(const double* q);
    Refusal shrink(const double* q);
    bool keeps_all();
    void add_member(TetId t);
    void list_facets();
    void fill(VertexId q);
    template <class Take>
    void link(const Take& take);
    void find_star_edges();
    void mark_walls();

    RefinedMesh& mesh_;
    const WallEdges edges_;
    Buffer<FacetCode> divided_;
    Buffer<Rim> rims_;
    Numbers members_;
    Buffer<std::uint8_t> states_;  // of members
    Buffer<TetId> queue_;
    Buffer<FacetCode> boundary_;  // the faces of the cavity's members at its boundary
    Numbers vertices_;
    PairTable star_edges_;
    Buffer<TetId> star_;
    Buffer<Facet> facets_;
    Buffer<TetId> given_back_;
    Buffer<StarEdge> around_;
};

template <class Take>
void WallInsertion::link(const Take& take) {
    find_star_edges();
    Mesh& mesh = mesh_.walled.mesh;
    for (const StarEdge& edge : around_) {
        const FacetCode one = edge.codes[0] != no_index ? edge.codes[0] : edge.codes[1];
        if (edge.codes[0] == no_index || edge.codes[1] == no_index) {
            mesh_.walled.make_ghost(take(), tetrahedron_of(one), face_of(one));
            continue;
        }
        const FacetCode other = edge.codes[1];
        mesh.tetrahedra[tetrahedron_of(one)].n[face_of(one)] = other;
        mesh.tetrahedra[tetrahedron_of(other)].n[face_of(other)] = one;
    }
    mark_walls();
}

}  // namespace mgdt
