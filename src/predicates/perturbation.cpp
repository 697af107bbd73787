// SPDX-License-Identifier: MIT
// Ties of cospherical points, broken as by Devillers and Teillaud, "Perturbations for Delaunay
// and weighted Delaunay 3D triangulations", Computational Geometry 44 (2011) 160-168.
#include "predicates.hpp"

namespace mgdt {

int compare_lexicographic(const double* a, const double* b) {
    for (int k = 0; k < 3; ++k) {
        if (a[k] < b[k]) return -1;
        if (a[k] > b[k]) return 1;
    }
    return 0;
}

// Every point p is thought of as lifted to |p|^2 + e(p), where the e(p) are positive, infinitely
// small, and each infinitely larger than that of any lexicographically smaller point. The
// determinant is linear in the lifts; the first of the points, from the largest down, whose
// lift has a nonzero coefficient decides. That of q is -orientation(a, b, c, d) < 0, that of a
// vertex is the orientation with q in the vertex's place.
int side_of_sphere_perturbed(const double* a, const double* b, const double* c, const double* d,
                             const double* q) {
    const int s = side_of_sphere(a, b, c, d, q);
    if (s != 0) return s;

    // The vertices larger than q, largest first; those smaller than q are never reached.
    const double* const vertex[4] = {a, b, c, d};
    int larger[4];
    int count = 0;
    for (int v = 0; v < 4; ++v) {
        const int order = compare_lexicographic(vertex[v], q);
        if (order == 0) return 0;
        if (order < 0) continue;
        int at = count++;
        for (; at > 0 && compare_lexicographic(vertex[larger[at - 1]], vertex[v]) < 0; --at) {
            larger[at] = larger[at - 1];
        }
        larger[at] = v;
    }
    for (int i = 0; i < count; ++i) {
        const double* replaced[4] = {a, b, c, d};
        replaced[larger[i]] = q;
        const int o = orientation(replaced[0], replaced[1], replaced[2], replaced[3]);
        if (o != 0) return o;
    }
    return -1;
}

}  // namespace mgdt
