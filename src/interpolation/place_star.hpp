// SPDX-License-Identifier: MIT
// The star that a place would have if it were a vertex: the tetrahedra that it would remove, those
// that it would have, and how they meet. The mesh stays as it is, and many threads may look.
//
// Vertices have local numbers in the order of the caller's indices, and the corners of each part
// are sorted, so that what is computed from them does not depend on how the triangulation came
// about.
#pragma once

#include "kernel/kernel.hpp"
#include "kernel/thread_state.hpp"
#include "mesh/numbers.hpp"

namespace mgdt {

class PlaceStar {
  public:
    explicit PlaceStar(Allocator& allocator);

    using Number = std::uint32_t;
    // Positively oriented with these corners, or negatively if their order `is_odd`.
    struct Removed {
        Number corner[4];
        bool is_odd;
    };
    // The place and these corners, likewise.
    struct Created {
        Number corner[3];
        bool is_odd;
    };
    // Two tetrahedra, or triangles on the hull, that have a facet or an edge in common, by number;
    // a number of one that is created counts from the number of those removed on. With a point on
    // the side of `beyond` before the corners, they are positively oriented, or negatively if
    // their order `is_odd`.
    template <int corners>
    struct Meeting {
        std::uint32_t near, beyond;
        Number corner[corners];
        bool is_odd;
    };

    // q is a place in the mesh's scale, in tetrahedron t, and no vertex.
    void find(const Mesh& mesh, const KernelCalls& kernel, const double* q, TetId t);

    Number size() const noexcept { return static_cast<Number>(vertices_.size()); }
    VertexId vertex(Number k) const noexcept { return vertices_[k]; }
    // Whether it is on the hull. Then the rest is of no use if it is on a ridge; else it is a
    // star of triangles in one plane.
    bool is_on_hull() const noexcept { return is_on_hull_; }
    bool is_on_ridge() const noexcept { return is_on_ridge_; }

    const Buffer<Removed>& removed() const noexcept { return removed_; }
    const Buffer<Created>& created() const noexcept { return created_; }
    // Facets of those removed, which the place does not have.
    const Buffer<Meeting<3>>& old_facets() const noexcept { return old_facets_; }
    // Facets of the place, which is the first corner, with two more.
    const Buffer<Meeting<2>>& new_facets() const noexcept { return new_facets_; }

    // In a plane of the hull: triangles, whose third corner counts in those removed, and whose
    // second in those created. All are oriented alike.
    const Buffer<Removed>& removed_triangles() const noexcept { return removed_; }
    const Buffer<Created>& created_triangles() const noexcept { return created_; }
    const Buffer<Meeting<2>>& old_edges() const noexcept { return new_facets_; }
    struct NewEdge {
        std::uint32_t near, beyond;
        Number corner[1];
    };
    const Buffer<NewEdge>& new_edges() const noexcept { return new_edges_; }

  private:
    template <class Numbered>
    void build(const Mesh& mesh, const Numbered& numbers);
    void number_vertices(const Mesh& mesh, std::size_t count);
    template <class Lookup, class Edges>
    void build_in_space(const Mesh& mesh, Lookup number, Edges edges);
    template <class Lookup>
    void build_on_hull(const Mesh& mesh, Lookup number);

    Workspace workspace_;
    MarkTable marks_;
    Numbers members_;
    Buffer<VertexId> vertices_;
    // The caller's index above the number that the kernel gives a vertex; by that number, ours.
    Buffer<std::uint64_t> keys_;
    Buffer<Number> ranks_;
    struct Cycle {
        Number corner[3];
    };
    Buffer<Cycle> cycles_;  // corners of what is created, in a positive order
    Buffer<Removed> removed_;
    Buffer<Created> created_;
    Buffer<Meeting<3>> old_facets_;
    Buffer<Meeting<2>> new_facets_;
    Buffer<NewEdge> new_edges_;
    Buffer<std::uint32_t> from_;  // by vertex: the triangle whose edge begins there
    bool is_on_hull_ = false, is_on_ridge_ = false;
};

}  // namespace mgdt
