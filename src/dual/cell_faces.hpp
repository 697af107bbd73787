// SPDX-License-Identifier: MIT
// The faces of a cell within a region, each as the cycle of the planes that its edges lie in,
// decided exactly.
#pragma once

#include "dual/cell.hpp"
#include "dual/exact_polygon.hpp"
#include "dual/region.hpp"

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
          slots_(allocator),
          first_(allocator),
          order_(allocator),
          rank_(allocator),
          ring_(allocator),
          cutting_(allocator),
          touches_(allocator) {}

    struct Face {
        PlaneNumber plane;
        std::size_t begin, end;  // of its edges
    };
    // The point where three planes meet, whose normals are positively oriented in this order.
    struct Corner {
        PlaneNumber plane[3];
    };
    // Of vertex v, whose link is given, and whose cell is bounded or which the region bounds.
    // Planes have the numbers of the neighbours in the order of their indices, and those of the
    // region from there on, so that nothing here depends on how the triangulation came about. Faces
    // of a cell without a region may have edges of no length; the others have none, and an area.
    void find(const Mesh& mesh, VertexId v, const Link& link, const Cell& cell,
              const Region& region);

    std::size_t size() const noexcept { return faces_.size(); }
    const Face& face(std::size_t i) const noexcept { return faces_[i]; }
    // The plane of edge i, counting from the face's begin.
    PlaneNumber edge(std::size_t i) const noexcept { return edges_[i]; }
    // The number of the corner before edge i.
    std::size_t corner_before(std::size_t i) const noexcept { return corner_of_edge_[i]; }
    const Buffer<Corner>& corners() const noexcept { return corners_; }
    HalfSpaces& half_spaces() noexcept { return half_spaces_; }

  private:
    void number_planes(const Mesh& mesh, VertexId v, const Link& link, const Cell& cell,
                       const Region& region);
    void find_cutting(const Link& link, const Cell& cell, const Region& region);
    void set_polygon(const Link& link, const Cell& cell, PlaneNumber plane);
    void add_whole(const Link& link, PlaneNumber plane);
    void add_polygon();
    void add_region_face(std::size_t cut);
    enum class Overlap { some, none, unknown };
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
    Buffer<std::uint32_t> slots_;         // by a hash of the planes: a corner's number, and 1
    Buffer<std::uint32_t> first_;         // by neighbour: a triangle of the link that has it
    Buffer<std::uint32_t> order_;         // by plane: the neighbour
    Buffer<PlaneNumber> rank_;            // by neighbour: the plane
    Buffer<PlaneNumber> ring_, cutting_;  // planes around a face; of the region, that may cut
    // Faces to neighbours that reach to a cutting plane, which is given by its place in cutting_.
    struct Touch {
        std::size_t cut;
        PlaneNumber neighbor;
    };
    Buffer<Touch> touches_;
};

}  // namespace mgdt
