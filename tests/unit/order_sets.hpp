// SPDX-License-Identifier: MIT
// Point sets for the tests of order schemes, friendly, flat, repeated and extreme, and what every
// schedule must be.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <map>
#include <new>
#include <numeric>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "mgdt/mgdt.h"
#include "order/cell_numbers.hpp"
#include "order/curve_sort.hpp"
#include "order/grid.hpp"
#include "order/hilbert_curve.hpp"
#include "order/kd_partition.hpp"
#include "order/radix.hpp"
#include "order/rounds.hpp"
#include "order/schedule.hpp"
#include "order/schemes.hpp"
#include "platform/borrowed_arena.hpp"
#include "platform/random.hpp"

namespace order_test {

using namespace mgdt;

using Coordinates = std::vector<double>;
using Order = std::vector<std::uint32_t>;

inline PointSet point_set(const Coordinates& xyz, double scale = 1) {
    PointSet points;
    points.stride = 3;
    points.size = xyz.size() / 3;
    points.scale = scale;
    for (int k = 0; k < 3; ++k) {
        points.axis[k] = xyz.empty() ? nullptr : xyz.data() + k;
        points.low[k] = points.high[k] = points.size > 0 ? points.coordinate(0, k) : 0;
        for (std::size_t i = 0; i < points.size; ++i) {
            points.low[k] = std::min(points.low[k], points.coordinate(i, k));
            points.high[k] = std::max(points.high[k], points.coordinate(i, k));
        }
    }
    return points;
}

struct Result {
    Order order, rounds, hints;
    unsigned levels = 0;

    bool operator==(const Result& other) const {
        return order == other.order && rounds == other.rounds && hints == other.hints &&
               levels == other.levels;
    }
};

// With no allocator given, scratch is lent, and gone before the schedule is read.
inline Result schedule(const PointSet& points, std::int32_t scheme,
                       const OrderParameters& parameters = {}, Allocator* allocator = nullptr,
                       unsigned members = 1) {
    Allocator own;
    std::vector<unsigned char> block(12 * points.size);
    BorrowedArena arena(block.data(), block.size(), own);
    Schedule out(allocator ? *allocator : own, allocator ? *allocator : arena.allocator());
    Team team(members);
    make_schedule(team, points, scheme, parameters, out);
    EXPECT_EQ(arena.allocator().bytes(), 0u);
    std::fill(block.begin(), block.end(), static_cast<unsigned char>(0xA5));
    Result result;
    result.order.assign(out.order.begin(), out.order.end());
    result.rounds.assign(out.rounds.begin(), out.rounds.end());
    result.hints.assign(out.hints.begin(), out.hints.end());
    result.levels = out.levels;
    return result;
}

inline Result schedule(const Coordinates& xyz, std::int32_t scheme,
                       const OrderParameters& parameters = {}) {
    return schedule(point_set(xyz), scheme, parameters);
}

inline double unit(Random& random) {
    return static_cast<double>(random.next() >> 11) * 0x1p-53;
}

inline Coordinates generate(std::size_t n,
                            const std::function<void(std::size_t, Random&, double*)>& f) {
    Random random(12345 + n);
    Coordinates xyz(3 * n);
    for (std::size_t i = 0; i < n; ++i) f(i, random, &xyz[3 * i]);
    return xyz;
}

inline Coordinates uniform(std::size_t n) {
    return generate(n, [](std::size_t, Random& r, double* p) {
        for (int k = 0; k < 3; ++k) p[k] = unit(r);
    });
}

inline Coordinates integer_lattice(std::size_t side) {
    return generate(side * side * side, [side](std::size_t i, Random&, double* p) {
        p[0] = static_cast<double>(i % side);
        p[1] = static_cast<double>(i / side % side);
        p[2] = static_cast<double>(i / side / side);
    });
}

// A long thin line with a little noise, where points crowd in few cells of any grid.
inline Coordinates noisy_line(std::size_t n) {
    return generate(n, [](std::size_t, Random& r, double* p) {
        const double t = unit(r);
        for (int k = 0; k < 3; ++k) p[k] = t + 1e-4 * (unit(r) - 0.5);
    });
}

inline std::map<std::string, Coordinates> all_sets(std::size_t n) {
    using F = std::function<void(std::size_t, Random&, double*)>;
    const double most = std::numeric_limits<double>::max();
    const double tiny = std::numeric_limits<double>::denorm_min();
    const std::map<std::string, F> makers = {
        {"one point repeated",
         [](std::size_t, Random&, double* p) { p[0] = 1, p[1] = -0.5, p[2] = 1e300; }},
        {"zeros of both signs",
         [](std::size_t i, Random&, double* p) {
             for (int k = 0; k < 3; ++k) p[k] = (i >> k) & 1 ? 0.0 : -0.0;
         }},
        {"along x", [](std::size_t, Random& r, double* p) { p[0] = unit(r), p[1] = 3, p[2] = -1; }},
        {"body diagonal", [](std::size_t, Random& r, double* p) { p[0] = p[1] = p[2] = unit(r); }},
        {"coplanar",
         [](std::size_t, Random& r, double* p) { p[0] = unit(r), p[1] = 7, p[2] = unit(r); }},
        {"largest doubles",
         [most](std::size_t, Random& r, double* p) {
             for (int k = 0; k < 3; ++k) p[k] = (2 * unit(r) - 1) * most;
         }},
        {"both largest doubles in x",
         [most](std::size_t i, Random& r, double* p) {
             p[0] = i % 2 ? most : -most, p[1] = unit(r), p[2] = 0;
         }},
        {"few subnormals",
         [tiny](std::size_t, Random& r, double* p) {
             for (int k = 0; k < 3; ++k) p[k] = tiny * static_cast<double>(r.below(3));
         }},
        {"many subnormals",
         [tiny](std::size_t, Random& r, double* p) {
             for (int k = 0; k < 3; ++k) p[k] = tiny * static_cast<double>(r.below(1u << 30));
         }},
        {"subnormals beside a constant 1e300",
         [tiny](std::size_t, Random& r, double* p) {
             p[0] = tiny * static_cast<double>(r.below(100)), p[1] = 1e300, p[2] = -1e300;
         }},
        {"1e300 and 1e-300",
         [](std::size_t i, Random& r, double* p) {
             for (int k = 0; k < 3; ++k) p[k] = (unit(r) - 0.5) * (i % 3 ? 1e-300 : 1e300);
         }},
        {"1e6 : 1 : 1e-6",
         [](std::size_t, Random& r, double* p) {
             p[0] = 1e6 * unit(r), p[1] = unit(r), p[2] = 1e-6 * unit(r);
         }},
        {"repeated lattice",
         [](std::size_t, Random& r, double* p) {
             for (int k = 0; k < 3; ++k) p[k] = r.below(5);
         }},
        {"exponential cluster",
         [](std::size_t, Random& r, double* p) {
             for (int k = 0; k < 3; ++k) {
                 p[k] = std::ldexp(unit(r), -static_cast<int>(r.below(2000)) + 900);
             }
         }},
        {"two far crowds",
         [](std::size_t i, Random& r, double* p) {
             for (int k = 0; k < 3; ++k) p[k] = static_cast<double>(i % 2) + 1e-12 * unit(r);
         }},
        {"moment curve",
         [](std::size_t, Random& r, double* p) {
             const double t = unit(r);
             p[0] = t, p[1] = t * t, p[2] = t * t * t;
         }},
    };
    std::map<std::string, Coordinates> sets;
    for (const auto& [name, maker] : makers) sets[name] = generate(n, maker);
    sets["uniform"] = uniform(n);
    sets["noisy line"] = noisy_line(n);
    return sets;
}

inline void expect_sound(const Result& result, std::size_t n) {
    ASSERT_EQ(result.order.size(), n);
    Order sorted = result.order;
    std::sort(sorted.begin(), sorted.end());
    for (std::size_t i = 0; i < n; ++i) ASSERT_EQ(sorted[i], i);

    ASSERT_FALSE(result.rounds.empty());
    EXPECT_EQ(result.rounds[0], 0u);
    for (std::size_t r = 1; r < result.rounds.size(); ++r) {
        ASSERT_LT(result.rounds[r - 1], result.rounds[r]);
        ASSERT_LT(result.rounds[r], n);
    }
    if (result.hints.empty()) return;
    ASSERT_EQ(result.hints.size(), n);
    for (std::size_t k = 0; k < n; ++k) {
        const std::uint32_t hint = result.hints[k];
        ASSERT_TRUE(hint == no_hint || hint < k) << hint << " at " << k;
    }
}

inline double path_length(const Coordinates& xyz, const Order& order) {
    double length = 0;
    for (std::size_t k = 1; k < order.size(); ++k) {
        const double* a = &xyz[3 * std::size_t{order[k - 1]}];
        const double* b = &xyz[3 * std::size_t{order[k]}];
        length += std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
    }
    return length;
}

}  // namespace order_test
