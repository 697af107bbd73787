// SPDX-License-Identifier: MIT
// A Delaunay triangulation by trying every quadruple of points: slow, short, and sharing no code
// with the library. Arithmetic is exact: 64-bit integers for small lattices, big integers for
// everything else.
//
// Ties follow O. Devillers and M. Teillaud, "Perturbations for Delaunay and weighted Delaunay 3D
// triangulations", Computational Geometry 44 (2011) 160-168. A point p is lifted to the height
// |p|^2 + eps_p, and the eps of the lexicographically larger of two points is infinitely larger
// than the other's. The triangulation is the projection of the lower hull of the lifted points;
// points themselves do not move, so flat quadruples are never tetrahedra.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace oracle {

using BigInteger = boost::multiprecision::cpp_int;
using Quadruple = std::array<std::size_t, 4>;

template <class Number>
using Point = std::array<Number, 3>;

template <class Number>
int sign(const Number& x) {
    return x > 0 ? 1 : (x < 0 ? -1 : 0);
}

template <class Number>
Point<Number> minus(const Point<Number>& a, const Point<Number>& b) {
    return {Number(a[0] - b[0]), Number(a[1] - b[1]), Number(a[2] - b[2])};
}

template <class Number>
Point<Number> cross(const Point<Number>& a, const Point<Number>& b) {
    return {Number(a[1] * b[2] - a[2] * b[1]), Number(a[2] * b[0] - a[0] * b[2]),
            Number(a[0] * b[1] - a[1] * b[0])};
}

template <class Number>
Number dot(const Point<Number>& a, const Point<Number>& b) {
    return Number(a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

// Six times the signed volume of abcd.
template <class Number>
Number volume(const Point<Number>& a, const Point<Number>& b, const Point<Number>& c,
              const Point<Number>& d) {
    return dot(cross(minus(b, a), minus(c, a)), minus(d, a));
}

template <class Number>
int orientation(const Point<Number>& a, const Point<Number>& b, const Point<Number>& c,
                const Point<Number>& d) {
    return sign(volume(a, b, c, d));
}

// +1 if q is inside the perturbed circumsphere of the positively oriented tetrahedron t, -1 if
// outside. Above q, the plane through the lifted vertices has the height sum_i l_i h_i, where l
// are q's barycentric coordinates; q is inside when its own height is less than that.
template <class Number>
int side_of_sphere(const std::array<Point<Number>, 4>& t, const Point<Number>& q) {
    const Point<Number> b = minus(t[1], t[0]), c = minus(t[2], t[0]), d = minus(t[3], t[0]),
                        p = minus(q, t[0]);
    const Number total = dot(cross(b, c), d);
    const Number lb = dot(cross(p, c), d), lc = dot(cross(b, p), d), ld = dot(cross(b, c), p);
    const std::array<Number, 4> weight = {Number(total - lb - lc - ld), lb, lc, ld};
    const Number above = total * dot(p, p) - lb * dot(b, b) - lc * dot(c, c) - ld * dot(d, d);
    if (above != 0) return -sign(above);

    // The lifted points lie on one plane: the largest point with a nonzero coefficient decides.
    std::array<int, 5> order = {0, 1, 2, 3, 4};
    const auto& at = [&](int i) -> const Point<Number>& {
        return i == 4 ? q : t[static_cast<std::size_t>(i)];
    };
    std::sort(order.begin(), order.end(), [&](int i, int j) { return at(i) > at(j); });
    for (int i : order) {
        if (i == 4) return -1;  // q itself is raised
        const int s = sign(weight[static_cast<std::size_t>(i)]);
        if (s != 0) return s;  // raising vertex i raises the plane above q by l_i
    }
    return 0;  // q equals a vertex
}

struct Triangulation {
    int dimension = -1;
    std::vector<std::size_t> representative;  // first point with the same coordinates
    std::vector<Quadruple> tetrahedra;        // positively oriented
};

template <class Number>
int affine_dimension(const std::vector<Point<Number>>& p) {
    if (p.empty()) return -1;
    std::size_t b = 0, c = 0;
    for (std::size_t i = 1; i < p.size() && b == 0; ++i)
        if (p[i] != p[0]) b = i;
    if (b == 0) return 0;
    const Point<Number> zero{};
    for (std::size_t i = 1; i < p.size() && c == 0; ++i)
        if (cross(minus(p[b], p[0]), minus(p[i], p[0])) != zero) c = i;
    if (c == 0) return 1;
    for (const auto& q : p)
        if (orientation(p[0], p[b], p[c], q) != 0) return 3;
    return 2;
}

template <class Number>
Triangulation triangulate(const std::vector<Point<Number>>& p) {
    Triangulation out;
    out.dimension = affine_dimension(p);
    std::vector<std::size_t> vertices;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto first =
            static_cast<std::size_t>(std::find(p.begin(), p.end(), p[i]) - p.begin());
        out.representative.push_back(first);
        if (first == i) vertices.push_back(i);
    }
    const std::size_t n = vertices.size();
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 1; j < n; ++j)
            for (std::size_t k = j + 1; k < n; ++k)
                for (std::size_t l = k + 1; l < n; ++l) {
                    Quadruple v = {vertices[i], vertices[j], vertices[k], vertices[l]};
                    const int o = orientation(p[v[0]], p[v[1]], p[v[2]], p[v[3]]);
                    if (o == 0) continue;
                    if (o < 0) std::swap(v[2], v[3]);
                    const std::array<Point<Number>, 4> t = {p[v[0]], p[v[1]], p[v[2]], p[v[3]]};
                    const bool empty =
                        std::none_of(vertices.begin(), vertices.end(), [&](std::size_t q) {
                            return std::find(v.begin(), v.end(), q) == v.end() &&
                                   side_of_sphere(t, p[q]) > 0;
                        });
                    if (empty) out.tetrahedra.push_back(v);
                }
    return out;
}

// The doubles as integers, all times the same power of two: exact for every finite double.
inline std::vector<Point<BigInteger>> exact_points(const std::vector<double>& xyz) {
    int least = std::numeric_limits<int>::max();
    for (double x : xyz) {
        if (x == 0) continue;
        int e = 0;
        std::frexp(x, &e);
        least = std::min(least, e - 53);
    }
    std::vector<Point<BigInteger>> points(xyz.size() / 3);
    for (std::size_t i = 0; i < xyz.size(); ++i) {
        if (xyz[i] == 0) continue;
        int e = 0;
        const double mantissa = std::ldexp(std::frexp(xyz[i], &e), 53);
        BigInteger value = static_cast<std::int64_t>(mantissa);
        value <<= static_cast<unsigned>(e - 53 - least);
        points[i / 3][i % 3] = value;
    }
    return points;
}

// Whether every coordinate is an integer of magnitude at most 2^9. Differences are then at most
// 2^10, volumes 6 * 2^30, squared lengths 3 * 2^20 and side_of_sphere's sums below 2^58.
inline bool fits_small(const std::vector<double>& xyz) {
    return std::all_of(xyz.begin(), xyz.end(),
                       [](double x) { return std::fabs(x) <= 512 && x == std::floor(x); });
}

inline std::vector<Point<std::int64_t>> small_points(const std::vector<double>& xyz) {
    std::vector<Point<std::int64_t>> points(xyz.size() / 3);
    for (std::size_t i = 0; i < xyz.size(); ++i)
        points[i / 3][i % 3] = static_cast<std::int64_t>(xyz[i]);
    return points;
}

inline Triangulation triangulate(const std::vector<double>& xyz) {
    return fits_small(xyz) ? triangulate(small_points(xyz)) : triangulate(exact_points(xyz));
}

}  // namespace oracle
