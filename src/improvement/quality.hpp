// SPDX-License-Identifier: MIT
// The quality of a tetrahedron in doubles: the least sine of its dihedral angles, squared.
#pragma once

#include <algorithm>
#include <cmath>

namespace mgdt {

// Sines of obtuse angles count 0.7 times: of two angles with the same sine the obtuse one is worse.
constexpr double obtuse_weight = 0.7;

// The quality of a regular tetrahedron, and a number above all qualities.
constexpr double best_quality = 8.0 / 9, above_all = 2;

// An upper bound on the error of six times the volume of a tetrahedron, as quality_of() computes
// it, relative to the same sum with all terms positive (docs/theory.md, "The quality of a
// tetrahedron").
constexpr double volume_error = 9 * 0x1p-53;
// What underflow can lose of a volume is below this, and what is below it counts as nothing.
constexpr double least_product = 0x1p-1000;

// Six times the volume of a tetrahedron, positive if it is positively oriented. `size` is the same
// sum with all terms positive.
inline double rounded_volume(const double* a, const double* b, const double* c, const double* d,
                             double& size) noexcept {
    const double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]},
                 v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]},
                 w[3] = {d[0] - a[0], d[1] - a[1], d[2] - a[2]};
    const auto minor = [&](int i, int j) { return v[i] * w[j] - v[j] * w[i]; };
    const auto minor_size = [&](int i, int j) {
        return std::fabs(v[i] * w[j]) + std::fabs(v[j] * w[i]);
    };
    size = (std::fabs(u[0]) * minor_size(1, 2) + std::fabs(u[1]) * minor_size(2, 0)) +
           std::fabs(u[2]) * minor_size(0, 1);
    return (u[0] * minor(1, 2) + u[1] * minor(2, 0)) + u[2] * minor(0, 1);
}

// The square of the least sine of the six dihedral angles of a tetrahedron, where the sines of
// obtuse angles are multiplied by obtuse_weight. It is at most 8/9. The result is 0 if the
// tetrahedron is not positive, or so flat or so small that rounding leaves its orientation open.
// Coordinates are at most 1 in magnitude, so nothing overflows.
//
// With n_i for the normal of the face opposite corner i, as long as twice its area, and l_ij for
// the length of the edge between corners i and j, the sine of the angle at that edge is
// D l_ij / (|n_k| |n_m|), where D is six times the volume, and k and m are the other corners.
inline double quality_of(const double* a, const double* b, const double* c,
                         const double* d) noexcept {
    const double u[3] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]},
                 v[3] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]},
                 w[3] = {d[0] - a[0], d[1] - a[1], d[2] - a[2]};
    const auto dot = [](const double* p, const double* q) {
        return (p[0] * q[0] + p[1] * q[1]) + p[2] * q[2];
    };
    const auto cross = [](const double* p, const double* q, double* out) {
        out[0] = p[1] * q[2] - p[2] * q[1];
        out[1] = p[2] * q[0] - p[0] * q[2];
        out[2] = p[0] * q[1] - p[1] * q[0];
    };
    // The normals point inwards, and their sum is 0.
    double n[4][3];
    cross(u, v, n[3]);
    cross(w, u, n[2]);
    cross(v, w, n[1]);
    for (int k = 0; k < 3; ++k) n[0][k] = -((n[1][k] + n[2][k]) + n[3][k]);
    double size;
    const double volume = rounded_volume(a, b, c, d, size);
    if (!(volume > volume_error * size + least_product)) return 0;
    const double square[4] = {dot(n[0], n[0]), dot(n[1], n[1]), dot(n[2], n[2]), dot(n[3], n[3])};
    const double uv[3] = {v[0] - u[0], v[1] - u[1], v[2] - u[2]},
                 vw[3] = {w[0] - v[0], w[1] - v[1], w[2] - v[2]},
                 wu[3] = {u[0] - w[0], u[1] - w[1], u[2] - w[2]};
    const auto weight = [&](int i, int j) {
        return dot(n[i], n[j]) > 0 ? obtuse_weight * obtuse_weight : 1.0;
    };
    // For the edge between corners i and j: the squared length times the squares of the normals at
    // its ends, whose product with those of the other two is the same for all edges.
    const double edges[6] = {dot(u, u) * square[0] * square[1] * weight(2, 3),
                             dot(v, v) * square[0] * square[2] * weight(1, 3),
                             dot(w, w) * square[0] * square[3] * weight(1, 2),
                             dot(uv, uv) * square[1] * square[2] * weight(0, 3),
                             dot(vw, vw) * square[2] * square[3] * weight(0, 1),
                             dot(wu, wu) * square[3] * square[1] * weight(0, 2)};
    const double least = std::min({edges[0], edges[1], edges[2], edges[3], edges[4], edges[5]});
    const double product = (square[0] * square[1]) * (square[2] * square[3]);
    return product > least_product ? volume * volume * least / product : 0;
}

// What a quality misses to a goal: 0 from the goal on, and the more, the worse it is. At half of
// the goal it is about 1, at the worst quality 100.
inline double missing_to(double goal, double quality) noexcept {
    constexpr double least_share = 0.01;
    return quality < goal ? (1 + least_share) * goal / (quality + least_share * goal) - 1 : 0;
}

// Another measure of a tetrahedron, for means: the square of its volume over the third power of its
// root mean square edge length, 1 for a regular tetrahedron (Parthasarathy, Graichen and Hathaway,
// Finite Elements in Analysis and Design 15, 1994). The tetrahedron is positive.
inline double volume_length_of(const double* a, const double* b, const double* c,
                               const double* d) noexcept {
    double size;
    const double volume = rounded_volume(a, b, c, d, size);
    const double* const p[4] = {a, b, c, d};
    double squares = 0;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < i; ++j)
            for (int k = 0; k < 3; ++k) squares += (p[i][k] - p[j][k]) * (p[i][k] - p[j][k]);
    const double cube = squares * squares * squares;
    // (6 sqrt(2) V)^2 = 2 (6 V)^2, and the mean square is a sixth of the sum.
    return cube > least_product ? 432 * volume * volume / cube : 0;
}

}  // namespace mgdt
