// SPDX-License-Identifier: MIT
// A convex polygon in the plane of a half-space, given as the cycle of the planes that contain its
// edges. Clipping by other half-spaces is decided exactly. The coordinates of corners only make
// most decisions faster.
#pragma once

#include "dual/half_spaces.hpp"

namespace mgdt {

class ExactPolygon {
  public:
    ExactPolygon(Allocator& allocator, HalfSpaces& half_spaces)
        : half_spaces_(half_spaces), corners_(allocator), next_(allocator), signs_(allocator) {}

    PlaneNumber plane() const noexcept { return plane_; }
    // A polygon has a positive area, or is empty.
    bool is_empty() const noexcept { return corners_.empty(); }
    std::size_t size() const noexcept { return corners_.size(); }
    // Edges are counter-clockwise about the normal; edge i follows corner i.
    PlaneNumber edge(std::size_t i) const noexcept { return corners_[i].edge; }
    PlaneNumber edge_before(std::size_t i) const noexcept {
        return corners_[i == 0 ? corners_.size() - 1 : i - 1].edge;
    }

    // Sets the polygon to a triangle of far planes, which contains every bounded polygon in the
    // plane.
    void set_far(PlaneNumber plane);
    // Begins a polygon whose corners are added next, each with the edge that follows it. The
    // corners are finite and distinct, with bounds on their errors.
    void begin(PlaneNumber plane) {
        plane_ = plane;
        corners_.clear();
    }
    void add(const Corner& at, PlaneNumber edge) { corners_.push_back({at, edge}); }

    // Clips the polygon by half-space s. Returns whether some part of it was on the plane of s or
    // beyond. If the two planes coincide, the polygon stays if both normals have the same direction
    // and the caller passes stays_if_equal.
    bool clip(PlaneNumber s, bool stays_if_equal);
    // +1 if corner i is outside half-space s, 0 on its plane, -1 inside.
    int sign_at(std::size_t i, PlaneNumber s);

  private:
    struct LabelledCorner {
        Corner at;  // the error is infinite if the coordinates are not known
        PlaneNumber edge;
    };
    // The corner where two consecutive edges meet.
    LabelledCorner corner(PlaneNumber before, PlaneNumber after) const;

    HalfSpaces& half_spaces_;
    PlaneNumber plane_ = 0;
    Buffer<LabelledCorner> corners_, next_;
    Buffer<std::int8_t> signs_;
};

}  // namespace mgdt
