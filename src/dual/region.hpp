// SPDX-License-Identifier: MIT
// The region that cells are clipped to: a convex polyhedron as the planes that bound it.
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
    // Planes a b c d each: a x + b y + c z <= d. Everything if there are none. Throws Error where a
    // number is not finite, a plane has no normal, a vertex is outside by more than rounding, or
    // the planes do not bound a region. Messages count planes and points from `base`. The planes
    // stay where they are.
    Region(Allocator& allocator, std::size_t n, const double* planes, const Mesh& mesh,
           std::int32_t base);

    bool is_bounded() const noexcept { return !planes_.empty(); }
    // Planes that have a face of the region each: one of those that are equal, and none of those
    // that leave nothing out.
    std::size_t size() const noexcept { return planes_.size(); }
    // a b c d of plane k, as the caller gave them.
    const double* numbers(std::size_t k) const noexcept { return planes_[k].numbers; }
    // Whether doubles and twofold numbers hold the planes and corners.
    bool is_ordinary() const noexcept { return is_ordinary_; }
    // Bounds the distance of its points from one another.
    double extent() const noexcept { return extent_; }
    // The side of plane k relative to a point, which is at the origin then, all lengths times
    // `factor`.
    Side side(std::size_t k, const double* point, double factor) const;
    // A bound from below of the distance of a point from the nearest plane; negative for a point
    // that is outside by more than rounding, NaN where it is not known.
    double clearance(const double* point) const;
    // The face in plane k, likewise, with the numbers of the other planes as labels, to which
    // `first_label` is added. It turns round the normal.
    void set_face(std::size_t k, const double* point, double factor, std::uint32_t first_label,
                  Polygon& face) const;

  private:
    struct Plane {
        const double* numbers;
        double normal[3], offset;
        double size;          // length of the normal, at most
        std::uint32_t index;  // the caller's
        std::uint32_t first;  // of its corners
        double height(const double* p) const {
            return ((normal[0] * p[0] + normal[1] * p[1]) + normal[2] * p[2]) - offset;
        }
        double error(const double* p) const;
    };
    struct RegionCorner {
        Twofold x[3];
        double error;
        std::uint32_t label;  // the plane of the edge that follows
    };
    void add_plane(std::size_t k, const double* of, const Mesh& mesh);
    bool is_beyond(const Plane& plane, const double* p, int scale, LongMemory& memory) const;
    void require_inside(const Mesh& mesh) const;
    void set_faces(const Mesh& mesh);
    void add_face(const ExactPolygon& polygon, HalfSpaces& half_spaces, const double* near);
    // Of a plane or point, for messages.
    long long number(std::size_t k) const { return static_cast<long long>(k) + base_; }

    Buffer<Plane> planes_;
    Buffer<RegionCorner> corners_;
    std::int32_t base_;
    bool is_ordinary_ = true;
    double extent_ = 0;
};

}  // namespace mgdt
