// SPDX-License-Identifier: MIT
#include "improvement/quality_gradient.hpp"

#include <cmath>

#include "improvement/quality.hpp"

namespace mgdt {
// The quality is D^2 L / (N_k N_m): see quality_of(), with L for the squared length of the edge and
// N_i for the square of normal i. So its gradient is the quality times the sum of 2 grad D / D,
// grad L / L, -grad N_k / N_k and -grad N_m / N_m. D grows in the direction of the normal of the
// face opposite a; N of a face a, y, z has the gradient 2 (y - z) x n.
QualityGradient quality_gradient(const double* a, const double* b, const double* c,
                                 const double* d) noexcept {
    // Edges from a to the corners 1, 2, 3, and the edges opposite these corners in their face.
    const Vector<double> e[4] = {
        {{0, 0, 0}}, difference<double>(b, a), difference<double>(c, a), difference<double>(d, a)};
    const Vector<double> opposite[4] = {{{0, 0, 0}}, e[2] - e[3], e[3] - e[1], e[1] - e[2]};
    const Vector<double> n1 = cross(e[2], e[3]), n2 = cross(e[3], e[1]), n3 = cross(e[1], e[2]);
    const Vector<double> n[4] = {-1.0 * ((n1 + n2) + n3), n1, n2, n3};
    const double volume = dot(e[1], n1);
    double square[4];
    for (int i = 0; i < 4; ++i) square[i] = dot(n[i], n[i]);
    // Finds the edge with the worst angle. Each row has the corners i and j at the ends of an edge,
    // and the corners k and m opposite the two faces at that edge.
    static constexpr unsigned char corners[6][4] = {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2},
                                                    {1, 2, 0, 3}, {2, 3, 0, 1}, {1, 3, 0, 2}};
    double least = 0, length = 0;
    int worst = -1;
    for (int edge = 0; edge < 6; ++edge) {
        const unsigned i = corners[edge][0], j = corners[edge][1], k = corners[edge][2],
                       m = corners[edge][3];
        // The edge between corners 1, 2, 3 without corner 6 - i - j.
        const double l = i == 0 ? dot(e[j], e[j]) : dot(opposite[6 - i - j], opposite[6 - i - j]);
        const double weight = dot(n[k], n[m]) > 0 ? obtuse_weight * obtuse_weight : 1.0;
        const double value = l * weight * square[i] * square[j];
        if (worst >= 0 && !(value < least)) continue;
        least = value;
        length = l;
        worst = edge;
    }
    QualityGradient result = {0, {0, 0, 0}};
    const double product = (square[0] * square[1]) * (square[2] * square[3]);
    if (!(volume > 0 && product > least_product)) return result;
    result.quality = volume * volume * least / product;
    const unsigned i = corners[worst][0], j = corners[worst][1];
    for (int q = 0; q < 3; ++q) {
        result.by[q] = 2 * n[0].x[q] / volume;
        if (i == 0) result.by[q] -= 2 * e[j].x[q] / length;
    }
    for (const unsigned face : {corners[worst][2], corners[worst][3]}) {
        if (face == 0) continue;
        const Vector<double> by = cross(opposite[face], n[face]);
        for (int q = 0; q < 3; ++q) result.by[q] -= 2 * by.x[q] / square[face];
    }
    for (double& q : result.by) q *= result.quality;
    return result;
}

}  // namespace mgdt
