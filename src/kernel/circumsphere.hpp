// SPDX-License-Identifier: MIT
// The cached circumsphere of a tetrahedron and the filtered power of a point.
//
// With base vertex p = v[0], A, B, C the other vertices relative to p, and u = q - p, the power
// of q with respect to the circumsphere is |u|^2 - w.u, where w = 2 (centre - p) solves
// w.A = |A|^2, w.B = |B|^2, w.C = |C|^2. A ghost's "power" is -n.u with n the normal of its hull
// facet, pointing outwards. Either is negative exactly when q is in conflict.
//
// The bounds below are derived in docs/theory.md, "The kernel's filter". They hold when every
// coordinate involved is zero or within the normal range; elsewhere the error is set to infinity,
// which leaves every decision to the exact predicates.
#pragma once

#include <cmath>
#include <cstring>
#include <limits>

#include "kernel/island.hpp"
#include "mesh/tetrahedron.hpp"
#include "predicates/normal_range.hpp"

namespace mgdt {

struct Mesh;

inline namespace MGDT_ISLAND {

// Coefficients of the error bounds, in units of 2^-53. Tests make them smaller to see the filter
// fail.
struct FilterBounds {
    double quadratic = 8;     // of |u|^2 in the power
    double sphere_sum = 40;   // of `sum` in set_sphere(), the size of the numerators of w
    double sphere_det = 128;  // of max|w| times the largest product in the determinant
    double normal = 20;       // of a ghost's normal
};
inline constexpr FilterBounds proved_bounds{};
inline constexpr double unit_roundoff = 0x1p-53;
// Rounding a sphere for storage adds this part of its largest coefficient to the bound: 2^-21, and
// the truncation of the bound itself. See docs/theory.md, "Spheres that are kept".
inline constexpr double kept_roundoff = 0x1.00004p-21;
// As the bound of a sphere, infinity leaves every test to the exact predicates.
inline constexpr double infinity = std::numeric_limits<double>::infinity();

// A point whose powers are computed. `quadratic` is infinite for a point outside the normal range.
struct Query {
    explicit Query(const double* point) : Query(point, in_normal_range(point)) {}
    Query(const double* point, bool is_normal)
        : x(point[0]),
          y(point[1]),
          z(point[2]),
          quadratic(is_normal ? proved_bounds.quadratic * unit_roundoff : infinity),
          point(point) {}
    double x, y, z;
    double quadratic;
    const double* point;
};

// The computed power and a bound on its error. Any comparison with a NaN is false, so tests have to
// be written such that false means undecided.
struct Power {
    double value, error;
    bool is_conflict() const { return value < -error; }
    bool is_decided() const { return std::fabs(value) > error; }
};

// The power of q with respect to the sphere s of a tetrahedron with base vertex p.
inline Power power(const Sphere& s, const double* p, const Query& q) {
    const double ux = q.x - p[0], uy = q.y - p[1], uz = q.z - p[2];
    double square = ux * ux + uy * uy + uz * uz;
    square = s.is_ghost() ? 0.0 : square;
    const double value = square - (s.w[0] * ux + s.w[1] * uy + s.w[2] * uz);
    const double error =
        std::fabs(s.e) * (std::fabs(ux) + std::fabs(uy) + std::fabs(uz)) + q.quadratic * square;
    return {value, error};
}

// A vertex relative to the base vertex, with two terms that every sphere through it needs.
struct LocalVertex {
    double x, y, z;
    double square;   // |.|^2
    double largest;  // max of the coordinates' magnitudes
};

MGDT_ALWAYS_INLINE double max_magnitude(double a, double b, double c) {
    a = std::fabs(a);
    b = std::fabs(b);
    c = std::fabs(c);
    a = a > b ? a : b;
    return a > c ? a : c;
}

MGDT_ALWAYS_INLINE LocalVertex local_vertex(double x, double y, double z) {
    return {x, y, z, x * x + y * y + z * z, max_magnitude(x, y, z)};
}

MGDT_ALWAYS_INLINE LocalVertex relative_to(const double* a, const double* base) {
    return local_vertex(a[0] - base[0], a[1] - base[1], a[2] - base[2]);
}

// For 0 the result is infinite, as callers expect.
MGDT_MAY_DIVIDE_BY_ZERO MGDT_ALWAYS_INLINE double reciprocal(double x) {
    return 1.0 / x;
}

// Computes w and e of the finite tetrahedron (base, a, b, c). If the determinant is 0 or too small
// to be trusted, e is infinite and w is arbitrary.
inline void set_sphere(const LocalVertex& a, const LocalVertex& b, const LocalVertex& c, Sphere& s,
                       const FilterBounds& bounds = proved_bounds) {
    const double bcx = b.y * c.z - b.z * c.y, bcy = b.z * c.x - b.x * c.z,
                 bcz = b.x * c.y - b.y * c.x;
    const double cax = c.y * a.z - c.z * a.y, cay = c.z * a.x - c.x * a.z,
                 caz = c.x * a.y - c.y * a.x;
    const double abx = a.y * b.z - a.z * b.y, aby = a.z * b.x - a.x * b.z,
                 abz = a.x * b.y - a.y * b.x;
    const double det = a.x * bcx + a.y * bcy + a.z * bcz;
    const double inverse = reciprocal(det);
    const double wx = a.square * bcx + b.square * cax + c.square * abx;
    const double wy = a.square * bcy + b.square * cay + c.square * aby;
    const double wz = a.square * bcz + b.square * caz + c.square * abz;
    s.w[0] = wx * inverse;
    s.w[1] = wy * inverse;
    s.w[2] = wz * inverse;
    const double lbc = b.largest * c.largest, lca = c.largest * a.largest,
                 lab = a.largest * b.largest;
    const double sum = a.square * lbc + b.square * lca + c.square * lab;
    const double product = a.largest * lbc;
    const double largest = max_magnitude(s.w[0], s.w[1], s.w[2]);
    const double bound =
        unit_roundoff * inverse * (bounds.sphere_sum * sum + bounds.sphere_det * product * largest);
    const bool sound = det > bounds.sphere_det * unit_roundoff * product;
    s.e = sound ? bound : infinity;
}

// Computes w and e of the ghost whose hull facet is (base, a, b) and whose last vertex is at
// infinity.
inline void set_normal(const LocalVertex& a, const LocalVertex& b, Sphere& s,
                       const FilterBounds& bounds = proved_bounds) {
    s.w[0] = a.y * b.z - a.z * b.y;
    s.w[1] = a.z * b.x - a.x * b.z;
    s.w[2] = a.x * b.y - a.y * b.x;
    s.e = -(bounds.normal * unit_roundoff * a.largest * b.largest);
}

// The double whose upper half is x rounded to nearest.
MGDT_ALWAYS_INLINE double to_upper_half(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    bits += 0x80000000u;
    std::memcpy(&x, &bits, sizeof x);
    return x;
}

// A sphere rounded for storage.
inline KeptSphere rounded(const Sphere& s, double roundoff = kept_roundoff) {
    const double e = std::fabs(s.e) + max_magnitude(s.w[0], s.w[1], s.w[2]) * roundoff;
    // If the bound is infinite, w may be NaN, and e with it.
    const double sound = std::fabs(s.e) < infinity ? e : infinity;
    return {{upper_half(to_upper_half(s.w[0])), upper_half(to_upper_half(s.w[1])),
             upper_half(to_upper_half(s.w[2]))},
            upper_half(std::copysign(sound, s.e))};
}

}  // namespace MGDT_ISLAND

// The sphere of any tetrahedron, computed from its vertices. The tetrahedron may be marked. If a
// vertex is outside the normal range, the bound is infinite.
Sphere circumsphere(const Tetrahedron& t, const Vertex* vertices);

// Whether q is in conflict with t. The result is exact; perturbation decides ties. q must not be a
// vertex of t.
bool is_conflict_exact(const Mesh& mesh, const Tetrahedron& t, const double* q);

// The vertex of t that has the coordinates of q, or infinite_vertex.
VertexId vertex_at(const Mesh& mesh, const Tetrahedron& t, const double* q);

}  // namespace mgdt
