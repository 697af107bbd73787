// SPDX-License-Identifier: MIT
// The predicates once more, by other formulas and in integers without limit: determinants of
// homogeneous coordinates, not of differences, by Bareiss' elimination.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "../support/small.h"

namespace reference {

using Big = boost::multiprecision::cpp_int;
using Point = std::array<double, 3>;
using BigPoint = std::array<Big, 3>;

// The points in units of one power of two, in which all are integers.
inline std::vector<BigPoint> scaled(const std::vector<Point>& points) {
    const auto low_exponent = [](double v) {
        int e;
        double m = std::frexp(v, &e);
        for (; m != std::floor(m); --e) m *= 2;  // m becomes odd: exact
        return e;
    };
    int low = 2000;
    for (const Point& p : points) {
        for (double v : p) {
            if (v != 0) low = std::min(low, low_exponent(v));
        }
    }
    std::vector<BigPoint> out;
    for (const Point& p : points) {
        BigPoint q;
        for (std::size_t k = 0; k < 3; ++k) {
            int e;
            const double m = std::frexp(p[k], &e);
            if (m == 0) continue;
            const int shift = e - 53 - low;
            const Big mantissa = static_cast<long long>(std::ldexp(m, 53));
            q[k] = shift >= 0 ? Big(mantissa << shift) : Big(mantissa / (Big(1) << -shift));
        }
        out.push_back(q);
    }
    return out;
}

using Matrix = std::vector<std::vector<Big>>;

// Bareiss, Sylvester's identity and multistep integer-preserving Gaussian elimination,
// Mathematics of Computation 22 (1968).
inline int sign_of_determinant(Matrix m) {
    const std::size_t n = m.size();
    Big previous = 1;
    int sign = 1;
    for (std::size_t k = 0; k + 1 < n; ++k) {
        std::size_t pivot = k;
        while (pivot < n && m[pivot][k] == 0) ++pivot;
        if (pivot == n) return 0;
        if (pivot != k) {
            std::swap(m[pivot], m[k]);
            sign = -sign;
        }
        for (std::size_t i = k + 1; i < n; ++i) {
            for (std::size_t j = k + 1; j < n; ++j) {
                m[i][j] = (m[i][j] * m[k][k] - m[i][k] * m[k][j]) / previous;
            }
        }
        previous = m[k][k];
    }
    return sign * m[n - 1][n - 1].sign();
}

inline Big square(const BigPoint& p) {
    return p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
}

inline int orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
    Matrix m;
    for (const BigPoint& p : scaled({a, b, c, d})) m.push_back({p[0], p[1], p[2], 1});
    return -sign_of_determinant(m);
}

inline int side_of_sphere(const Point& a, const Point& b, const Point& c, const Point& d,
                          const Point& q) {
    Matrix m;
    for (const BigPoint& p : scaled({a, b, c, d, q})) {
        m.push_back({p[0], p[1], p[2], square(p), 1});
    }
    return -sign_of_determinant(m);
}

// The sign of coordinate `axis` of (b - a) x (c - a).
inline int turn(const Point& a, const Point& b, const Point& c, std::size_t axis) {
    const std::vector<BigPoint> p = scaled({a, b, c});
    const std::size_t x = (axis + 1) % 3, y = (axis + 2) % 3;
    Big area = 0;  // of the projection, as a sum over the edges
    for (std::size_t i = 0; i < 3; ++i) {
        const BigPoint &u = p[i], &v = p[(i + 1) % 3];
        area += u[x] * v[y] - u[y] * v[x];
    }
    return area.sign();
}

inline bool collinear(const Point& a, const Point& b, const Point& c) {
    return turn(a, b, c, 0) == 0 && turn(a, b, c, 1) == 0 && turn(a, b, c, 2) == 0;
}

inline int compare_distance(const Point& q, const Point& a, const Point& b) {
    const std::vector<BigPoint> p = scaled({q, a, b});
    Big power = square(p[1]) - square(p[2]);
    for (std::size_t k = 0; k < 3; ++k) power -= 2 * p[0][k] * (p[1][k] - p[2][k]);
    return power.sign();
}

inline int compare_lengths(const Point& a, const Point& b, const Point& c, const Point& d) {
    const std::vector<BigPoint> p = scaled({a, b, c, d});
    Big difference;
    for (std::size_t k = 0; k < 3; ++k) {
        const Big u = p[0][k] - p[1][k], v = p[2][k] - p[3][k];
        difference += u * u - v * v;
    }
    return difference.sign();
}

// |a - b|^2 against |2 q - a - b|^2, four times the squared distance from the middle.
inline int side_of_diametral_sphere(const Point& a, const Point& b, const Point& q) {
    const std::vector<BigPoint> p = scaled({a, b, q});
    Big difference;
    for (std::size_t k = 0; k < 3; ++k) {
        const Big u = p[0][k] - p[1][k], v = 2 * p[2][k] - p[0][k] - p[1][k];
        difference += u * u - v * v;
    }
    return difference.sign();
}

// The cross products of the edge with c - a and with q - a.
inline int side_of_edge(const Point& a, const Point& b, const Point& c, const Point& q) {
    const std::vector<BigPoint> p = scaled({a, b, c, q});
    Big product;
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t l = (k + 1) % 3, m = (k + 2) % 3;
        const auto cross = [&](const BigPoint& x) -> Big {
            return (p[1][l] - p[0][l]) * (x[m] - p[0][m]) - (p[1][m] - p[0][m]) * (x[l] - p[0][l]);
        };
        product += cross(p[2]) * cross(p[3]);
    }
    return product.sign();
}

// Number of random cases.
inline int cases(int count) {
    return is_small() ? 1 + count / 50 : count;
}

}  // namespace reference
