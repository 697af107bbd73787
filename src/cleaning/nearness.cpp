// SPDX-License-Identifier: MIT
#include "cleaning/nearness.hpp"

#include "cleaning/projection.hpp"
#include "mesh/bounding_box.hpp"
#include "mesh/scale.hpp"
#include "predicates/foot_weights.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {

Nearness::Nearness(double share, const Buffer<double>& points)
    : exponent_(exponent_above(points.begin(), points.size())), distance_(0) {
    if (share == 0 || points.empty()) return;
    BoundingBox box = BoundingBox::empty();
    for (std::size_t i = 0; i < points.size(); i += 3) {
        const Vector<double> p = scaled(points.begin() + i);
        box.include(p.x);
    }
    distance_ = share * length(difference<double>(box.high, box.low));
}

double Nearness::distance() const noexcept {
    return std::ldexp(distance_, exponent_);
}

Vector<double> Nearness::scaled(const double* x) const noexcept {
    return {
        {std::ldexp(x[0], -exponent_), std::ldexp(x[1], -exponent_), std::ldexp(x[2], -exponent_)}};
}

bool Nearness::is_near(const Vector<double>& foot, const double* p) const {
    return length(foot - scaled(p)) <= distance_;
}

bool Nearness::is_on_edge(const double* a, const double* b, const double* p) const {
    if (is_exact())
        return compare_lexicographic(a, p) * compare_lexicographic(p, b) > 0 && collinear(a, b, p);
    double w[2];
    foot_weights(a, b, p, w);
    return w[0] > 0 && w[1] > 0 && is_near(w[0] * scaled(a) + w[1] * scaled(b), p);
}

bool Nearness::is_in_triangle(const double* a, const double* b, const double* c,
                              const double* p) const {
    if (is_exact()) {
        if (orientation(a, b, c, p) != 0) return false;
        // In the plane it is inside if it is so in a projection that is no line.
        for (int axis = 0; axis < 3; ++axis) {
            const Projection along(axis);
            const int sign = along.turn(a, b, c);
            if (sign != 0)
                return along.turn(a, b, p) == sign && along.turn(b, c, p) == sign &&
                       along.turn(c, a, p) == sign;
        }
        return false;
    }
    if (collinear(a, b, c)) return false;
    double w[3];
    foot_weights(a, b, c, p, w);
    return w[0] > 0 && w[1] > 0 && w[2] > 0 &&
           is_near(w[0] * scaled(a) + w[1] * scaled(b) + w[2] * scaled(c), p);
}

// With the distance 0, the sign of the orientation decides. Otherwise the height above the plane is
// computed in doubles; `doubt` is more than its error, of a few roundings of the product of the
// lengths.
bool Nearness::is_apart_from_plane(const double* a, const double* b, const double* c,
                                   const double* p) const {
    if (is_exact()) return orientation(a, b, c, p) != 0;
    const Vector<double> o = scaled(a), u = scaled(b) - o, v = scaled(c) - o, q = scaled(p) - o,
                         normal = cross(u, v);
    const double doubt = 0x1p-48 * length(u) * length(v) * length(q);
    return std::fabs(dot(normal, q)) > distance_ * length(normal) * (1 + 0x1p-40) + doubt;
}

bool Nearness::is_in_plane(const double* a, const double* b, const double* c,
                           const double* p) const {
    if (is_exact()) return orientation(a, b, c, p) == 0;
    const Vector<double> across = normal(a, b, c);
    return std::fabs(dot(across, scaled(p) - scaled(a))) <= distance_ * length(across);
}

}  // namespace mgdt
