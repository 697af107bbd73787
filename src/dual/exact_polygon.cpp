// SPDX-License-Identifier: MIT
#include "dual/exact_polygon.hpp"

#include <limits>

namespace mgdt {
namespace {

constexpr Corner unknown = {{}, 0, std::numeric_limits<double>::infinity(), false};

}  // namespace

void ExactPolygon::set_far(PlaneNumber plane) {
    begin(plane);
    int sign;
    const int axis = half_spaces_.main_axis(plane, sign);
    for (int k = 0; k < 3; ++k) {
        // With the main axis as z, the edges have the outward normals -y, x + y, -x if the normal
        // of the plane is along +z, and the opposite cycle if the normal is along -z.
        constexpr int cycle[3] = {1, 2, 0};
        const PlaneNumber edge = far_plane(axis, cycle[sign > 0 ? k : 2 - k]);
        corners_.push_back({unknown, edge});
    }
}

// The corner where the plane of the polygon meets the planes `before` and `after`. If one of the
// two planes is a far plane, the corner is the direction of a ray. If both are far planes, or
// meet() fails, the corner has no coordinates.
ExactPolygon::LabelledCorner ExactPolygon::corner(PlaneNumber before, PlaneNumber after) const {
    LabelledCorner c = {unknown, after};
    if (is_far(before) && is_far(after)) return c;
    const Side& plane = half_spaces_.side(plane_);
    if (is_far(before) || is_far(after)) {
        const Side& edge = half_spaces_.side(is_far(before) ? after : before);
        Corner way;
        way.x =
            is_far(before) ? cross(edge.normal, plane.normal) : cross(plane.normal, edge.normal);
        way.size = length(way.x);
        way.error = 8 * rounding_of<double> * plane.size * edge.size;
        way.is_ideal = true;
        if (std::isfinite(plane.error) && std::isfinite(edge.error)) c.at = way;
        return c;
    }
    Corner at;
    if (meet(plane, half_spaces_.side(before), half_spaces_.side(after), at)) c.at = at;
    return c;
}

int ExactPolygon::sign_at(std::size_t i, PlaneNumber s) {
    const Corner& at = corners_[i].at;
    const Side& side = half_spaces_.side(s);
    const double along = dot(side.normal, at.x);
    double height = along, error = side.size * (at.error + 6 * rounding_of<double> * at.size);
    if (!at.is_ideal) {
        height -= side.offset;
        error += side.error + 2 * rounding_of<double> * std::fabs(side.offset);
    } else if (!std::isfinite(side.error)) {
        error = side.error;
    }
    if (height > error) return 1;
    if (-height > error) return -1;
    return half_spaces_.side_of_corner(plane_, edge_before(i), edge(i), s);
}

bool ExactPolygon::clip(PlaneNumber s, bool stays_if_equal) {
    const std::size_t n = corners_.size();
    bool has_inside = false, has_outside = false, touches = false;
    signs_.resize(n);
    for (std::size_t i = 0; i < n; ++i) {
        const int sign = sign_at(i, s);
        has_inside |= sign < 0;
        has_outside |= sign > 0;
        touches |= sign >= 0;
        signs_[i] = static_cast<std::int8_t>(sign);
    }
    if (!has_outside) {
        const bool is_one_plane = !has_inside && n > 0;
        if (is_one_plane && !(stays_if_equal && half_spaces_.sign_of_product(plane_, s) > 0))
            corners_.clear();
        return touches;
    }
    if (!has_inside) {
        // At most a single corner or an edge is inside, which has no area.
        corners_.clear();
        return true;
    }
    next_.clear();
    for (std::size_t i = 0; i < n; ++i) {
        const std::size_t j = i + 1 == n ? 0 : i + 1;
        const PlaneNumber edge = corners_[i].edge;
        if (signs_[i] <= 0) {
            const bool is_last = signs_[i] == 0 && signs_[j] > 0;
            next_.push_back({corners_[i].at, is_last ? s : edge});
        }
        if (signs_[i] < 0 && signs_[j] > 0) next_.push_back(corner(edge, s));
        if (signs_[i] > 0 && signs_[j] < 0) next_.push_back(corner(s, edge));
    }
    std::swap(corners_, next_);
    return true;
}

}  // namespace mgdt
