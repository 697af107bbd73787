// SPDX-License-Identifier: MIT
// The region that clips the cells: a convex polyhedron, given by the planes that bound it.
#pragma once

#include "dual/corner.hpp"
#include "dual/polygon.hpp"
#include "mesh/mesh.hpp"

namespace mgdt {

class LongMemory;
class HalfSpaces;
class ExactPolygon;

class Region {
  public:
    // Each plane is four numbers a b c d, for a x + b y + c z <= d. The region refers to these
    // numbers, which must not move. Without planes the region is all of space. Throws an Error if a
    // number is not finite, a plane has no normal, a vertex is outside by more than rounding, or
    // the planes do not bound a region. Messages number planes and points from `base` on. Only
    // vertices with an index below `points` are tested; the others may be outside.
    Region(Allocator& allocator, std::size_t n, const double* planes, const Mesh& mesh,
           std::int32_t base, std::size_t points = static_cast<std::size_t>(-1));

    bool is_bounded() const noexcept { return !planes_.empty(); }
    // The number of planes that have a face of the region. Redundant planes are left out. Of
    // several planes that coincide, one is kept.
    std::size_t size() const noexcept { return planes_.size(); }
    // The numbers a b c d of plane k, as the caller gave them.
    const double* numbers(std::size_t k) const noexcept { return planes_[k].numbers; }
    // The position of plane k among the planes that the caller gave.
    std::uint32_t given(std::size_t k) const noexcept { return planes_[k].index; }
    // Whether all points, planes and corners are in the range of doubles and twofold numbers.
    bool is_ordinary() const noexcept { return is_ordinary_; }
    // An upper bound on the distance between two points of the region.
    double extent() const noexcept { return extent_; }
    // The half-space of plane k with `point` as the origin, and all lengths multiplied by `factor`.
    Side side(std::size_t k, const double* point, double factor) const;
    // A lower bound on the distance of a point from the nearest plane. The bound is negative if the
    // point may be outside, and NaN if is_ordinary() is false.
    double clearance(const double* point) const;
    // Sets `face` to the face in plane k, with `point` as the origin and all lengths multiplied by
    // `factor`. The label of an edge is the number of the edge's plane plus `first_label`. Edges
    // are counter-clockwise about the normal.
    void set_face(std::size_t k, const double* point, double factor, std::uint32_t first_label,
                  Polygon& face) const;

  private:
    struct Plane {
        const double* numbers;
        double normal[3], offset;
        double size;          // an upper bound on the length of the normal
        std::uint32_t index;  // the caller's number of the plane
        std::uint32_t first;  // the first corner of the plane's face
        double height(const double* p) const {
            return ((normal[0] * p[0] + normal[1] * p[1]) + normal[2] * p[2]) - offset;
        }
        double error(const double* p) const;
    };
    struct RegionCorner {
        Twofold x[3];
        double error;
        std::uint32_t label;  // the plane of the edge that follows the corner
    };
    void add_plane(std::size_t k, const double* of, const Mesh& mesh);
    bool is_beyond(const Plane& plane, const double* p, int scale, LongMemory& memory) const;
    void require_inside(const Mesh& mesh, std::size_t points) const;
    void set_faces(const Mesh& mesh);
    template <class F>
    void each_face(const double* near, int scale, F f) const;
    void add_face(const ExactPolygon& polygon, HalfSpaces& half_spaces, const double* near);
    // The number of a plane or point in messages.
    long long number(std::size_t k) const { return static_cast<long long>(k) + base_; }

    Buffer<Plane> planes_;
    Buffer<RegionCorner> corners_;
    std::int32_t base_;
    bool is_ordinary_ = true;
    double extent_ = 0;
};

}  // namespace mgdt
