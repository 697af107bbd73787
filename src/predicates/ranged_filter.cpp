// SPDX-License-Identifier: MIT
// Filters for orientation and the sphere predicate, for coordinates outside the range of the plain
// filters. The first is in doubles, with each axis scaled to size 1; it decides if one axis is much
// longer than another. The second is in doubles with a separate exponent.
//
// Differences from one point and differences along a tree over the points have the same
// determinant. The differences along the shortest tree preserve what distinguishes the points of a
// cluster, however far away the other points are.
#include "predicates/determinants.hpp"
#include "predicates/ranged.hpp"
#include "predicates/stages.hpp"

namespace mgdt::exact {
namespace {

// The shortest tree over N points and an origin, by Prim's algorithm: parent[i] is a point, or N
// for the origin. The length of an edge is the largest difference of coordinates. Every tree gives
// a correct result.
template <int N>
struct ShortestTree {
    int parent[N];

    explicit ShortestTree(const double* const (&p)[N], const double* origin) {
        double distance[N];
        bool is_in[N] = {};
        each<N>([&](auto i) {
            distance[i] = between(p[i], origin);
            parent[i] = N;
        });
        for (int turn = 0; turn < N; ++turn) {
            int next = -1;
            for (int i = 0; i < N; ++i)
                if (!is_in[i] && (next < 0 || distance[i] < distance[next])) next = i;
            is_in[next] = true;
            for (int i = 0; i < N; ++i) {
                if (is_in[i]) continue;
                const double d = between(p[i], p[next]);
                if (!(d < distance[i])) continue;
                distance[i] = d;
                parent[i] = next;
            }
        }
    }

  private:
    static double between(const double* a, const double* b) {
        const double d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
        return largest_of<0, 3>(d);
    }
};

// The differences between N points and their parents in the tree.
template <int N>
struct TreeRows {
    Ranged of[3 * N];

    TreeRows(const double* const (&p)[N], const double* origin, const ShortestTree<N>& tree) {
        each<N>([&](auto i) {
            const double* const from = tree.parent[i] == N ? origin : p[tree.parent[i]];
            for (std::size_t k = 0; k < 3; ++k) of[3 * i + k] = ranged_difference(p[i][k], from[k]);
        });
    }
    void magnitudes(RangedMagnitude (&to)[3 * N]) const {
        each<3 * N>([&](auto i) { to[i] = magnitude(of[i]); });
    }
};

// Computes |p|^2 - |r|^2 as (p - r) . (p + r). `difference` is p - r, and p and r are relative to
// the origin.
template <class T>
T lift(const T* difference, const T* p, const T* r) {
    return (difference[0] * (p[0] + r[0]) + difference[1] * (p[1] + r[1])) +
           difference[2] * (p[2] + r[2]);
}

// SphereDeterminant with given lifts in place of the squares of the rows.
template <class T>
T sphere_value(const T (&rows)[12], const T (&lifts)[4]) {
    const auto minors = SphereDeterminant::minors(rows);
    return (lifts[0] * minors.of[0] - lifts[1] * minors.of[1]) +
           (lifts[2] * minors.of[2] - lifts[3] * minors.of[3]);
}

// Differences, each axis multiplied by a power of two that brings the largest difference to [1, 2)
// or near it. What underflows is far below the bound of a filter.
template <int N>
struct ScaledAxes {
    double value[N];
    int highest = -limit;  // the exponent of the longest axis

    explicit ScaledAxes(const Differences<N>& d) {
        double factor[3];
        each<3>([&](auto k) {
            double m = 0;
            each<N / 3>([&](auto i) {
                const double size = std::fabs(d.rounded[3 * i + k]);
                m = size > m ? size : m;
            });
            exponent_[k] = static_cast<int>(bits_of(m) >> 52) - 1023;
            if (exponent_[k] > limit) exponent_[k] = limit;
            if (exponent_[k] < -limit) exponent_[k] = -limit;
            if (exponent_[k] > highest) highest = exponent_[k];
            factor[k] = power_of_two(-exponent_[k]);
        });
        each<N>([&](auto i) { value[i] = d.rounded[i] * factor[i % 3]; });
    }
    // The factor that converts from the scale of an axis to that of the longest axis.
    double shrink(int axis) const {
        const int shift = highest - exponent_[axis];
        return shift > limit ? 0.0 : power_of_two(-shift);
    }

  private:
    static constexpr int limit = 1000;
    static double power_of_two(int exponent) {
        return double_of(static_cast<std::uint64_t>(1023 + exponent) << 52);
    }
    int exponent_[3];
};

// An upper bound on the scaled differences: doubles below 2^1024 times a factor of 2^-1000.
constexpr double scaled_largest = 0x1p24;

}  // namespace

int orientation_scaled(const double* a, const double* b, const double* c, const double* d,
                       const Bound& bound) {
    const auto v = differences({b, c, d}, a);
    if (!(v.largest <= std::numeric_limits<double>::max())) return undecided;
    const ScaledAxes<9> scaled(v);
    Magnitude sizes[9];
    each<9>([&](auto i) { sizes[i].value = std::fabs(scaled.value[i]); });
    const OrientationDeterminant determinant;
    return filtered_value(determinant(scaled.value), determinant(sizes).value, scaled_largest,
                          bound);
}

int sphere_scaled(const double* a, const double* b, const double* c, const double* d,
                  const double* q, const Bound& bound) {
    const auto v = differences({a, b, c, d}, q);
    if (!(v.largest <= std::numeric_limits<double>::max())) return undecided;
    const ScaledAxes<12> scaled(v);
    const double shrink[3] = {scaled.shrink(0), scaled.shrink(1), scaled.shrink(2)};
    Magnitude sizes[12];
    double squares[4];
    each<12>([&](auto i) { sizes[i].value = std::fabs(scaled.value[i]); });
    each<4>([&](auto i) {
        const double* const p = scaled.value + 3 * i;
        const double common[3] = {p[0] * shrink[0], p[1] * shrink[1], p[2] * shrink[2]};
        squares[i] = SphereDeterminant::square(common);
    });
    const auto minors = SphereDeterminant::minors(scaled.value);
    const auto minor_sizes = SphereDeterminant::minors(sizes);
    const double value = (squares[0] * minors.of[0] - squares[1] * minors.of[1]) +
                         (squares[2] * minors.of[2] - squares[3] * minors.of[3]);
    const double size =
        (squares[0] * minor_sizes.of[0].value + squares[1] * minor_sizes.of[1].value) +
        (squares[2] * minor_sizes.of[2].value + squares[3] * minor_sizes.of[3].value);
    return filtered_value(value, size, scaled_largest, bound);
}

int orientation_ranged(const double* a, const double* b, const double* c, const double* d,
                       double bound) {
    const double* const p[3] = {b, c, d};
    const TreeRows<3> rows(p, a, ShortestTree<3>(p, a));
    RangedMagnitude sizes[9];
    rows.magnitudes(sizes);
    const OrientationDeterminant determinant;
    return ranged_sign(determinant(rows.of), determinant(sizes), bound);
}

int sphere_ranged(const double* a, const double* b, const double* c, const double* d,
                  const double* q, double bound) {
    const double* const p[4] = {a, b, c, d};
    const ShortestTree<4> tree(p, q);
    const TreeRows<4> rows(p, q, tree);
    Ranged from_q[15] = {}, lifts[4];
    RangedMagnitude sizes[12], from_q_sizes[15], lift_sizes[4];
    each<12>([&](auto i) { from_q[i] = ranged_difference(p[i / 3][i % 3], q[i % 3]); });
    for (int k = 12; k < 15; ++k) from_q[k] = {0.0, exponent_of_zero};
    each<15>([&](auto i) { from_q_sizes[i] = magnitude(from_q[i]); });
    rows.magnitudes(sizes);
    each<4>([&](auto i) {
        const int row = 3 * static_cast<int>(i), parent = 3 * tree.parent[i];
        lifts[i] = lift(rows.of + row, from_q + row, from_q + parent);
        lift_sizes[i] = lift(sizes + row, from_q_sizes + row, from_q_sizes + parent);
    });
    return ranged_sign(sphere_value(rows.of, lifts), sphere_value(sizes, lift_sizes), bound);
}

}  // namespace mgdt::exact
