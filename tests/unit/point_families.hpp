// SPDX-License-Identifier: MIT
// Sets of five points that are hard for predicates, one generator a kind of hardness.
#pragma once

#include <array>
#include <cfloat>
#include <cmath>
#include <cstdint>
#include <limits>
#include <ostream>
#include <random>
#include <string>
#include <vector>

#include "exact_reference.hpp"

namespace families {

using reference::Point;
using Five = std::array<Point, 5>;

class Random {
  public:
    explicit Random(std::uint64_t seed) : engine_(seed) {}
    double uniform(double low = 0, double high = 1) {
        return low + (high - low) * (static_cast<double>(engine_() >> 11) * 0x1p-53);
    }
    // low <= result <= high
    int integer(int low, int high) {
        return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
    }
    Point in_cube(double low = 0, double high = 1) {
        return {uniform(low, high), uniform(low, high), uniform(low, high)};
    }
    Point direction() {
        for (;;) {
            const Point p = in_cube(-1, 1);
            const double n = std::hypot(p[0], p[1], p[2]);
            if (n > 0.1 && n < 1) return {p[0] / n, p[1] / n, p[2] / n};
        }
    }
    // Full mantissa, any sign.
    double with_exponent(int low, int high) {
        const double mantissa = uniform(1, 2);  // in statements: the order of draws is fixed
        const int exponent = integer(low, high);
        return std::ldexp(integer(0, 1) ? mantissa : -mantissa, exponent);
    }

  private:
    std::mt19937_64 engine_;
};

inline Point nudged(Random& r, Point p) {
    for (double& v : p) {
        for (int k = r.integer(-2, 2); k != 0; k += k < 0 ? 1 : -1) {
            v = std::nextafter(v, k < 0 ? -DBL_MAX : DBL_MAX);
        }
    }
    return p;
}

struct Family {
    std::string name;
    Five (*make)(Random&);
};

inline std::ostream& operator<<(std::ostream& out, const Family& f) {
    return out << f.name;
}

template <class F>
Five each(const F& make) {
    Five five;
    for (Point& p : five) p = make();
    return five;
}

inline const std::vector<Family>& all() {
    static const std::vector<Family> list = {
        {"uniform", [](Random& r) { return each([&] { return r.in_cube(); }); }},
        {"rounded onto a sphere",
         [](Random& r) {
             const Point c = r.in_cube();
             const double radius = r.uniform(0.1, 10);
             return each([&] {
                 const Point d = r.direction();
                 return nudged(r,
                               {c[0] + radius * d[0], c[1] + radius * d[1], c[2] + radius * d[2]});
             });
         }},
        {"rounded onto a plane",
         [](Random& r) {
             const Point a = r.in_cube(), u = r.direction(), v = r.direction();
             return each([&] {
                 const double s = r.uniform(-1, 1), t = r.uniform(-1, 1);
                 return nudged(r, {a[0] + s * u[0] + t * v[0], a[1] + s * u[1] + t * v[1],
                                   a[2] + s * u[2] + t * v[2]});
             });
         }},
        {"rounded onto a line",
         [](Random& r) {
             const Point a = r.in_cube(), u = r.direction();
             return each([&] {
                 const double s = r.uniform(-1, 1);
                 return nudged(r, {a[0] + s * u[0], a[1] + s * u[1], a[2] + s * u[2]});
             });
         }},
        {"lattice 3",
         [](Random& r) {
             return each([&]() -> Point {
                 return {double(r.integer(0, 2)), double(r.integer(0, 2)), double(r.integer(0, 2))};
             });
         }},
        {"lattice 2^24",
         [](Random& r) {
             const int n = 1 << r.integer(1, 24);
             return each([&]() -> Point {
                 return {double(r.integer(-n, n)), double(r.integer(-n, n)),
                         double(r.integer(-n, n))};
             });
         }},
        {"integers on a sphere",
         [](Random& r) {
             // Permutations and signs of (x, y, z) keep the length.
             const Point p = {double(r.integer(0, 1000)), double(r.integer(0, 1000)),
                              double(r.integer(0, 1000))};
             const double scale = std::ldexp(1, r.integer(-200, 200));
             return each([&]() -> Point {
                 Point q = p;
                 std::swap(q[0], q[static_cast<std::size_t>(r.integer(0, 2))]);
                 std::swap(q[1], q[static_cast<std::size_t>(r.integer(1, 2))]);
                 for (double& v : q) v *= r.integer(0, 1) ? scale : -scale;
                 return q;
             });
         }},
        {"rounded to 1/1024, far off",
         [](Random& r) {
             const double offset = r.integer(0, 1) ? 0 : 1e6;
             return each([&]() -> Point {
                 return {offset + r.integer(0, 40) / 1024.0, -offset + r.integer(0, 40) / 1024.0,
                         r.integer(0, 40) / 1024.0};
             });
         }},
        {"lattice at an extreme scale",
         [](Random& r) {
             const int e = r.integer(0, 1) ? r.integer(-1074, -1000) : r.integer(900, 1010);
             return each([&]() -> Point {
                 return {std::ldexp(r.integer(-4, 4), e), std::ldexp(r.integer(-4, 4), e),
                         std::ldexp(r.integer(-4, 4), e)};
             });
         }},
        {"sphere at an extreme scale",
         [](Random& r) {
             const int e = r.integer(-1060, 1020);
             return each([&] {
                 const Point d = r.direction();
                 return nudged(r, {std::ldexp(d[0], e), std::ldexp(d[1], e), std::ldexp(d[2], e)});
             });
         }},
        {"moderate exponents",
         [](Random& r) {
             const int n = r.integer(1, 150);
             return each([&]() -> Point {
                 return {r.with_exponent(-n, n), r.with_exponent(-n, n), r.with_exponent(-n, n)};
             });
         }},
        {"wide exponents",
         [](Random& r) {
             const int n = r.integer(150, 1000);
             return each([&]() -> Point {
                 return {r.with_exponent(-n, n), r.with_exponent(-n, n), r.with_exponent(-n, n)};
             });
         }},
        {"any exponent",
         [](Random& r) {
             return each([&]() -> Point {
                 return {r.with_exponent(-1074, 1023), r.with_exponent(-1074, 1023),
                         r.with_exponent(-1074, 1023)};
             });
         }},
        {"subnormal",
         [](Random& r) {
             return each([&]() -> Point {
                 return {r.with_exponent(-1074, -1020), r.with_exponent(-1074, -1020),
                         r.with_exponent(-1074, -1020)};
             });
         }},
        {"limits",
         [](Random& r) {
             static const double values[] = {0,
                                             -0.0,
                                             1,
                                             DBL_MAX,
                                             DBL_MAX / 2,
                                             DBL_MIN,
                                             std::numeric_limits<double>::denorm_min(),
                                             0x1p970,
                                             0x1p1023,
                                             0x1.fffffffffffffp969,
                                             DBL_EPSILON,
                                             1e300,
                                             1e-300};
             return each([&]() -> Point {
                 Point p;
                 for (double& v : p) v = values[r.integer(0, 12)] * (r.integer(0, 1) ? 1 : -1);
                 return p;
             });
         }},
        {"anisotropic",
         [](Random& r) {
             return each([&]() -> Point {
                 return {r.uniform(-1e6, 1e6), r.uniform(-1, 1), r.uniform(-1e-6, 1e-6)};
             });
         }},
        {"axes of other sizes",
         [](Random& r) {
             const int x = r.integer(-1000, 1000), y = r.integer(-1000, 1000),
                       z = r.integer(-1000, 1000);
             return each([&]() -> Point {
                 return {std::ldexp(r.uniform(-1, 1), x), std::ldexp(r.uniform(-1, 1), y),
                         std::ldexp(r.uniform(-1, 1), z)};
             });
         }},
        {"lattice with axes of other sizes",
         [](Random& r) {
             const double x = r.with_exponent(-1000, 900), y = r.with_exponent(-1000, 900),
                          z = r.with_exponent(-1000, 900);
             return each([&]() -> Point {
                 return {r.integer(0, 3) * x, r.integer(0, 3) * y, r.integer(0, 3) * z};
             });
         }},
        // Heights of which some are far below: "no data".
        {"terrain with a floor",
         [](Random& r) {
             const double floor = r.integer(0, 1) ? -DBL_MAX : r.with_exponent(100, 1000);
             return each([&]() -> Point {
                 return {r.uniform(), r.uniform(), r.integer(0, 1) ? r.uniform() : floor};
             });
         }},
        {"lattice terrain with a floor",
         [](Random& r) {
             const double floor = r.integer(0, 1) ? -DBL_MAX : r.with_exponent(100, 1000);
             return each([&]() -> Point {
                 return {double(r.integer(0, 3)), double(r.integer(0, 3)),
                         r.integer(0, 1) ? double(r.integer(0, 3)) : floor};
             });
         }},
        {"clusters of bits",
         [](Random& r) {
             const int e[3] = {r.integer(-1000, 1000), r.integer(-1000, 1000),
                               r.integer(-1000, 1000)};
             return each([&]() -> Point {
                 Point p;
                 for (double& v : p)
                     v = std::ldexp(r.integer(-1000, 1000), e[std::size_t(r.integer(0, 2))]);
                 return p;
             });
         }},
        {"repeated points",
         [](Random& r) {
             const Point a = r.in_cube(), b = r.in_cube(), c = r.in_cube();
             return each([&] {
                 const int k = r.integer(0, 2);
                 return k == 0 ? a : k == 1 ? b : c;
             });
         }},
    };
    return list;
}

}  // namespace families
