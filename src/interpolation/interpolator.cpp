// SPDX-License-Identifier: MIT
#include "interpolation/interpolator.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/scale.hpp"

namespace mgdt {

Interpolator::Interpolator(const Locator& where, Allocator& allocator, Method method,
                           Outside outside)
    : where_(where),
      allocator_(allocator),
      method_(method),
      outside_(outside),
      row_(allocator),
      natural_(allocator) {
    if (method != Method::linear && method != Method::nearest) star_.emplace(allocator);
    if (where.mesh.live_count() == 0 && outside == Outside::none)
        flat_hull_.emplace(where.mesh, allocator);
}

const PlaceRow& Interpolator::row(const double* q, TetId t, TetId near) {
    row_.weights.clear();
    row_.slopes.clear();
    is_exact_ = where_.scale_exactly(q, q_);
    const bool has_hull = where_.mesh.live_count() != 0;
    if (t != no_tetrahedron)
        add_inside(q, t);
    else if (outside_ == Outside::nearest || (outside_ != Outside::none && !has_hull) ||
             (flat_hull_ && is_exact_ && flat_hull_->contains(q_)))
        add_nearest(q, near);
    else if (outside_ != Outside::none)
        add_outside(near);
    return row_;
}

void Interpolator::add(VertexId v, double weight) {
    if (weight != 0) row_.weights.push_back({v, weight});
}

void Interpolator::sort() {
    const Buffer<Vertex>& vertices = where_.mesh.vertices;
    std::sort(row_.weights.begin(), row_.weights.end(),
              [&](const PlaceRow::Weight& a, const PlaceRow::Weight& b) {
                  return vertices[a.vertex].index < vertices[b.vertex].index;
              });
}

void Interpolator::add_nearest(const double* q, TetId near) {
    const VertexId v = where_.nearest_vertex(q, near, allocator_);
    if (v != infinite_vertex) add(v, 1);
}

void Interpolator::add_linear(const double* q, TetId t) {
    double w[4];
    where_.weights(t, q, w);
    for (int i = 0; i < 4; ++i) add(where_.mesh.tetrahedra[t].v[i], w[i]);
    sort();
}

// Adds the natural weights. Adds none and returns false at a vertex and on a ridge of the hull.
bool Interpolator::add_natural(TetId t) {
    const Mesh& mesh = where_.mesh;
    for (const VertexId v : mesh.tetrahedra[t].v)
        if (std::equal(q_, q_ + 3, mesh.point(v))) return false;
    star_->find(mesh, where_.kernel, q_, t);
    const Natural natural = method_ == Method::laplace ? Natural::laplace : Natural::sibson;
    if (star_->is_on_ridge()) return false;
    natural_.find(mesh, *star_, q_, natural);
    for (PlaceStar::Number k = 0; k < star_->size(); ++k)
        add(star_->vertex(k), natural_.weights()[k]);
    return true;
}

void Interpolator::add_inside(const double* q, TetId t) {
    if (method_ == Method::nearest) return add_nearest(q, t);
    if (method_ == Method::linear || !is_exact_ || !add_natural(t)) add_linear(q, t);
    if (method_ == Method::sibson_c1) smooth();
}

void Interpolator::add_outside(TetId near) {
    // Beyond this distance only the direction of the place matters, and products might overflow, so
    // the place is moved to this distance.
    constexpr double far = 0x1p400;
    const double most = max_magnitude(q_[0], q_[1], q_[2]);
    double from[3];
    for (int k = 0; k < 3; ++k)
        from[k] = most <= far         ? q_[k]
                  : std::isinf(q_[k]) ? std::copysign(far, q_[k])
                                      : q_[k] / most * far;
    const HullPlace place = nearest_hull_place(where_.mesh, from, near);
    double at[3];
    for (int k = 0; k < 3; ++k) at[k] = scaled(place.x[k], -where_.mesh.scale);
    if (method_ == Method::nearest) {
        add_nearest(at, near);
    } else {
        for (unsigned k = 0; k < place.size; ++k) add(place.corner[k], place.weight[k]);
    }
    const double q_before[3] = {q_[0], q_[1], q_[2]};
    std::copy(place.x, place.x + 3, q_);
    if (method_ == Method::sibson_c1) smooth();
    std::copy(q_before, q_before + 3, q_);
    if (outside_ == Outside::linear) extrapolate(place);
}

// Sibson's C1 interpolation. The linear functions of the gradients, weighted by the natural weights
// over the distances, are mixed with the interpolated value so that a paraboloid of revolution is
// reproduced (Sibson, A brief description of natural neighbour interpolation, 1981).
void Interpolator::smooth() {
    const Mesh& mesh = where_.mesh;
    Buffer<PlaceRow::Weight>& weights = row_.weights;
    if (weights.size() < 2) return;
    double largest = 0;
    const auto from = [&](VertexId v, int axis) { return q_[axis] - mesh.point(v)[axis]; };
    for (const PlaceRow::Weight& w : weights)
        for (int axis = 0; axis < 3; ++axis)
            largest = std::max(largest, std::fabs(from(w.vertex, axis)));
    const auto distance = [&](VertexId v) {
        const double x = from(v, 0) / largest, y = from(v, 1) / largest, z = from(v, 2) / largest;
        // The distance is 0 if the rounded point of the hull is at a vertex. Any small number can
        // replace 0.
        return std::max(std::sqrt((x * x + y * y) + z * z), 0x1p-300);
    };
    double over = 0, times = 0, square = 0;
    for (const PlaceRow::Weight& w : weights) {
        const double d = distance(w.vertex);
        over += w.weight / d;
        times += w.weight * d;
        square += w.weight * d * d;
    }
    // The coordinates may be at both ends of the range of doubles, so that distances overflow. The
    // value is not smoothed then.
    if (!(largest < 0x1p1000)) return;
    const double alpha = times / over, of_values = alpha / (alpha + square),
                 of_planes = square / (alpha + square);
    for (PlaceRow::Weight& w : weights) {
        const double part = of_planes * (w.weight / distance(w.vertex) / over);
        row_.slopes.push_back({w.vertex, part, difference<Twofold>(q_, mesh.point(w.vertex))});
        w.weight = of_values * w.weight + part;
    }
}

// Continues the value linearly outside the hull, with the weighted mean of the gradients at the
// corners of the nearest hull feature. The displacement begins at the mean of the corners with the
// same weights.
void Interpolator::extrapolate(const HullPlace& from) {
    Vector<Twofold> way;
    for (int axis = 0; axis < 3; ++axis) {
        way.x[axis] = {q_[axis], 0};
        for (unsigned k = 0; k < from.size; ++k)
            way.x[axis] = way.x[axis] -
                          Twofold::product(from.weight[k], where_.mesh.point(from.corner[k])[axis]);
        // If the displacement is too long for doubles, the value at its beginning remains.
        if (!std::isfinite(way.x[axis].high) || !std::isfinite(way.x[axis].low)) return;
    }
    for (unsigned k = 0; k < from.size; ++k)
        row_.slopes.push_back({from.corner[k], from.weight[k], way});
}

}  // namespace mgdt
