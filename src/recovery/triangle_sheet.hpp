// SPDX-License-Identifier: MIT
// The last resort for a missing triangle: a sheet of faces along it, of which the inner vertices
// are then taken out.
#pragma once

#include "recovery/edge_ring.hpp"
#include "recovery/plane_center.hpp"
#include "recovery/triangle_walk.hpp"

namespace mgdt {

// Each edge that crosses the triangle is divided near the triangle. Then faces whose corners are
// these points and the corners of the triangle form a sheet, which is flat up to rounding. An inner
// vertex s of the sheet leaves so: the polygon of its neighbours in the sheet is triangulated
// without it, and what the tetrahedra at s fill is divided by the polygon in two sides. A vertex
// that sees all of a side, or else a new point close to s, is joined to the faces of the side.
class TriangleSheet {
  public:
    TriangleSheet(FlipMesh& mesh, Allocator& allocator)
        : mesh_(mesh),
          ring_(allocator),
          inner_(allocator),
          star_(allocator),
          side_of_(allocator),
          cycle_(allocator),
          polygon_(allocator),
          best_(allocator),
          stack_(allocator),
          center_(allocator),
          added_(allocator) {}

    // Makes the triangle a face. `walk` has the edges that cross it. Returns false, and leaves the
    // mesh as it was, if doubles do not suffice.
    bool recover(const std::uint32_t (&v)[3], const TriangleWalk& walk);

  private:
    bool build(const TriangleWalk& walk);
    bool divide_edge(std::uint32_t p, std::uint32_t q);
    bool withdraw(std::uint32_t s);
    bool find_cycle(std::uint32_t s);
    bool triangulate_cycle();
    double flatness(std::uint32_t a, std::uint32_t b, std::uint32_t c) const noexcept;
    bool find_sides(std::uint32_t s);
    bool fill_side(std::uint32_t side, std::uint32_t s);
    bool fill_from(std::uint32_t apex, std::uint32_t side, std::uint32_t s);
    bool is_on_sheet(std::uint32_t v) const noexcept;

    FlipMesh& mesh_;
    std::uint32_t corner_[3] = {};
    bool centers_ = true;    // whether new points are moved to the middle of what they fill
    double normal_[3] = {};  // of the triangle, with length 1
    EdgeRing ring_;
    Buffer<std::uint32_t> inner_;    // the vertices of the sheet, besides the corners
    Buffer<std::uint32_t> star_;     // the tetrahedra at s
    Buffer<std::uint32_t> side_of_;  // of each of them: 0 below, 1 above
    Buffer<std::uint32_t> cycle_;  // the neighbours of s in the sheet, counter-clockwise from above
    Buffer<std::uint32_t> polygon_;  // its triangles, three corners for each
    // The best triangulation of the cycle from one vertex to a later one.
    struct Part {
        double flatness;
        std::size_t middle;
    };
    Buffer<Part> best_;
    Buffer<std::uint32_t> stack_;
    PlaneCenter center_;
    Buffer<FlipMesh::Corners> added_;
};

}  // namespace mgdt
