// SPDX-License-Identifier: MIT
#include "cli/point_sets/hostile.hpp"

#include <cmath>
#include <limits>
#include <utility>

namespace mgdt::cli::hostile {
namespace {

Points uniform_with_one(Random& random, std::size_t n, double value) {
    Points points = repeat(n, [&] { return random.uniform_point(); });
    if (n > 0) points[n / 2][1] = value;
    return points;
}

}  // namespace

Points lattice(Random&, std::size_t n) {
    std::size_t side = 0;
    while (side * side * side < n) ++side;
    std::size_t i = 0;
    return repeat(n, [&] {
        const std::size_t layer = i / (side * side), row = i / side % side, column = i % side;
        const Point p{static_cast<double>(layer), static_cast<double>(row),
                      static_cast<double>(column)};
        ++i;
        return p;
    });
}

Points integer_sphere(Random& random, std::size_t n) {
    // 1105 = 5 * 13 * 17 has three prime factors that are 1 modulo 4, hence many points.
    constexpr int radius = 1105;
    Points points;
    for (int x = -radius; x <= radius; ++x) {
        for (int y = -radius; y <= radius; ++y) {
            const int rest = radius * radius - x * x - y * y;
            if (rest < 0) continue;
            const int z = static_cast<int>(std::lround(std::sqrt(rest)));
            if (z * z != rest) continue;
            points.push_back({static_cast<double>(x), static_cast<double>(y), 0.0 - z});
            if (z > 0) {
                points.push_back(
                    {static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)});
            }
        }
    }
    for (std::size_t i = points.size(); i > 1; --i) {
        std::swap(points[i - 1], points[static_cast<std::size_t>(random.below(i))]);
    }
    if (n < points.size()) points.resize(n);
    return points;
}

Points moment_curve(Random& random, std::size_t n) {
    return repeat(n, [&] {
        const double t = random.uniform();
        return Point{t, t * t, t * t * t};
    });
}

Points two_lines(Random& random, std::size_t n) {
    bool first = false;
    return repeat(n, [&] {
        first = !first;
        const double t = random.uniform();
        return first ? Point{t, 0.5, 0.25} : Point{0.5, t, 0.75};
    });
}

Points rounded(Random& random, std::size_t n) {
    return repeat(n, [&] {
        Point p = random.uniform_point();
        for (double& c : p) c = std::floor(c * 1024 + 0.5) / 1024;
        return p;
    });
}

Points lattice_repeats(Random& random, std::size_t n) {
    return repeat(n, [&] {
        Point p;
        for (double& c : p) c = static_cast<double>(random.below(20));
        return p;
    });
}

// Integers a and b below 2^22 and the power of two keep every coordinate and the plane's equation
// free of rounding.
Points coplanar(Random& random, std::size_t n) {
    return repeat(n, [&] {
        const double a = static_cast<double>(random.bits() >> 42);
        const double b = static_cast<double>(random.bits() >> 42);
        return Point{3 * a * 0x1p-24, 3 * b * 0x1p-24, (a + 2 * b) * 0x1p-24};
    });
}

Points collinear(Random& random, std::size_t n) {
    return repeat(n, [&] {
        const double t = static_cast<double>(random.bits() >> 13) * 0x1p-53;  // 3 t is exact
        return Point{t, 2 * t, 3 * t};
    });
}

Points one_point(Random& random, std::size_t n) {
    const Point p = random.uniform_point();
    return Points(n, p);
}

Points anisotropic(Random& random, std::size_t n) {
    return repeat(n, [&] {
        const Point p = random.uniform_point();
        return Point{1e6 * p[0], p[1], 1e-6 * p[2]};
    });
}

Points nan(Random& random, std::size_t n) {
    return uniform_with_one(random, n, std::numeric_limits<double>::quiet_NaN());
}

Points infinity(Random& random, std::size_t n) {
    return uniform_with_one(random, n, std::numeric_limits<double>::infinity());
}

}  // namespace mgdt::cli::hostile
