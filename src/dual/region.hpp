// SPDX-License-Identifier: MIT
// The region that cells are clipped to: a convex polyhedron as the planes that bound it.
#pragma once

#include "dual/polygon.hpp"
#include "mesh/mesh.hpp"

namespace mgdt {

class Region {
  public:
    // Planes a b c d each: a x + b y + c z <= d. Everything if there are none. Throws Error where a
    // number is not finite, a plane has no normal, a vertex is outside by more than rounding, or
    // the planes do not bound the region. Messages count planes and points from `base`.
    Region(Allocator& allocator, std::size_t n, const double* planes, const Mesh& mesh,
           std::int32_t base);

    bool is_bounded() const noexcept { return !planes_.empty(); }
    std::size_t size() const noexcept { return planes_.size(); }
    // Bounds the distance of its points from one another.
    double extent() const noexcept { return extent_; }
    // The side of plane k relative to a point, which is at the origin then, all lengths times
    // `factor`.
    template <class Real>
    Side<Real> side(std::size_t k, const double* point, double factor) const;
    // A bound from below of the distance of a point from the nearest plane; negative for a point
    // that is outside by more than rounding.
    double clearance(const double* point) const;
    // The face in plane k, likewise, with the numbers of the other planes as labels, to which
    // `first_label` is added. It turns round the normal.
    template <class Real>
    void set_face(std::size_t k, const double* point, double factor, std::uint32_t first_label,
                  Polygon<Real>& face) const;

  private:
    struct Plane {
        double normal[3], offset;
        double size;          // length of the normal, at most
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
    void require_inside(const Mesh& mesh) const;
    void add_face(std::size_t k, const double* near, Polygon<Twofold>& polygon);
    // Of a plane, for messages.
    long long number(std::size_t k) const { return static_cast<long long>(k) + base_; }

    Buffer<Plane> planes_;
    Buffer<RegionCorner> corners_;
    double extent_ = 0;
    std::int32_t base_;
};

}  // namespace mgdt
