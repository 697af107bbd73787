// SPDX-License-Identifier: MIT
// Breaks ties of cospherical points as Devillers and Teillaud do, "Perturbations for Delaunay and
// weighted Delaunay 3D triangulations", Computational Geometry 44 (2011) 160-168.
//
// Every point p is lifted to |p|^2 + e(p), where e(p) is positive and infinitely small, and
// infinitely larger than e(r) of every lexicographically smaller point r. The determinant is linear
// in the lifts. So the lexicographically largest point whose lift has a nonzero coefficient
// decides. The coefficient of q is -orientation(a, b, c, d) < 0. The coefficient of a vertex is the
// orientation with q in the vertex's place; it is the minor, with its sign, by which the vertex's
// square is multiplied in the determinant. The coefficient of q is not 0, so vertices smaller than
// q do not matter.
#include "predicates/determinants.hpp"
#include "predicates/lattice.hpp"
#include "predicates/native_integer.hpp"
#include "predicates/predicates.hpp"
#include "predicates/stages.hpp"

namespace mgdt {

int compare_lexicographic(const double* a, const double* b) {
    for (int k = 0; k < 3; ++k) {
        if (a[k] < b[k]) return -1;
        if (a[k] > b[k]) return 1;
    }
    return 0;
}

namespace exact {
namespace {

MGDT_PREDICATES_INLINE double larger(double a, double b) {
    return a > b ? a : b;
}

// On a lattice the determinant is exact; elsewhere the computed value has to pass a filter. On a
// lattice each point relative to q has one number, its key, such that keys have the lexicographic
// order of the points; the key of q is 0. Half of the results on lattices are ties, so ties are
// broken without a branch.
MGDT_PREDICATES_INLINE int doubles(const Differences<12>& v) {
    const auto minors = SphereDeterminant::minors(v.rounded);
    const double value = SphereDeterminant::value(v.rounded, minors);
    if (!is_lattice<sphere_lattice_bits>(v)) {
        if (!(v.largest <= filter_limit)) return undecided;
        return filtered_value(value, size_of(v, SphereDeterminant()), v.largest, sphere_bound);
    }
    if (value != 0) return value > 0 ? 1 : -1;
    double inside = 0, outside = 0;  // the largest keys that put q inside, or outside
    bool is_vertex = false;
    each<4>([&](auto i) {
        const double* const p = v.rounded + 3 * i;
        const double key = (p[0] * sphere_lattice_base + p[1]) * sphere_lattice_base + p[2];
        const double coefficient = i % 2 == 0 ? minors.of[i] : -minors.of[i];
        inside = larger(inside, coefficient > 0 ? key : 0);
        outside = larger(outside, coefficient < 0 ? key : 0);
        is_vertex |= key == 0;
    });
    if (is_vertex) return 0;
    return inside > outside ? 1 : -1;
}

// Breaks a tie. coefficient(i) gives the sign of the coefficient of vertex i. Returns 0 if q is at
// a vertex.
template <class Coefficient>
int broken_tie(const double* const (&vertex)[4], const double* q, const Coefficient& coefficient) {
    const double* largest = q;
    int side = -1;
    for (int i = 0; i < 4; ++i) {
        const int order = compare_lexicographic(vertex[i], q);
        if (order == 0) return 0;
        if (order < 0 || compare_lexicographic(vertex[i], largest) < 0) continue;
        const int s = coefficient(i);
        if (s == 0) continue;
        largest = vertex[i];
        side = s;
    }
    return side;
}

}  // namespace

int perturbed_doubles(const double* a, const double* b, const double* c, const double* d,
                      const double* q) {
    return doubles(differences({a, b, c, d}, q));
}

int perturbed_native(const double* a, const double* b, const double* c, const double* d,
                     const double* q) {
    if constexpr (have_native) {
        std::int64_t n[12];
        if (!to_native(differences({a, b, c, d}, q), n)) return undecided;
        const NativeSphere sphere(n);
        if (sphere.sign != 0) return sphere.sign;
        // Breaks the tie as broken_tie() does, but without a branch.
        std::int64_t first[3] = {};
        int side = -1;
        bool is_vertex = false;
        each<4>([&](auto i) {
            const std::int64_t* const p = n + 3 * i;
            is_vertex |= (p[0] | p[1] | p[2]) == 0;
            const int s = sphere.minor[i].sign();
            const bool is_after = (p[0] > first[0]) |
                                  ((p[0] == first[0]) &
                                   ((p[1] > first[1]) | ((p[1] == first[1]) & (p[2] > first[2]))));
            const bool decides = is_after & (s != 0);
            for (int k = 0; k < 3; ++k) first[k] = decides ? p[k] : first[k];
            side = decides ? (i % 2 == 0 ? s : -s) : side;
        });
        return is_vertex ? 0 : side;
    }
    return undecided;
}

int perturbed_sparse(const double* a, const double* b, const double* c, const double* d,
                     const double* q, Terms terms) {
    int minors[4];
    const int s = sphere_sparse(a, b, c, d, q, terms, minors);
    if (s != 0) return s;
    return broken_tie({a, b, c, d}, q, [&](int i) { return i % 2 == 0 ? minors[i] : -minors[i]; });
}

int perturbed_by_parts(const double* a, const double* b, const double* c, const double* d,
                       const double* q) {
    const int s = sphere_integer(a, b, c, d, q);
    if (s != 0) return s;
    return broken_tie({a, b, c, d}, q, [&](int i) {
        const double* replaced[4] = {a, b, c, d};
        replaced[i] = q;
        return orientation(replaced[0], replaced[1], replaced[2], replaced[3]);
    });
}

int perturbed_integers(const double* a, const double* b, const double* c, const double* d,
                       const double* q) {
    int s = perturbed_native(a, b, c, d, q);
    if (s == undecided) s = sphere_scaled(a, b, c, d, q);
    if (s == undecided) s = perturbed_sparse(a, b, c, d, q, Terms::single);
    if (s == undecided) s = sphere_ranged(a, b, c, d, q);
    // sphere_ranged() does not break ties, so the next stages have to.
    if (s == undecided || s == 0) s = perturbed_sparse(a, b, c, d, q, Terms::any);
    return s != undecided ? s : perturbed_by_parts(a, b, c, d, q);
}

}  // namespace exact

int side_of_sphere_perturbed(const double* a, const double* b, const double* c, const double* d,
                             const double* q) {
    const int s = exact::perturbed_doubles(a, b, c, d, q);
    return s != exact::undecided ? s : exact::perturbed_integers(a, b, c, d, q);
}

}  // namespace mgdt
