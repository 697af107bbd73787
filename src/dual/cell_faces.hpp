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
          first_(allocator),
          order_(allocator),
          ring_(allocator),
          cutting_(allocator) {}

    struct Face {
        PlaneNumber plane;
        std::size_t begin, end;  // of its edges
    };
    // Of vertex v, whose link is given, and whose cell is bounded or which the region bounds. The
    // planes have the numbers of the link's neighbours, and those of the region from there on.
    // Faces of a cell without a region may have edges of no length; the others have none, and an
    // area.
    void find(const Mesh& mesh, VertexId v, const Link& link, const Cell& cell,
              const Region& region);

    std::size_t size() const noexcept { return faces_.size(); }
    const Face& face(std::size_t i) const noexcept { return faces_[i]; }
    // The plane of edge i, counting from the face's begin.
    PlaneNumber edge(std::size_t i) const noexcept { return edges_[i]; }
    HalfSpaces& half_spaces() noexcept { return half_spaces_; }
    // Of a power of two that makes lengths ordinary.
    int exponent() const noexcept { return exponent_; }

  private:
    void find_cutting(const Link& link, const Cell& cell, const Region& region);
    void set_polygon(const Link& link, const Cell& cell, std::uint32_t b);
    void add_whole(const Link& link, std::uint32_t b);
    void add_polygon();

    HalfSpaces half_spaces_;
    int exponent_ = 0;
    ExactPolygon polygon_;
    Buffer<Face> faces_;
    Buffer<PlaneNumber> edges_;
    Buffer<std::uint32_t> first_;         // by neighbour: a triangle of the link that has it
    Buffer<PlaneNumber> order_;           // neighbours by index
    Buffer<PlaneNumber> ring_, cutting_;  // planes around a face; of the region, that may cut
};

}  // namespace mgdt
