// SPDX-License-Identifier: MIT
// Takes a vertex out of a chain of two edges, so that its ends are joined by an edge.
#pragma once

#include "recovery/plane_center.hpp"

namespace mgdt {

// Let s be a vertex that is nearly on the line between its neighbours u and w. Everything that the
// tetrahedra at s fill is visible from s, and so from each point near s. Half-planes from u w cut
// it into sectors, which are filled from new points near s, one for each sector. There are two
// kinds of borders between sectors. A wall is a triangle (u, w, c) with a neighbour c of all three.
// Elsewhere a border is a path of edges from u to w that are opposite s: the new points z and y on
// its two sides are joined, in tetrahedra (u, w, z, y) and (z, y, l, m) for each edge l m of the
// path.
class Withdrawal {
  public:
    Withdrawal(FlipMesh& mesh, Allocator& allocator)
        : mesh_(mesh),
          star_(allocator),
          sector_of_(allocator),
          borders_(allocator),
          paths_(allocator),
          stack_(allocator),
          points_(allocator),
          center_(allocator),
          added_(allocator) {}

    // Whether new points are moved away from s, to the middle of what they fill. That makes better
    // tetrahedra, but may leave less room for the next vertex of a chain.
    void set_centers(bool centers) noexcept { centers_ = centers; }

    // Removes s and joins u and w. Returns false, and leaves the mesh changed, if doubles do not
    // suffice.
    bool run(std::uint32_t u, std::uint32_t s, std::uint32_t w);

  private:
    // A border. The inner vertices of its path are paths_[first] to paths_[end - 1]; a wall has
    // one. Sector i comes after border i, counter-clockwise as seen from w.
    struct Border {
        std::size_t first, end;
        bool is_wall;
        double angle;  // around the edge from u to w, ascending
    };

    void set_frame();
    double angle_of(std::uint32_t v) const noexcept;
    double distance_of(std::uint32_t v) const noexcept;  // from the axis
    void find_walls();
    bool add_path(double angle);
    bool find_sectors();
    bool is_on_border(std::uint32_t a, std::uint32_t b) const noexcept;
    bool enter(std::uint32_t t, std::uint32_t sector);
    std::uint32_t link_neighbor(std::size_t i, unsigned k) const noexcept;
    bool is_simple(std::size_t sector) const noexcept;
    double angle_of_point(std::size_t sector) const noexcept;
    bool fill_sectors();
    void center_points();
    bool fill(double share);
    void place_points(double share);
    void add(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        added_.push_back({{a, b, c, d}});
    }

    FlipMesh& mesh_;
    std::uint32_t u_ = 0, s_ = 0, w_ = 0;
    bool centers_ = true;
    double axis_[3], across_[3], up_[3];  // the direction from u to w, and two at right angles
    Buffer<std::uint32_t> star_;          // the tetrahedra at s
    Buffer<std::uint32_t> sector_of_;     // of each of them
    Buffer<Border> borders_;
    Buffer<std::uint32_t> paths_, stack_;
    Buffer<std::uint32_t> points_;  // of each sector, or no_index if it is one tetrahedron
    PlaneCenter center_;
    Buffer<FlipMesh::Corners> added_;
};

}  // namespace mgdt
