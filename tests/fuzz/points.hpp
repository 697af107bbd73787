// SPDX-License-Identifier: MIT
// Points drawn from few bytes, so that nearly every input has ties: repeats, collinear, coplanar
// and cospherical points, and coordinates of all sizes.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include "input.hpp"

namespace fuzz {

using Point = std::array<double, 3>;

// The integer points at a distance of sqrt(square) from the origin.
inline std::vector<Point> integer_sphere(int square) {
    std::vector<Point> points;
    for (int x = -11; x <= 11; ++x)
        for (int y = -11; y <= 11; ++y)
            for (int z = -11; z <= 11; ++z)
                if (x * x + y * y + z * z == square)
                    points.push_back(
                        {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
    return points;
}

// x moved by so many units in the last place. Infinity is not passed.
inline double moved(double x, int ulps) {
    const double to = ulps < 0 ? -std::numeric_limits<double>::infinity()
                               : std::numeric_limits<double>::infinity();
    for (int i = ulps < 0 ? -ulps : ulps; i > 0; --i) x = std::nextafter(x, to);
    return x;
}

class PointSource {
  public:
    enum Kind : unsigned {
        tiny,       // coordinates of 2 bits
        lattice,    // of 4 bits
        plane,      // in one of four planes
        sphere,     // integer points on a sphere
        repeat,     // one of those before
        shifted,    // one of those before, a few units in the last place away
        between,    // the middle of two of those before
        tenths,     // a lattice that rounding distorts
        far_off,    // a lattice far from the origin
        exponents,  // few bits times any power of two
        subnormal,  // few bits times the least double
        bits,       // any doubles, infinities and NaN among them
        kinds
    };
    // The kinds before it have coordinates that are integers of at most 16 in magnitude.
    static constexpr unsigned first_after_small = shifted;

    Point draw(Input& in, unsigned kind, const std::vector<Point>& before) const {
        switch (kind) {
            case tiny: {
                const unsigned b = in.byte();
                return {of(b & 3), of(b >> 2 & 3), of(b >> 4 & 3)};
            }
            case lattice: {
                const unsigned b = in.byte();
                return {of(b & 15), of(b >> 4), of(in.byte() & 15)};
            }
            case plane: {
                static constexpr int across[4][2][3] = {{{1, 0, 0}, {0, 1, 0}},
                                                        {{1, 0, -1}, {0, 1, -1}},
                                                        {{1, 1, 0}, {0, 0, 1}},
                                                        {{2, -1, 0}, {0, 1, 1}}};
                const unsigned b = in.byte(), which = in.byte() & 3;
                const int u = static_cast<int>(b & 7) - 3, v = static_cast<int>(b >> 3 & 7) - 3;
                Point p;
                for (std::size_t k = 0; k < 3; ++k)
                    p[k] = u * across[which][0][k] + v * across[which][1][k] + 1;
                return p;
            }
            case sphere: {
                static const std::vector<Point> table[4] = {
                    integer_sphere(9), integer_sphere(41), integer_sphere(81), integer_sphere(125)};
                const unsigned b = in.byte();
                const std::vector<Point>& points = table[radius_ & 3];
                return points[b % points.size()];
            }
            case repeat:
                return earlier(in, before);
            case shifted: {
                Point p = earlier(in, before);
                const unsigned b = in.byte();
                double& x = p[(b & 15) % 3];
                const int ulps = static_cast<int>(b >> 4) - 8;
                // Next to zero are subnormals, which are another kind's.
                x = x == 0 ? 0x1p-52 * ulps : moved(x, ulps);
                return p;
            }
            case between: {
                const Point a = earlier(in, before), b = earlier(in, before);
                Point p;
                for (std::size_t k = 0; k < 3; ++k) p[k] = a[k] / 2 + b[k] / 2;
                return p;
            }
            case tenths: {
                const unsigned b = in.byte();
                return {0.1 * (b & 3), 0.1 * (b >> 2 & 3), 0.1 * (b >> 4 & 3)};
            }
            case far_off: {
                const unsigned b = in.byte();
                return {1e15 + 0.125 * (b & 3), 0.125 * (b >> 2 & 3) - 1e15, 0.125 * (b >> 4 & 3)};
            }
            case exponents:
                return {power(in), power(in), power(in)};
            case subnormal: {
                const unsigned b = in.byte();
                return {0x1p-1074 * (of(b & 3) - 1), 0x1p-1074 * (of(b >> 2 & 3) - 1),
                        0x1p-1074 * (of(b >> 4 & 3) - 1)};
            }
            default:
                return {in.value<double>(), in.value<double>(), in.value<double>()};
        }
    }

    void choose_sphere(unsigned radius) { radius_ = radius; }

  private:
    static double of(unsigned n) { return static_cast<double>(n); }

    static Point earlier(Input& in, const std::vector<Point>& before) {
        const unsigned b = in.byte();
        return before.empty() ? Point{} : before[b % before.size()];
    }

    static double power(Input& in) {
        static constexpr int exponents[16] = {-1074, -1060, -1022, -540, -300, -150, -40, -3,
                                              0,     3,     40,    150,  300,  511,  540, 1020};
        const unsigned b = in.byte();
        return std::ldexp(static_cast<int>(b >> 4) - 8, exponents[b & 15]);
    }

    unsigned radius_ = 0;
};

}  // namespace fuzz
