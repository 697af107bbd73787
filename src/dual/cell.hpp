// SPDX-License-Identifier: MIT
// The Voronoi cell of one vertex, which is at the origin: the half-spaces of its neighbours, and
// the circumcentres of its tetrahedra as corners.
#pragma once

#include "dual/link.hpp"
#include "dual/polygon.hpp"

namespace mgdt {

// How circumcentres are computed: from differences in doubles, or corrected once, which makes them
// good to the last bits.
enum class Centers { plain, corrected };

class Cell {
  public:
    explicit Cell(Allocator& allocator)
        : sides_(allocator), corners_(allocator), indices_(allocator) {}

    // Of the vertex whose link is given. All lengths are multiplied by factor().
    void make(const Mesh& mesh, VertexId v, const Link& link, Centers centers);

    // By the numbers of the link's neighbours: the half of space that is nearer to the vertex. Not
    // of the vertex at infinity.
    const Side& side(std::size_t neighbor) const noexcept { return sides_[neighbor]; }
    // By the numbers of the link's triangles: that of a ghost is the way of a ray.
    const Corner& corner(std::size_t triangle) const noexcept { return corners_[triangle]; }
    bool is_bounded() const noexcept { return is_bounded_; }
    // False where the distances of neighbours differ by so much that doubles are of no use.
    bool is_ordinary() const noexcept { return is_ordinary_; }
    // Bounds the distance of the corners that are points.
    double radius() const noexcept { return radius_; }
    // A power of two that brings lengths into the range of doubles.
    double factor() const noexcept { return factor_; }
    // The caller's index of a neighbour.
    std::uint32_t index(std::size_t neighbor) const noexcept { return indices_[neighbor]; }

  private:
    void set_sides(const Mesh& mesh, VertexId v, const Link& link);
    void set_corner(const Mesh& mesh, VertexId v, const Link& link, std::size_t triangle,
                    Centers centers);
    bool set_plain_center(const LinkTriangle& triangle, Corner& corner) const;

    Buffer<Side> sides_;
    Buffer<Corner> corners_;
    Buffer<std::uint32_t> indices_;
    bool is_bounded_ = true, is_ordinary_ = true;
    double radius_ = 0, factor_ = 1;
};

}  // namespace mgdt
