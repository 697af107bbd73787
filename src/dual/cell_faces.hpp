// SPDX-License-Identifier: MIT
// The faces of a cell within a region. Each face is given by the cycle of the planes that contain
// its edges. All decisions are exact.
#pragma once

#include "dual/cell.hpp"
#include "dual/exact_polygon.hpp"
#include "dual/overlap.hpp"
#include "dual/region.hpp"
#include "platform/number_table.hpp"

namespace mgdt {

class CellFaces {
  public:
    explicit CellFaces(Allocator& allocator)
        : half_spaces_(allocator),
          polygon_(allocator, half_spaces_),
          faces_(allocator),
          edges_(allocator),
          corner_of_edge_(allocator),
          corners_(allocator),
          corner_numbers_(allocator),
          first_(allocator),
          order_(allocator),
          rank_(allocator),
          ring_(allocator),
          cutting_(allocator),
          touches_(allocator) {}

    struct Face {
        PlaneNumber plane;
        std::size_t begin, end;  // the range of its edges
    };
    // The point where three planes meet. Their normals are positively oriented in this order.
    struct Corner {
        PlaneNumber plane[3];
    };
    // Finds the faces of the cell of vertex v, whose link is given. The cell or the region must be
    // bounded. The result depends on the points alone, because the planes of the neighbours are
    // numbered in the order of the neighbours' indices; the planes of the region follow. If no
    // plane of the region may cut the cell, faces may have edges of length 0. Otherwise all edges
    // have a positive length and all faces a positive area.
    void find(const Mesh& mesh, VertexId v, const Link& link, const Cell& cell,
              const Region& region);

    std::size_t size() const noexcept { return faces_.size(); }
    const Face& face(std::size_t i) const noexcept { return faces_[i]; }
    // The plane of edge i; a face's edges are face.begin to face.end - 1.
    PlaneNumber edge(std::size_t i) const noexcept { return edges_[i]; }
    // The number of the corner before edge i.
    std::size_t corner_before(std::size_t i) const noexcept { return corner_of_edge_[i]; }
    const Buffer<Corner>& corners() const noexcept { return corners_; }
    // The number of planes that bisect the vertex and a neighbour; those of the region follow.
    std::size_t bisectors() const noexcept { return order_.size(); }
    // The number in the link of the neighbour that a bisector belongs to.
    std::size_t neighbor(PlaneNumber plane) const noexcept { return order_[plane]; }
    HalfSpaces& half_spaces() noexcept { return half_spaces_; }

  private:
    void number_planes(const Mesh& mesh, VertexId v, const Link& link, const Cell& cell,
                       const Region& region);
    void find_cutting(const Link& link, const Cell& cell, const Region& region);
    void set_polygon(const Link& link, const Cell& cell, PlaneNumber plane);
    void add_whole(const Link& link, PlaneNumber plane);
    void add_polygon();
    void add_region_face(std::size_t cut);
    Overlap overlap_with_cell();
    void add_face(PlaneNumber plane);
    void number_corners();
    std::uint32_t corner_number(const Corner& corner);

    HalfSpaces half_spaces_;
    ExactPolygon polygon_;
    Buffer<Face> faces_;
    Buffer<PlaneNumber> edges_;
    Buffer<std::uint32_t> corner_of_edge_;
    Buffer<Corner> corners_;
    NumberTable corner_numbers_;   // by the corners' planes
    Buffer<std::uint32_t> first_;  // for each neighbour the triangle where its ring starts
    Buffer<std::uint32_t> order_;  // the neighbour of each plane
    Buffer<PlaneNumber> rank_;     // the plane of each neighbour
    Buffer<PlaneNumber> ring_;     // the planes of the edges of a face
    Buffer<PlaneNumber> cutting_;  // the planes of the region that may cut the cell
    // The face of a neighbour that reaches a cutting plane; `cut` is the index of that plane in
    // cutting_.
    struct Touch {
        std::size_t cut;
        PlaneNumber neighbor;
    };
    Buffer<Touch> touches_;
};

}  // namespace mgdt
