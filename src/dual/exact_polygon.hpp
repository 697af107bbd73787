// SPDX-License-Identifier: MIT
// A convex polygon in the plane of a half-space, as the cycle of the planes that its edges lie in.
// What other half-spaces leave of it is decided exactly; coordinates only save time.
#pragma once

#include "dual/half_spaces.hpp"

namespace mgdt {

class ExactPolygon {
  public:
    ExactPolygon(Allocator& allocator, HalfSpaces& half_spaces)
        : half_spaces_(half_spaces), corners_(allocator), next_(allocator), signs_(allocator) {}

    PlaneNumber plane() const noexcept { return plane_; }
    // Polygons have an area, or no corners.
    bool is_empty() const noexcept { return corners_.empty(); }
    std::size_t size() const noexcept { return corners_.size(); }
    // Edges turn counter-clockwise about the normal; edge i follows corner i.
    PlaneNumber edge(std::size_t i) const noexcept { return corners_[i].edge; }
    PlaneNumber edge_before(std::size_t i) const noexcept {
        return corners_[i == 0 ? corners_.size() - 1 : i - 1].edge;
    }

    // Makes it nearly all of a plane.
    void set_far(PlaneNumber plane);
    // Makes it one whose corners are added next, each with the edge that follows it: points, no two
    // in the same place, with bounds of their errors.
    void begin(PlaneNumber plane) {
        plane_ = plane;
        corners_.clear();
    }
    void add(const Corner& at, PlaneNumber edge) { corners_.push_back({at, edge}); }

    // Leaves what is in half-space s, and returns whether some of the polygon was on its plane or
    // beyond. If both planes are one, the polygon stays only where both normals have one direction
    // and the caller says so.
    bool clip(PlaneNumber s, bool stays_if_equal);
    // +1 where corner i is outside half-space s, 0 on its plane, -1 inside.
    int sign_at(std::size_t i, PlaneNumber s);

  private:
    struct LabelledCorner {
        Corner at;  // may be unknown: its error is infinite then
        PlaneNumber edge;
    };
    // Where the edge before meets the one after.
    LabelledCorner corner(PlaneNumber before, PlaneNumber after) const;

    HalfSpaces& half_spaces_;
    PlaneNumber plane_ = 0;
    Buffer<LabelledCorner> corners_, next_;
    Buffer<std::int8_t> signs_;
};

}  // namespace mgdt
