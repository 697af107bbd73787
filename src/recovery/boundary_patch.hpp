// SPDX-License-Identifier: MIT
// Triangles of the boundary that are recovered together.
#pragma once

#include "mesh/bounding_box.hpp"
#include "recovery/flip_mesh.hpp"
#include "solid/pair_table.hpp"

namespace mgdt {

// The patch of a missing edge has the triangles at this edge, those at their other missing edges,
// and so on. A wide patch has neighbours in nearly the same plane besides. All edges of the border
// are in the mesh.
class BoundaryPatch {
  public:
    // `kept` has the edges of `triangles`, which are those of the boundary.
    BoundaryPatch(FlipMesh& mesh, const PairTable& kept, const Buffer<std::uint32_t>& triangles,
                  Allocator& allocator)
        : mesh_(mesh),
          kept_(kept),
          triangles_(triangles),
          first_(allocator),
          at_edge_(allocator),
          state_(allocator),
          used_(allocator),
          corners_(allocator),
          vertices_(allocator),
          boxes_(allocator),
          inner_(allocator),
          border_(allocator) {}

    // Finds the patch of an edge. Returns false if a missing edge has not two triangles, if the
    // triangles have no common orientation, or if they do not all face a common direction.
    bool find(std::uint32_t a, std::uint32_t b);
    // Makes the patch wide. Returns false, as find() does, or if nothing is added, or too much.
    bool widen();

    // Adds those neighbours in nearly the same plane that have one of some edges. If there are
    // none, adds all neighbours in the plane. Returns false, as find() does, or if nothing is
    // added; then the patch has to be found anew.
    bool add_neighbors(const PairTable& edges);

    // The numbers of the triangles, and the number of triangles that the boundary has.
    const Buffer<std::uint32_t>& triangles() const noexcept { return used_; }
    std::size_t all_triangles() const noexcept { return triangles_.size() / 3; }
    // Three corners for each triangle, counter-clockwise as seen from above.
    const Buffer<std::uint32_t>& corners() const noexcept { return corners_; }
    bool has_vertex(std::uint32_t v) const noexcept {
        return std::binary_search(vertices_.begin(), vertices_.end(), v);
    }
    // The edges between the triangles.
    const PairTable& inner_edges() const noexcept { return inner_; }
    // The number of an edge of the border, or no_index.
    std::uint32_t border_number(std::uint32_t a, std::uint32_t b) const noexcept {
        return border_.find(a, b);
    }
    // Whether three vertices are the corners of a triangle of the boundary that is not in the
    // patch.
    bool is_outer_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) const noexcept;
    // Whether all edges of the patch are in the mesh.
    bool is_in_mesh();
    // The direction in which above is. Its length is 1.
    const double (&normal() const noexcept)[3] { return normal_; }
    const double (&middle() const noexcept)[3] { return middle_; }
    // Twice the area of a triangle as seen from above, which is positive if its corners appear
    // counter-clockwise.
    double area(const double* a, const double* b, const double* c) const noexcept;
    // The largest distance of a vertex from the middle.
    double radius() const noexcept { return radius_; }
    // Whether an edge of the mesh crosses the inside of a triangle; or runs along it, up to
    // rounding, between two vertices of the patch.
    bool is_met_by(std::uint32_t a, std::uint32_t b) const noexcept;

  private:
    // An edge of a triangle of the patch, in its orientation, and the neighbour of the triangle
    // there, which is no_index unless the edge belongs to two triangles.
    struct Edge {
        std::uint32_t from, to, neighbor;
    };

    void list_triangles_at_edges();
    Edge edge_at(std::size_t corner) const noexcept;
    bool extend(bool is_wide);
    bool is_in_plane(std::uint32_t v) const noexcept;
    bool is_edge(std::uint32_t a, std::uint32_t b);
    bool add(std::uint32_t triangle, std::uint32_t from, std::uint32_t to);
    bool measure();
    std::size_t triangle_at(const double (&x)[3]) const noexcept;

    FlipMesh& mesh_;
    const PairTable& kept_;
    const Buffer<std::uint32_t>& triangles_;
    Buffer<std::uint32_t> first_, at_edge_;  // the triangles at each kept edge
    // Of each triangle: 0 outside of the patch, 1 in it, 2 in it with the other orientation.
    Buffer<std::uint8_t> state_;
    Buffer<std::uint32_t> used_;  // the triangles of the patch
    Buffer<std::uint32_t> corners_;
    Buffer<std::uint32_t> vertices_;  // in ascending order
    Buffer<BoundingBox> boxes_;       // of the triangles
    PairTable inner_, border_;
    double normal_[3] = {}, middle_[3] = {}, radius_ = 0;
};

}  // namespace mgdt
