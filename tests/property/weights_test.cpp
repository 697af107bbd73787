// SPDX-License-Identifier: MIT
// The weights of mgdt_locate_points give each place again to some units in the last place of the
// tetrahedron's coordinates, whatever the set: above all where tetrahedra are as flat as rounding
// makes them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "../support/reproduction.h"
#include "handle.hpp"
#include "rows.hpp"

namespace {

using property::Handle;

constexpr double pi = 3.14159265358979323846;

// Locates the places and checks the weights of those that are in the hull; their number.
std::size_t expect_reproduced(const mgdt_triangulation* t, const std::vector<double>& xyz,
                              const std::vector<double>& places) {
    const std::size_t n = places.size() / 3;
    std::vector<std::int64_t> found(n);
    std::vector<double> weights(4 * n, -1);
    EXPECT_EQ(mgdt_locate_points(t, static_cast<std::int64_t>(n), places.data(), found.data(),
                                 weights.data()),
              MGDT_OK)
        << property::error_of(t);
    const std::vector<std::int64_t> tetrahedra = property::tetrahedra(t);
    std::size_t inside = 0, wrong = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const double *q = &places[3 * i], *w = &weights[4 * i];
        if (found[i] < 0) continue;
        ++inside;
        const double* p[4];
        for (std::size_t k = 0; k < 4; ++k)
            p[k] = &xyz[3 * static_cast<std::size_t>(
                                tetrahedra[4 * static_cast<std::size_t>(found[i]) + k])];
        bool right = reproduces(p, q, w) != 0;
        // At a vertex its weight is 1 and the others are 0.
        for (std::size_t k = 0; k < 4; ++k) {
            if (p[k][0] != q[0] || p[k][1] != q[1] || p[k][2] != q[2]) continue;
            for (std::size_t j = 0; j < 4; ++j) right = right && w[j] == (j == k ? 1 : 0);
        }
        if (!right && ++wrong == 1)
            ADD_FAILURE() << q[0] << ' ' << q[1] << ' ' << q[2] << " has weights " << w[0] << ' '
                          << w[1] << ' ' << w[2] << ' ' << w[3];
    }
    EXPECT_EQ(wrong, 0u) << "of " << inside << " in the hull";
    return inside;
}

// The points, the middles of edges, and places within facets and tetrahedra, as they are rounded.
std::vector<double> places_in(const mgdt_triangulation* t, const std::vector<double>& xyz,
                              std::size_t most) {
    const std::vector<std::int64_t> tetrahedra = property::tetrahedra(t);
    std::mt19937_64 random(7);
    std::vector<double> places(xyz.begin(),
                               xyz.begin() + std::ptrdiff_t(std::min(xyz.size(), 3 * most)));
    static const double shares[][4] = {
        {0.5, 0.5, 0, 0}, {0.3, 0.3, 0.4, 0}, {0.25, 0.25, 0.25, 0.25}, {0.97, 0.01, 0.01, 0.01}};
    for (std::size_t i = 0; i < most && !tetrahedra.empty(); ++i) {
        const std::size_t e = random() % (tetrahedra.size() / 4), turn = random() % 4;
        for (const auto& share : shares)
            for (std::size_t k = 0; k < 3; ++k) {
                double x = 0;
                for (std::size_t j = 0; j < 4; ++j)
                    x += share[(j + turn) % 4] *
                         xyz[3 * static_cast<std::size_t>(tetrahedra[4 * e + j]) + k];
                places.push_back(x);
            }
    }
    return places;
}

Handle triangulated(const std::vector<double>& xyz) {
    Handle t = property::create();
    EXPECT_EQ(property::insert(t.get(), xyz, {0}), MGDT_OK) << property::error_of(t.get());
    return t;
}

class Weights : public testing::TestWithParam<property::Row> {};

TEST_P(Weights, GiveThePlaceAgain) {
    const std::vector<double> xyz = property::points(GetParam(), is_small() ? 150 : 1500);
    const Handle t = triangulated(xyz);
    const std::size_t inside =
        expect_reproduced(t.get(), xyz, places_in(t.get(), xyz, is_small() ? 100 : 2000));
    EXPECT_TRUE(inside > 0 || mgdt_tetrahedron_count(t.get()) == 0);
}

INSTANTIATE_TEST_SUITE_P(Rows, Weights, testing::ValuesIn(property::rows),
                         [](const auto& info) { return std::string(info.param.name); });

// Points of a lattice with `side` points a side, turned about two axes: rounding makes slivers of
// the squares' four corners.
std::vector<double> turned_lattice(int side) {
    std::vector<double> xyz;
    const double a = 0.3, b = 0.5;
    for (int i = 0; i < side * side * side; ++i) {
        const double x = double(i / side / side) / (side - 1),
                     y = double(i / side % side) / (side - 1), z = double(i % side) / (side - 1);
        const double u = x * std::cos(a) - y * std::sin(a), v = x * std::sin(a) + y * std::cos(a);
        xyz.insert(xyz.end(),
                   {u, v * std::cos(b) - z * std::sin(b), v * std::sin(b) + z * std::cos(b)});
    }
    return xyz;
}

TEST(Weights, InATurnedLattice) {
    const std::vector<double> xyz = turned_lattice(is_small() ? 4 : 11);
    const Handle t = triangulated(xyz);
    const int side = is_small() ? 10 : 41;
    // Rounding may put the lattice's outermost layer outside.
    EXPECT_GE(expect_reproduced(t.get(), xyz, turned_lattice(side)),
              static_cast<std::size_t>((side - 2) * (side - 2) * (side - 2)));
    expect_reproduced(t.get(), xyz, places_in(t.get(), xyz, is_small() ? 100 : 5000));
}

// Layers of latitudes and longitudes, as of an atmosphere.
TEST(Weights, InAShell) {
    std::vector<double> xyz;
    const int rows = is_small() ? 7 : 19, columns = is_small() ? 8 : 36;
    for (const double r : {1.0, 1.01, 1.02})
        for (int i = 0; i < rows; ++i)
            for (int j = 0; j < columns; ++j) {
                const double latitude = pi * (i / (rows - 1.) - 0.5),
                             longitude = 2 * pi * j / columns;
                xyz.insert(xyz.end(),
                           {r * std::cos(latitude) * std::cos(longitude),
                            r * std::cos(latitude) * std::sin(longitude), r * std::sin(latitude)});
            }
    const Handle t = triangulated(xyz);
    const std::vector<std::int64_t> edges = property::edges(t.get());
    std::vector<double> middles;
    for (std::size_t i = 0; i < edges.size(); i += 2)
        for (std::size_t k = 0; k < 3; ++k)
            middles.push_back(
                (xyz[3 * std::size_t(edges[i]) + k] + xyz[3 * std::size_t(edges[i + 1]) + k]) / 2);
    EXPECT_GT(expect_reproduced(t.get(), xyz, middles), middles.size() / 3 / 2);
    expect_reproduced(t.get(), xyz, places_in(t.get(), xyz, is_small() ? 100 : 5000));
}

// Coordinates of every exponent in one set, of the ends of the range, and beside the largest.
TEST(Weights, OfExtremes) {
    std::mt19937_64 random(9);
    const auto below = [&](int n) { return static_cast<int>(random() % static_cast<unsigned>(n)); };
    const auto sign = [&] { return random() & 1 ? 1. : -1.; };
    static const double ends[] = {0,         1,         1e300, 1e308, 0x1.fffffffffffffp1023,
                                  0x1p-1074, 0x1p-1022, 1e-300};
    for (int kind = 0; kind < 4; ++kind) {
        std::vector<double> xyz;
        for (int i = 0; i < 3 * (is_small() ? 20 : 80); ++i) {
            const double mantissa = 1 + double(random() >> 11) * 0x1p-53;
            xyz.push_back(sign() * (kind == 0   ? std::ldexp(mantissa, below(2000) - 1000)
                                    : kind == 1 ? std::ldexp(mantissa, below(50) - 1070)
                                    : kind == 2 ? ends[below(8)]
                                                : std::ldexp(mantissa, below(120) - 60)));
        }
        SCOPED_TRACE(kind);
        const Handle t = triangulated(xyz);
        // Places between the vertices, and vertices of another set.
        std::vector<double> places = places_in(t.get(), xyz, is_small() ? 20 : 300);
        for (std::size_t i = 0; i + 3 < xyz.size(); ++i) places.push_back(xyz[i + 1] * 0.125);
        places.resize(places.size() / 3 * 3);
        EXPECT_GT(expect_reproduced(t.get(), xyz, places), xyz.size() / 3);
    }
}

}  // namespace
