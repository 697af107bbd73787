// SPDX-License-Identifier: MIT
// The quality of a tetrahedron in doubles: the least sine of its dihedral angles, squared.
#pragma once

#include <algorithm>
#include <cmath>

#include "solid/rounded_volume.hpp"

namespace mgdt {

// Sines of obtuse angles count 0.7 times: of two angles with the same sine the obtuse one is worse.
constexpr double obtuse_weight = 0.7;

// The quality of a regular tetrahedron, and a number above all qualities.
constexpr double best_quality = 8.0 / 9, above_all = 2;

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
    using Edge = Vector<double>;
    const Edge u = difference<double>(b, a), v = difference<double>(c, a),
               w = difference<double>(d, a);
    double size;
    const double volume = rounded_volume(u, v, w, size);
    if (!(volume > volume_error * size + least_product)) return 0;
    // The normals point inwards, and their sum is 0.
    const Vector<double> n1 = cross(v, w), n2 = cross(w, u), n3 = cross(u, v),
                         n0 = -1.0 * ((n1 + n2) + n3);
    const double s0 = dot(n0, n0), s1 = dot(n1, n1), s2 = dot(n2, n2), s3 = dot(n3, n3);
    const auto weight = [](const Vector<double>& one, const Vector<double>& other) {
        return dot(one, other) > 0 ? obtuse_weight * obtuse_weight : 1.0;
    };
    // For the edge between corners i and j: the squared length times the squares of the normals i
    // and j, whose product with those of the other two is the same for all edges.
    const Edge uv = v - u, vw = w - v, wu = u - w;
    const double least =
        std::min({dot(u, u) * s0 * s1 * weight(n2, n3), dot(v, v) * s0 * s2 * weight(n1, n3),
                  dot(w, w) * s0 * s3 * weight(n1, n2), dot(uv, uv) * s1 * s2 * weight(n0, n3),
                  dot(vw, vw) * s2 * s3 * weight(n0, n1), dot(wu, wu) * s3 * s1 * weight(n0, n2)});
    const double product = (s0 * s1) * (s2 * s3);
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
    const double volume = rounded_volume(difference<double>(b, a), difference<double>(c, a),
                                         difference<double>(d, a), size);
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
