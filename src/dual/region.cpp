// SPDX-License-Identifier: MIT
#include "dual/region.hpp"

#include <algorithm>
#include <limits>

#include "dual/exact_polygon.hpp"
#include "mesh/scale.hpp"
#include "platform/error.hpp"
#include "platform/no_index.hpp"

namespace mgdt {
namespace {

// Products of two numbers below this magnitude are in the range of doubles.
constexpr double most_ordinary = 0x1p300;

// normal . p - offset.
Twofold exact_height(const double* normal, double offset, const double* p) {
    Twofold sum = {-offset, 0};
    for (int i = 0; i < 3; ++i) sum = sum + Twofold::product(normal[i], p[i]);
    return sum;
}

}  // namespace

double Region::Plane::error(const double* p) const {
    const double terms =
        size * (std::fabs(p[0]) + std::fabs(p[1]) + std::fabs(p[2])) + std::fabs(offset);
    return 6 * rounding_of<double> * terms + 8 * std::numeric_limits<double>::denorm_min();
}

Region::Region(Allocator& allocator, std::size_t n, const double* planes, const Mesh& mesh,
               std::int32_t base, std::size_t points)
    : planes_(allocator), corners_(allocator), base_(base) {
    if (n == 0) return;
    planes_.reserve(n);
    for (std::size_t k = 0; k < n; ++k) add_plane(k, planes + 4 * k, mesh);
    require_inside(mesh, points);
    set_faces(mesh);
}

void Region::add_plane(std::size_t k, const double* of, const Mesh& mesh) {
    for (int i = 0; i < 4; ++i)
        if (!std::isfinite(of[i]))
            fail(MGDT_ERR_NOT_FINITE, "plane %lld has a number that is not finite", number(k));
    const double largest = std::max({std::fabs(of[0]), std::fabs(of[1]), std::fabs(of[2])});
    if (largest == 0) fail(MGDT_ERR_INVALID_ARGUMENT, "plane %lld has no normal", number(k));
    // Scales normals by powers of two to lengths between 1 and 4.
    const int shift = -std::ilogb(largest);
    Plane plane;
    plane.numbers = of;
    for (int i = 0; i < 3; ++i) plane.normal[i] = scaled(of[i], shift);
    plane.offset = scaled(of[3], shift + mesh.scale);
    plane.size = std::hypot(std::hypot(plane.normal[0], plane.normal[1]), plane.normal[2]) *
                 (1 + 8 * rounding_of<double>);
    plane.index = static_cast<std::uint32_t>(k);
    plane.first = 0;
    planes_.push_back(plane);
}

// Whether a point is outside by more than rounding. The decision is exact if doubles overflow.
bool Region::is_beyond(const Plane& plane, const double* p, int scale, LongMemory& memory) const {
    const double height = plane.height(p), error = plane.error(p);
    if (std::isfinite(height) && std::isfinite(error)) return height > error;
    memory.release(0);
    LongNumber exact = -memory.number(plane.numbers[3], scale);
    for (int i = 0; i < 3; ++i)
        exact = exact + memory.number(plane.numbers[i]) * memory.number(p[i]);
    return exact.sign() > 0;
}

// Throws an Error that names the vertex with the least index that is outside, if any is.
void Region::require_inside(const Mesh& mesh, std::size_t points) const {
    LongMemory memory(planes_.allocator());
    std::uint32_t point = no_index;
    std::size_t plane = 0;
    for (VertexId v = 1; v < mesh.vertices.size(); ++v) {
        const double* const p = mesh.point(v);
        if (mesh.vertices[v].index >= points) continue;
        for (std::size_t k = 0; k < planes_.size(); ++k)
            if (mesh.vertices[v].index < point && is_beyond(planes_[k], p, mesh.scale, memory)) {
                point = mesh.vertices[v].index;
                plane = k;
            }
    }
    if (point != no_index)
        fail(MGDT_ERR_INVALID_ARGUMENT, "point %lld is beyond plane %lld", number(point),
             number(plane));
}

// Finds the faces of the region, and keeps only the planes that have a face. A first round finds
// those planes, and a second one the faces: a needless plane that touches the region along an edge
// would otherwise be the label of that edge.
void Region::set_faces(const Mesh& mesh) {
    Allocator& allocator = planes_.allocator();
    // The vertex with the least index, which does not depend on the order of insertion.
    VertexId first = 1;
    for (VertexId v = 2; v < mesh.vertices.size(); ++v)
        if (mesh.vertices[v].index < mesh.vertices[first].index) first = v;
    const double* const near = mesh.point(first);
    for (VertexId v = 1; v < mesh.vertices.size(); ++v)
        for (int axis = 0; axis < 3; ++axis)
            is_ordinary_ &= std::fabs(mesh.point(v)[axis]) < most_ordinary;
    Buffer<Plane> with_faces(allocator);
    each_face(near, mesh.scale, [&](const ExactPolygon& polygon, HalfSpaces&) {
        for (std::size_t i = 0; i < polygon.size(); ++i)
            if (is_far(polygon.edge(i)))
                fail(MGDT_ERR_INVALID_ARGUMENT,
                     "the planes do not bound a region: plane %lld has no end",
                     number(polygon.plane()));
        with_faces.push_back(planes_[polygon.plane()]);
    });
    if (with_faces.empty())
        fail(MGDT_ERR_INVALID_ARGUMENT, "the planes bound a region without a volume");
    planes_ = std::move(with_faces);
    each_face(near, mesh.scale, [&](const ExactPolygon& polygon, HalfSpaces& half_spaces) {
        Plane& plane = planes_[polygon.plane()];
        plane.first = static_cast<std::uint32_t>(corners_.size());
        is_ordinary_ &= std::fabs(plane.offset) < most_ordinary;
        add_face(polygon, half_spaces, near);
    });
}

// Calls f with the polygon of each plane that has a face of the region. If planes coincide, the
// first one has the face.
template <class F>
void Region::each_face(const double* near, int scale, F f) const {
    HalfSpaces half_spaces(planes_.allocator());
    half_spaces.clear(near, 1);
    for (const Plane& plane : planes_) half_spaces.add_plane(plane.numbers, scale);
    ExactPolygon polygon(planes_.allocator(), half_spaces);
    const auto count = static_cast<PlaneNumber>(planes_.size());
    for (PlaneNumber k = 0; k < count; ++k) {
        polygon.set_far(k);
        for (PlaneNumber j = 0; j < count && !polygon.is_empty(); ++j)
            if (j != k) polygon.clip(j, k < j);
        if (!polygon.is_empty()) f(polygon, half_spaces);
    }
}

void Region::add_face(const ExactPolygon& polygon, HalfSpaces& half_spaces, const double* near) {
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        RegionCorner corner = {};
        Vector<Twofold> x = {};
        is_ordinary_ &=
            half_spaces.round_corner(polygon.plane(), polygon.edge_before(i), polygon.edge(i), x);
        double largest = 0;
        for (int axis = 0; axis < 3; ++axis) {
            corner.x[axis] = x.x[axis];
            largest = std::max(largest, std::fabs(x.x[axis].high));
            extent_ = std::max(extent_, 2 * std::fabs(x.x[axis].high - near[axis]));
        }
        is_ordinary_ &= largest < most_ordinary;
        corner.error = 2 * HalfSpaces::corner_error * largest;
        corner.label = polygon.edge(i);
        corners_.push_back(corner);
    }
}

void Region::set_face(std::size_t k, const double* point, double factor, std::uint32_t first_label,
                      Polygon& face) const {
    const std::size_t end = k + 1 < planes_.size() ? planes_[k + 1].first : corners_.size();
    face.clear();
    for (std::size_t i = planes_[k].first; i < end; ++i) {
        Corner corner;
        for (int axis = 0; axis < 3; ++axis)
            corner.x.x[axis] = (corners_[i].x[axis] - Twofold{point[axis], 0}).high * factor;
        corner.size = length(corner.x);
        corner.error = 8 * rounding_of<double> * corner.size + corners_[i].error * factor;
        corner.is_ideal = false;
        face.push_back(corner, first_label + corners_[i].label);
    }
}

Side Region::side(std::size_t k, const double* point, double factor) const {
    const Plane& plane = planes_[k];
    const Twofold height = exact_height(plane.normal, plane.offset, point);
    Side side;
    for (int i = 0; i < 3; ++i) side.normal.x[i] = plane.normal[i];
    side.size = plane.size;
    side.offset = -height.high * factor;
    const double terms =
        plane.size * (std::fabs(point[0]) + std::fabs(point[1]) + std::fabs(point[2])) +
        std::fabs(plane.offset);
    side.error = rounding_of<double> * std::fabs(height.high) * factor +
                 4 * rounding_of<Twofold> * terms * factor;
    return side;
}

double Region::clearance(const double* point) const {
    if (!is_ordinary_) return std::numeric_limits<double>::quiet_NaN();
    double least = std::numeric_limits<double>::infinity();
    for (const Plane& plane : planes_) {
        const double depth = -plane.height(point) - plane.error(point);
        least = std::min(least, depth / plane.size);
    }
    return least * (least > 0 ? 1 - 4 * rounding_of<double> : 1);
}

}  // namespace mgdt
