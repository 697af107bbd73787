// SPDX-License-Identifier: MIT
// Convex polygons in space, a face of a cell each, and what half-spaces leave of them.
#pragma once

#include <limits>

#include "platform/memory.hpp"
#include "predicates/vector.hpp"

namespace mgdt {

// A corner of a face: a point, or the direction of a ray that ends nowhere.
template <class Real>
struct Corner {
    Vector<Real> x;
    double size, error;  // length of x; of the error of x, at most
    bool is_ideal;
};

// A face lies in the plane normal . x = offset of its side; the cell is where normal . x is less.
template <class Real>
struct Side {
    Vector<Real> normal;
    Real offset;
    double size;   // length of the normal
    double error;  // of the offset, at most; the normal's is that of one rounding of its numbers

    double distance() const noexcept { return std::fabs(nearest_double(offset)) / size; }
};

// The point where three planes meet, by Cramer's rule; of planes that turn round it so that their
// normals are positively oriented. False where these are in one plane, nearly, or where numbers are
// beyond the range of doubles. Bounds of the error: docs/theory.md, "Cells".
template <class Real>
bool meet(const Side<Real>& p, const Side<Real>& q, const Side<Real>& r, Corner<Real>& corner) {
    constexpr double u = rounding_of<Real>;
    const Vector<Real> qr = cross(q.normal, r.normal), rp = cross(r.normal, p.normal),
                       pq = cross(p.normal, q.normal);
    const Real det = dot(p.normal, qr);
    const double d = nearest_double(det), product = p.size * q.size * r.size;
    if (!(d > 1024 * u * product)) return false;
    const Real inverse = to_real<Real>(1) / det;
    for (int k = 0; k < 3; ++k)
        corner.x.x[k] = ((p.offset * qr.x[k] + q.offset * rp.x[k]) + r.offset * pq.x[k]) * inverse;
    corner.size = length(corner.x);
    const double distances = p.distance() + q.distance() + r.distance();
    const double errors = p.error / p.size + q.error / q.size + r.error / r.size;
    corner.error = (product / d) * (16 * u * (distances + corner.size) + errors);
    corner.is_ideal = false;
    return product > 0x1p-900;
}

// Its edges are labelled with the numbers of the sides that they lie in.
template <class Real>
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
    // Adds a corner, and the label of the edge that follows it.
    void push_back(const Corner<Real>& corner, std::uint32_t label) {
        corners_.push_back(corner);
        labels_.push_back(label);
    }
    const Buffer<Corner<Real>>& corners() const noexcept { return corners_; }
    std::uint32_t label(std::size_t edge) const noexcept { return labels_[edge]; }
    // Bounds the area that was left or taken by mistake.
    double slack() const noexcept { return slack_; }

    // A triangle in the plane that has all points within `distance` of `middle`, a point of it.
    void set_triangle(const Side<Real>& plane, const Vector<Real>& middle, double distance,
                      std::uint32_t label);
    // Leaves what is on the inner side (Sutherland and Hodgman, Reentrant polygon clipping,
    // Communications of the ACM 17, 1974). Returns whether some corner is off the plane for sure.
    bool clip(const Side<Real>& side, std::uint32_t label);
    // Puts corners where the planes of their edges meet that of the polygon, side(label) being that
    // of an edge, if that is more precise.
    template <class SideOf>
    void settle(const Side<Real>& plane, SideOf side);
    // Where rays end at last: bounds the distance of what is looked at from the origin.
    void set_reach(double reach) noexcept { reach_ = reach; }
    // Whether all of these corners, each(f) calling f(corner), are on the inner side for sure, and
    // rays do not leave it within the reach.
    template <class Each>
    static bool are_inside(const Side<Real>& side, double reach, Each each) {
        double top = -std::numeric_limits<double>::infinity(), rise = 0;
        each([&](const Corner<Real>& corner) { look_up(corner, height(corner, side), top, rise); });
        return top + rise * reach < 0;
    }

  private:
    struct Height {
        Real value;
        double error;
    };
    static Height height(const Corner<Real>& corner, const Side<Real>& side);
    // What bounds heights from above: those of points, and how fast rays may rise.
    static void look_up(const Corner<Real>& corner, const Height& h, double& top, double& rise) {
        const double value = nearest_double(h.value);
        if (!corner.is_ideal)
            top = std::fmax(top, value + h.error);
        else if (value > 0)
            top = std::numeric_limits<double>::infinity();
        else if (value == 0)  // parallel, or nearly so; twice the reach to the other side
            rise = std::fmax(rise, 4 * h.error / corner.size);
    }
    static constexpr double lost_area = 0x1p200;
    // Bounds the area that is taken or left by mistake, heights having errors up to `doubt`.
    double doubt_area(double doubt) const;
    // Where an edge meets a side: one end is inside, or on it, the other one is outside.
    static Corner<Real> crossing(const Corner<Real>& in, const Height& of_in,
                                 const Corner<Real>& out, const Height& of_out);

    Buffer<Corner<Real>> corners_, next_;
    Buffer<std::uint32_t> labels_, next_labels_;
    Buffer<Height> heights_;
    double slack_ = 0, reach_ = 0;
};

template <class Real>
typename Polygon<Real>::Height Polygon<Real>::height(const Corner<Real>& corner,
                                                     const Side<Real>& side) {
    constexpr double u = rounding_of<Real>;
    const Real along = dot(side.normal, corner.x);
    double error = side.size * (corner.error + 6 * u * corner.size);
    if (corner.is_ideal) {
        // A ray that may be parallel does not come nearer.
        const bool is_known = std::fabs(nearest_double(along)) > error;
        return {is_known ? along : to_real<Real>(0), error};
    }
    error += side.error + 2 * u * std::fabs(nearest_double(side.offset));
    return {along - side.offset, error};
}

// The combination of the ends whose height is 0, by weights that are not negative; that of an ideal
// end counts no point. Exchanging the ends gives the same.
template <class Real>
Corner<Real> Polygon<Real>::crossing(const Corner<Real>& in, const Height& of_in,
                                     const Corner<Real>& out, const Height& of_out) {
    constexpr double u = rounding_of<Real>;
    const Real zero = to_real<Real>(0), depth = zero - of_in.value, excess = of_out.value;
    Corner<Real> c;
    c.x = excess * in.x + depth * out.x;
    Real weight = zero;
    if (!in.is_ideal) weight = weight + excess;
    if (!out.is_ideal) weight = weight + depth;
    const double w = nearest_double(weight), e = nearest_double(excess), d = nearest_double(depth);
    c.is_ideal = !(w > 0);
    double divisor = 1;
    if (!c.is_ideal) {
        for (Real& x : c.x.x) x = x / weight;
        divisor = w;
    }
    c.size = length(c.x);
    // The weights have the errors of the heights, each of which moves the point along the edge.
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
    // Between two points it stays between them.
    if (!in.is_ideal && !out.is_ideal) slack = std::fmin(slack, 1);
    c.error += move * slack;
    return c;
}

template <class Real>
bool Polygon<Real>::clip(const Side<Real>& side, std::uint32_t label) {
    const std::size_t n = corners_.size();
    heights_.resize(n);
    bool is_off = false, is_cut = false;
    double doubt = 0, top = -std::numeric_limits<double>::infinity(), rise = 0;
    for (std::size_t i = 0; i < n; ++i) {
        heights_[i] = height(corners_[i], side);
        const double h = nearest_double(heights_[i].value);
        is_cut |= h > 0;
        if (h <= 0) look_up(corners_[i], heights_[i], top, rise);
        if (std::fabs(h) > heights_[i].error)
            is_off = true;
        else if (!corners_[i].is_ideal)
            doubt = std::fmax(doubt, heights_[i].error);
    }
    if (doubt > 0) slack_ += doubt_area(doubt);
    if (rise > 0 && top + rise * reach_ > 0) slack_ += lost_area;
    if (is_cut) {
        next_.clear();
        next_labels_.clear();
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t j = i + 1 == n ? 0 : i + 1;
            const bool is_in = !(nearest_double(heights_[i].value) > 0),
                       next_is_in = !(nearest_double(heights_[j].value) > 0);
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

// A strip where the height is at most `doubt` may be there by mistake, or not. The slope gives its
// breadth, and the polygon is not longer than twice its farthest corner.
template <class Real>
double Polygon<Real>::doubt_area(double doubt) const {
    double extent = 0;
    std::size_t lowest = 0, highest = 0;
    const auto height_of = [&](std::size_t i) { return nearest_double(heights_[i].value); };
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        if (corners_[i].is_ideal) return lost_area;
        if (height_of(i) < height_of(lowest)) lowest = i;
        if (height_of(i) > height_of(highest)) highest = i;
        extent = std::fmax(extent, corners_[i].size);
    }
    const double rise = height_of(highest) - height_of(lowest), whole = 4 * extent * extent;
    if (!(rise > 0)) return whole;
    const double slope = rise / length(corners_[highest].x - corners_[lowest].x);
    return std::fmin(whole, 4 * extent * doubt / slope);
}

template <class Real>
void Polygon<Real>::set_triangle(const Side<Real>& plane, const Vector<Real>& middle,
                                 double distance, std::uint32_t label) {
    const Vector<Real>& normal = plane.normal;
    int least = 0;
    for (int i = 1; i < 3; ++i)
        if (std::fabs(nearest_double(normal.x[i])) < std::fabs(nearest_double(normal.x[least])))
            least = i;
    const Real zero = to_real<Real>(0);
    Vector<Real> axis = {{zero, zero, zero}};
    axis.x[least] = to_real<Real>(1);
    // At right angles to one another, and of one length.
    Vector<Real> first = cross(normal, axis), second = cross(normal, first);
    first = to_real<Real>(4 * distance / length(first)) * first;
    second = to_real<Real>(4 * distance / length(second)) * second;
    clear();
    for (const Vector<Real>& x : {middle + first, middle + second, middle - (first + second)}) {
        const double size = length(x);
        push_back({x, size, 32 * rounding_of<Real> * size, false}, label);
    }
}

template <class Real>
template <class SideOf>
void Polygon<Real>::settle(const Side<Real>& plane, SideOf side) {
    for (std::size_t i = 0; i < corners_.size(); ++i) {
        const std::uint32_t before = labels_[i == 0 ? corners_.size() - 1 : i - 1];
        Corner<Real> corner;
        // Edges turn round the plane's normal, and sides look outwards.
        if (before != labels_[i] && meet(plane, side(before), side(labels_[i]), corner) &&
            corner.error < corners_[i].error)
            corners_[i] = corner;
    }
}

}  // namespace mgdt
