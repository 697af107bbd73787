// SPDX-License-Identifier: MIT
// Corners of cells and the planes that they lie in.
#pragma once

#include "predicates/vector.hpp"

namespace mgdt {

// A corner of a face: a point, or the direction of an unbounded ray.
struct Corner {
    Vector<double> x;
    double size, error;  // the length of x; an upper bound on the error of x
    bool is_ideal;
};

// The half-space normal . x <= offset. A cell lies in the half-space and has a face in the plane
// normal . x = offset.
struct Side {
    Vector<double> normal;
    double offset;
    double size;   // the length of the normal
    double error;  // a bound on the error of the offset; the components of the normal are off by
                   // one rounding

    double distance() const noexcept { return std::fabs(offset) / size; }
};

// Computes the point where three planes meet by Cramer's rule. The normals of p, q and r must be
// positively oriented in this order. Returns false if the normals are nearly in one plane, or if
// numbers leave the range of doubles. The error bound is derived in docs/theory.md, "Cells".
inline bool meet(const Side& p, const Side& q, const Side& r, Corner& corner) {
    constexpr double u = rounding_of<double>;
    const Vector<double> qr = cross(q.normal, r.normal), rp = cross(r.normal, p.normal),
                         pq = cross(p.normal, q.normal);
    const double d = dot(p.normal, qr), product = p.size * q.size * r.size;
    if (!(d > 1024 * u * product)) return false;
    const double inverse = 1 / d;
    for (int k = 0; k < 3; ++k)
        corner.x.x[k] = ((p.offset * qr.x[k] + q.offset * rp.x[k]) + r.offset * pq.x[k]) * inverse;
    corner.size = length(corner.x);
    const double distances = p.distance() + q.distance() + r.distance();
    const double errors = p.error / p.size + q.error / q.size + r.error / r.size;
    corner.error = (product / d) * (16 * u * (distances + corner.size) + errors);
    corner.is_ideal = false;
    return product > 0x1p-900;
}

}  // namespace mgdt
