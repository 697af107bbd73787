// SPDX-License-Identifier: MIT
#include "dual/region.hpp"

#include <algorithm>
#include <limits>

#include "mesh/scale.hpp"
#include "platform/error.hpp"

namespace mgdt {
namespace {

constexpr double u = rounding_of<double>;

double largest_of(const double* v) {
    return std::fmax(std::fmax(std::fabs(v[0]), std::fabs(v[1])), std::fabs(v[2]));
}

// normal . p - offset.
Twofold exact_height(const double* normal, double offset, const double* p) {
    Twofold sum = {-offset, 0};
    for (int i = 0; i < 3; ++i) sum = sum + Twofold::product(normal[i], p[i]);
    return sum;
}

}  // namespace

double Region::Plane::error(const double* p) const {
    return 6 * u *
           (size * (std::fabs(p[0]) + std::fabs(p[1]) + std::fabs(p[2])) + std::fabs(offset));
}

Region::Region(Allocator& allocator, std::size_t n, const double* planes, const Mesh& mesh,
               std::int32_t base)
    : planes_(allocator), corners_(allocator), base_(base) {
    planes_.reserve(n);
    for (std::size_t k = 0; k < n; ++k) {
        const double* const of = planes + 4 * k;
        for (int i = 0; i < 4; ++i)
            if (!std::isfinite(of[i]))
                fail(MGDT_ERR_NOT_FINITE, "plane %lld has a number that is not finite", number(k));
        const double largest = largest_of(of);
        if (largest == 0) fail(MGDT_ERR_INVALID_ARGUMENT, "plane %lld has no normal", number(k));
        // Lengths of normals between 1 and 4, by powers of two.
        const int shift = -std::ilogb(largest);
        Plane plane;
        for (int i = 0; i < 3; ++i) plane.normal[i] = scaled(of[i], shift);
        plane.offset = scaled(of[3], shift + mesh.scale);
        if (!(std::fabs(plane.offset) < 0x1p900))
            fail(MGDT_ERR_INVALID_ARGUMENT, "plane %lld is too far from the points", number(k));
        plane.size =
            std::hypot(std::hypot(plane.normal[0], plane.normal[1]), plane.normal[2]) * (1 + 8 * u);
        plane.first = 0;
        planes_.push_back(plane);
    }
    require_inside(mesh);
    Polygon<Twofold> polygon(allocator);
    // One that does not depend on the order of insertion.
    VertexId first = 1;
    for (VertexId v = 2; v < mesh.vertices.size(); ++v)
        if (mesh.vertices[v].index < mesh.vertices[first].index) first = v;
    for (std::size_t k = 0; k < n; ++k) add_face(k, mesh.point(first), polygon);
}

// Names the first point that is outside.
void Region::require_inside(const Mesh& mesh) const {
    constexpr std::uint32_t none = 0xffffffffu;
    std::uint32_t point = none;
    std::size_t plane = 0;
    for (VertexId v = 1; v < mesh.vertices.size(); ++v) {
        const double* const p = mesh.point(v);
        for (std::size_t k = 0; k < planes_.size(); ++k)
            if (mesh.vertices[v].index < point && planes_[k].height(p) > planes_[k].error(p)) {
                point = mesh.vertices[v].index;
                plane = k;
            }
    }
    if (point != none)
        fail(MGDT_ERR_INVALID_ARGUMENT, "point %lld is beyond plane %lld", number(point),
             number(plane));
}

// What the other planes leave of a triangle that is far too large.
void Region::add_face(std::size_t k, const double* near, Polygon<Twofold>& polygon) {
    using V = Vector<Twofold>;
    planes_[k].first = static_cast<std::uint32_t>(corners_.size());
    const Plane& plane = planes_[k];
    const auto side_of = [&](std::size_t j) {
        Side<Twofold> side;
        for (int i = 0; i < 3; ++i) side.normal.x[i] = {planes_[j].normal[i], 0};
        side.offset = {planes_[j].offset, 0};
        side.size = planes_[j].size;
        side.error = 0;
        return side;
    };
    const Side<Twofold> own = side_of(k);
    // Below `near`, and far beyond the planes from there.
    const Twofold down =
        exact_height(plane.normal, plane.offset, near) / dot(own.normal, own.normal);
    const V middle = V{{{near[0], 0}, {near[1], 0}, {near[2], 0}}} - down * own.normal;
    double distance = 0;
    for (const Plane& other : planes_)
        distance = std::fmax(distance, std::fabs(other.height(near)));
    const std::uint32_t no_plane = static_cast<std::uint32_t>(planes_.size());
    polygon.set_triangle(own, middle, 0x1p50 * distance, no_plane);
    for (std::uint32_t j = 0; j < planes_.size() && !polygon.corners().empty(); ++j) {
        if (j == k) continue;
        // Of planes that coincide the first one counts.
        if (!polygon.clip(side_of(j), j) && j < k) polygon.clear();
    }
    for (std::size_t i = 0; i < polygon.corners().size(); ++i)
        if (polygon.label(i) == no_plane)
            fail(MGDT_ERR_INVALID_ARGUMENT,
                 "the planes do not bound a region: plane %lld has no end", number(k));
    polygon.settle(own, side_of);
    for (std::size_t i = 0; i < polygon.corners().size(); ++i) {
        const Corner<Twofold>& corner = polygon.corners()[i];
        for (int axis = 0; axis < 3; ++axis)
            extent_ = std::fmax(extent_, 2 * std::fabs(corner.x.x[axis].high - near[axis]));
        corners_.push_back(
            {{corner.x.x[0], corner.x.x[1], corner.x.x[2]}, corner.error, polygon.label(i)});
    }
}

template <class Real>
void Region::set_face(std::size_t k, const double* point, double factor, std::uint32_t first_label,
                      Polygon<Real>& face) const {
    const std::size_t end = k + 1 < planes_.size() ? planes_[k + 1].first : corners_.size();
    face.clear();
    for (std::size_t i = planes_[k].first; i < end; ++i) {
        Corner<Real> corner;
        for (int axis = 0; axis < 3; ++axis)
            set_rounded(corner.x.x[axis],
                        scaled_by(corners_[i].x[axis] - Twofold{point[axis], 0}, factor));
        corner.size = length(corner.x);
        corner.error = 8 * rounding_of<Real> * corner.size + corners_[i].error * factor;
        corner.is_ideal = false;
        face.push_back(corner, first_label + corners_[i].label);
    }
}
template void Region::set_face(std::size_t, const double*, double, std::uint32_t,
                               Polygon<double>&) const;
template void Region::set_face(std::size_t, const double*, double, std::uint32_t,
                               Polygon<Twofold>&) const;

template <class Real>
Side<Real> Region::side(std::size_t k, const double* point, double factor) const {
    const Plane& plane = planes_[k];
    const Twofold height = exact_height(plane.normal, plane.offset, point);
    Side<Real> side;
    for (int i = 0; i < 3; ++i) side.normal.x[i] = to_real<Real>(plane.normal[i]);
    side.size = plane.size;
    set_rounded(side.offset, scaled_by(Twofold{-height.high, -height.low}, factor));
    const double terms =
        plane.size * (std::fabs(point[0]) + std::fabs(point[1]) + std::fabs(point[2])) +
        std::fabs(plane.offset);
    side.error = rounding_of<Real> * std::fabs(height.high) * factor +
                 4 * rounding_of<Twofold> * terms * factor;
    return side;
}
template Side<double> Region::side(std::size_t, const double*, double) const;
template Side<Twofold> Region::side(std::size_t, const double*, double) const;

double Region::clearance(const double* point) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Plane& plane : planes_) {
        const double depth = -plane.height(point) - plane.error(point);
        least = std::fmin(least, depth / plane.size);
    }
    return least * (least > 0 ? 1 - 4 * u : 1);
}

}  // namespace mgdt
