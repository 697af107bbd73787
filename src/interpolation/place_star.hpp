// SPDX-License-Identifier: MIT
// The star that a place would have if it were a vertex: the tetrahedra that the place would remove,
// the tetrahedra that the place would create, and how the created ones are adjacent. The mesh does
// not change, so many threads may use one mesh at the same time.
//
// Vertices have local numbers in the order of the caller's indices, and the corners of each part
// are sorted. So results that are computed from the star do not depend on the order of insertion.
#pragma once

#include "kernel/kernel.hpp"
#include "kernel/thread_state.hpp"
#include "mesh/numbers.hpp"

namespace mgdt {

class PlaceStar {
  public:
    explicit PlaceStar(Allocator& allocator);

    using Number = std::uint32_t;
    // Corners in ascending order. Their orientation is positive, or negative if `is_odd`.
    template <int corners>
    struct Simplex {
        Number corner[corners];
        bool is_odd;
    };
    using Removed = Simplex<4>;  // a tetrahedron that the place would remove
    using Created = Simplex<3>;  // a tetrahedron that would be created: the place and the corners
    // Two tetrahedra with a common facet, or two triangles on the hull with a common edge, by
    // number. Created tetrahedra or triangles are numbered after the removed ones. A point on the
    // side of `beyond`, followed by the corners, is positively oriented, or negatively if `is_odd`.
    template <int corners>
    struct Meeting {
        std::uint32_t near, beyond;
        Number corner[corners];
        bool is_odd;
    };

    // Finds the star of q, a place in the mesh's scale that is in tetrahedron t and is no vertex.
    void find(const Mesh& mesh, const KernelCalls& kernel, const double* q, TetId t);

    Number size() const noexcept { return static_cast<Number>(vertices_.size()); }
    VertexId vertex(Number k) const noexcept { return vertices_[k]; }
    // Whether the place is on the hull. If so, the star consists of triangles in a plane. If the
    // place is on a ridge, the star must not be used.
    bool is_on_hull() const noexcept { return is_on_hull_; }
    bool is_on_ridge() const noexcept { return is_on_ridge_; }

    const Buffer<Removed>& removed() const noexcept { return removed_; }
    const Buffer<Created>& created() const noexcept { return created_; }
    // The facets of the removed tetrahedra. Each is between two removed tetrahedra, or between a
    // removed and a created one.
    const Buffer<Meeting<3>>& old_facets() const noexcept { return old_facets_; }
    // The facets between two created tetrahedra. The first corner of each is the place, which is
    // not stored; the two other corners are.
    const Buffer<Meeting<2>>& new_facets() const noexcept { return new_facets_; }

    // If the place is on the hull: the triangles that the place would remove, the triangles that it
    // would create (the place and two corners), and the edges of the removed triangles. All
    // triangles have the same orientation.
    const Buffer<Simplex<3>>& removed_triangles() const noexcept { return removed_triangles_; }
    const Buffer<Simplex<2>>& created_triangles() const noexcept { return created_triangles_; }
    const Buffer<Meeting<2>>& old_edges() const noexcept { return old_edges_; }
    // The number of all tetrahedra, or of all triangles on the hull, removed and created.
    std::size_t simplices() const noexcept {
        return removed_.size() + created_.size() + removed_triangles_.size() +
               created_triangles_.size();
    }
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
    // For each vertex the caller's index in the upper half and the kernel's number in the lower
    // half; the position in this array is the local number.
    Buffer<std::uint64_t> keys_;
    Buffer<Number> ranks_;
    struct Cycle {
        Number corner[3];
    };
    Buffer<Cycle> cycles_;  // the corners of created tetrahedra, in a positive order
    Buffer<Removed> removed_;
    Buffer<Created> created_;
    Buffer<Meeting<3>> old_facets_;
    Buffer<Meeting<2>> new_facets_;
    Buffer<Simplex<3>> removed_triangles_;
    Buffer<Simplex<2>> created_triangles_;
    Buffer<Meeting<2>> old_edges_;
    Buffer<NewEdge> new_edges_;
    Buffer<std::uint32_t> from_;  // by vertex: the created triangle whose edge begins at it
    bool is_on_hull_ = false, is_on_ridge_ = false;
};

}  // namespace mgdt
