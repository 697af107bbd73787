// SPDX-License-Identifier: MIT
// Convex polygons in space, each a face of a cell, and their clipping by half-spaces.
#pragma once

#include <algorithm>
#include <limits>

#include "dual/corner.hpp"
#include "platform/memory.hpp"

namespace mgdt {

// A polygon whose edges are labelled with the numbers of the half-spaces whose planes contain them.
class Polygon {
  public:
    explicit Polygon(Allocator& allocator)
        : corners_(allocator),
          next_(allocator),
          labels_(allocator),
          next_labels_(allocator),
          heights_(allocator) {}

    void clear() noexcept {
        corners_.clear();
        labels_.clear();
        slack_ = 0;
    }
    // Adds a corner and the label of the edge that follows it.
    void push_back(const Corner& corner, std::uint32_t label) {
        corners_.push_back(corner);
        labels_.push_back(label);
    }
    const Buffer<Corner>& corners() const noexcept { return corners_; }
    // The label of an edge.
    std::uint32_t label(std::size_t edge) const noexcept { return labels_[edge]; }
    std::uint32_t label_before(std::size_t corner) const noexcept {
        return labels_[corner == 0 ? labels_.size() - 1 : corner - 1];
    }
    // An upper bound on the area that clipping has kept or removed wrongly.
    double slack() const noexcept { return slack_; }

    // Clips the polygon by a half-space (Sutherland and Hodgman, Reentrant polygon clipping,
    // Communications of the ACM 17, 1974). Returns whether some corner is certainly off the plane.
    bool clip(const Side& side, std::uint32_t label);
    // Moves each corner to the point where the plane of the polygon meets the planes of the two
    // edges at the corner, if this point is more accurate. side(label) gives the half-space of an
    // edge.
    template <class SideOf>
    void settle(const Side& plane, SideOf side);
    // Sets the length at which rays end, an upper bound on all distances from the origin that
    // matter.
    void set_reach(double reach) noexcept { reach_ = reach; }
    double reach() const noexcept { return reach_; }
    // +1 if a finite corner is certainly outside, -1 if it is certainly inside, otherwise 0.
    static int sign_at(const Corner& corner, const Side& side) {
        const Height h = height(corner, side);
        return h.value > h.error ? 1 : -h.value > h.error ? -1 : 0;
    }
    // Whether all corners are certainly inside, and no ray leaves the half-space within the reach.
    // each(f) calls f for each corner.
    template <class Each>
    static bool are_inside(const Side& side, double reach, Each each) {
        double top = -std::numeric_limits<double>::infinity(), rise = 0;
        each([&](const Corner& corner) { look_up(corner, height(corner, side), top, rise); });
        return top + rise * reach < 0;
    }

  private:
    struct Height {
        double value;
        double error;
    };
    static Height height(const Corner& corner, const Side& side);
    // Raises `top`, an upper bound on the heights of finite corners, and `rise`, an upper bound on
    // the slopes of rays.
    static void look_up(const Corner& corner, const Height& h, double& top, double& rise) {
        const double value = h.value;
        if (!corner.is_ideal)
            top = std::max(top, value + h.error);
        else if (value > 0)
            top = std::numeric_limits<double>::infinity();
        else if (value == 0)  // nearly parallel: slope <= 2 error / size, length <= 2 reach
            rise = std::max(rise, 4 * h.error / corner.size);
    }
    static constexpr double lost_area = 0x1p200;
    // An upper bound on the area that is kept or removed wrongly if heights have errors up to
    // `doubt`.
    double doubt_area(double doubt) const;
    // The point where an edge crosses a plane. One end is inside or on the plane, the other one is
    // outside.
    static Corner crossing(const Corner& in, const Height& of_in, const Corner& out,
                           const Height& of_out);

    Buffer<Corner> corners_, next_;
    Buffer<std::uint32_t> labels_, next_labels_;
    Buffer<Height> heights_;
    double slack_ = 0, reach_ = 0;
};

inline Polygon::Height Polygon::height(const Corner& corner, const Side& side) {
    constexpr double u = rounding_of<double>;
    const double along = dot(side.normal, corner.x);
    double error = side.size * (corner.error + 6 * u * corner.size);
    if (corner.is_ideal) {
        // A ray that may be parallel to the plane counts as parallel, with a height of 0.
        const bool is_known = std::fabs(along) > error;
        return {is_known ? along : 0, error};
    }
    error += side.error + 2 * u * std::fabs(side.offset);
    return {along - side.offset, error};
}

// The convex combination of the two ends that has the height 0. An end that is the direction of a
// ray adds nothing to the sum of the weights. Exchanging the ends gives the same result.
inline Corner Polygon::crossing(const Corner& in, const Height& of_in, const Corner& out,
                                const Height& of_out) {
    constexpr double u = rounding_of<double>;
    const double depth = -of_in.value, excess = of_out.value;
    Corner c;
    c.x = excess * in.x + depth * out.x;
    double weight = 0;
    if (!in.is_ideal) weight = weight + excess;
    if (!out.is_ideal) weight = weight + depth;
    const double w = weight, e = excess, d = depth;
    c.is_ideal = !(w > 0);
    double divisor = 1;
    if (!c.is_ideal) {
        for (double& x : c.x.x) x = x / weight;
        divisor = w;
    }
    c.size = length(c.x);
    // The errors of the heights are errors of the weights. Each error moves the point along the
    // edge.
    const double move = c.is_ideal     ? in.size + out.size
                        : in.is_ideal  ? in.size
                        : out.is_ideal ? out.size
                                       : length(out.x - in.x);
    c.error =
        (e * in.error + d * out.error) / divisor + 6 * u * ((e * in.size + d * out.size) / divisor);
    if (c.is_ideal) {
        c.error += move * (of_in.error + of_out.error);
        return c;
    }
    const double error_of_weight =
        (in.is_ideal ? 0 : of_out.error) + (out.is_ideal ? 0 : of_in.error);
    constexpr double lost = 0x1p100;
    double slack = w > error_of_weight
                       ? (of_in.error * e + of_out.error * d) / (w * (w - error_of_weight))
                       : lost;
    // The crossing of an edge with two finite ends stays between the ends.
    if (!in.is_ideal && !out.is_ideal) slack = std::min(1.0, slack);
    c.error += move * slack;
    return c;
}

inline bool Polygon::clip(const Side& side, std::uint32_t label) {
    const std::size_t n = corners_.size();
    heights_.resize(n);
    bool is_off = false, is_cut = false;
    double doubt = 0, top = -std::numeric_limits<double>::infinity(), rise = 0;
    for (std::size_t i = 0; i < n; ++i) {
        heights_[i] = height(corners_[i], side);
        const double h = heights_[i].value;
        is_cut |= h > 0;
        if (h <= 0) look_up(corners_[i], heights_[i], top, rise);
        if (std::fabs(h) > heights_[i].error)
            is_off = true;
        else if (!corners_[i].is_ideal)
            doubt = std::max(doubt, heights_[i].error);
    }
    if (doubt > 0) slack_ += doubt_area(doubt);
    if (rise > 0 && top + rise * reach_ > 0) slack_ += lost_area;
    if (is_cut) {
        next_.clear();
        next_labels_.clear();
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t j = i + 1 == n ? 0 : i + 1;
            const bool is_in = !(heights_[i].value > 0), next_is_in = !(heights_[j].value > 0);
            if (is_in) {
                next_.push_back(corners_[i]);
                next_labels_.push_back(labels_[i]);
            }
            if (is_in != next_is_in) {
                const std::size_t in = is_in ? i : j, out = is_in ? j : i;
                next_.push_back(crossing(corners_[in], heights_[in], corners_[out], heights_[out]));
                next_labels_.push_back(is_in ? label : labels_[i]);
            }
        }
        std::swap(corners_, next_);
        std::swap(labels_, next_labels_);
    }
    return is_off;
}

// The part of the polygon where the height is at most `doubt` may be kept or removed wrongly. This
// part is a strip: the slope bounds its width, and twice the distance of the farthest corner bounds
// its length.
inline double Polygon::doubt_area(double doubt) const {
    double extent = 0;
    std::size_t lowest = 0, highest = 0;
    const auto height_of = [&](std::size_t i) { return heights_[i].value; };
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        if (corners_[i].is_ideal) return lost_area;
        if (height_of(i) < height_of(lowest)) lowest = i;
        if (height_of(i) > height_of(highest)) highest = i;
        extent = std::max(extent, corners_[i].size);
    }
    const double rise = height_of(highest) - height_of(lowest), whole = 4 * extent * extent;
    if (!(rise > 0)) return whole;
    const double slope = rise / length(corners_[highest].x - corners_[lowest].x);
    return std::min(whole, 4 * extent * doubt / slope);
}

template <class SideOf>
void Polygon::settle(const Side& plane, SideOf side) {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const std::uint32_t before = label_before(i);
        Corner corner;
        // Edges are counter-clockwise about the plane's normal, and the normals of the half-spaces
        // point outwards. So the three normals are positively oriented, as meet() requires.
        if (before != labels_[i] && meet(plane, side(before), side(labels_[i]), corner) &&
            corner.error < corners_[i].error)
            corners_[i] = corner;
    }
}

}  // namespace mgdt
