// SPDX-License-Identifier: MIT
// The Voronoi cell of one vertex, with the vertex at the origin. The cell is given by one
// half-space per neighbour; its corners are the circumcentres of the tetrahedra at the vertex.
#pragma once

#include "dual/link.hpp"
#include "dual/polygon.hpp"

namespace mgdt {

// How circumcentres are computed: in doubles without correction, or with one step of correction,
// which leaves errors only in the last bits.
enum class Centers { plain, corrected };

class Cell {
  public:
    explicit Cell(Allocator& allocator)
        : sides_(allocator), corners_(allocator), indices_(allocator) {}

    // Sets the cell of vertex v, whose link is given. All lengths are multiplied by factor().
    void make(const Mesh& mesh, VertexId v, const Link& link, Centers centers);

    // The half-space of the points that are nearer to the vertex than to a neighbour. `neighbor` is
    // a number in the link, and must not be the number of the vertex at infinity.
    const Side& side(std::size_t neighbor) const noexcept { return sides_[neighbor]; }
    // The circumcentre of the tetrahedron that belongs to a triangle of the link. For a ghost, the
    // corner is the direction of a ray.
    const Corner& corner(std::size_t triangle) const noexcept { return corners_[triangle]; }
    bool is_bounded() const noexcept { return is_bounded_; }
    // False if the distances of the neighbours overflow, or differ so much that doubles are
    // useless.
    bool is_ordinary() const noexcept { return is_ordinary_; }
    // An upper bound on the distance of the finite corners from the vertex.
    double radius() const noexcept { return radius_; }
    // The power of two that brings lengths into the range of doubles.
    double factor() const noexcept { return factor_; }
    // The caller's index of the neighbour with this number in the link.
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
