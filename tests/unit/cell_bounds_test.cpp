// SPDX-License-Identifier: MIT
// The measures of cells have the errors that are promised: beside rational numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "../support/points.hpp"
#include "../support/small.h"
#include "cells_and_rationals.hpp"

namespace mgdt {
namespace {

using exact_cells::Rational;
using mgdt_tests::lattice;
using mgdt_tests::Points;
using mgdt_tests::scaled;
using mgdt_tests::uniform;

struct Set {
    const char* name;
    Points xyz;
};

Points sphere(std::size_t n) {
    Points xyz = uniform(n);
    for (std::size_t i = 0; i < n; ++i) {
        double* const p = &xyz[3 * i];
        for (int k = 0; k < 3; ++k) p[k] -= 0.5;
        const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        for (int k = 0; k < 3; ++k) p[k] /= r;
    }
    return xyz;
}

// Two clusters of the given size, far from each other.
Points clusters(std::size_t n, double size) {
    Points xyz = uniform(n);
    for (std::size_t i = 0; i < 3 * n; ++i) xyz[i] = xyz[i] * size + (i % 6 < 3 ? 0.25 : 0.75);
    return xyz;
}

// A box around the points and a plane that cuts one of its corners off.
Points planes_around(const Points& xyz) {
    double low[3], high[3], size = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        low[k] = high[k] = xyz[k];
        for (std::size_t i = k; i < xyz.size(); i += 3) {
            low[k] = std::min(low[k], xyz[i]);
            high[k] = std::max(high[k], xyz[i]);
        }
        size = std::max(size, high[k] - low[k]);
    }
    Points planes;
    double corner = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double margin = 0.125 * (high[k] - low[k]);
        for (const double sign : {1.0, -1.0}) {
            Points plane = {0, 0, 0, sign > 0 ? high[k] + margin : margin - low[k]};
            plane[k] = sign;
            planes.insert(planes.end(), plane.begin(), plane.end());
        }
        corner += high[k];
    }
    planes.insert(planes.end(), {1, 1, 1, corner});
    return planes;
}

class CellBounds : public testing::TestWithParam<Set> {
  protected:
    void compare(const Points& planes) {
        // The exact cells take nearly all of the time: under Valgrind and the like, of one set.
        if (is_small() && std::string(GetParam().name) != "uniform") return;
        double size = 0;
        for (const double x : GetParam().xyz) size = std::max(size, std::fabs(x));
        const std::size_t bounded = compare_cells_with_rationals(
            GetParam().xyz, planes, is_small() ? 10 : 2, Rational(size) * Rational(0x1p300));
        if (!planes.empty()) {
            EXPECT_GT(bounded, 0u);
        }
    }
};

TEST_P(CellBounds, HoldWithoutPlanes) {
    compare({});
}

TEST_P(CellBounds, HoldWithinPlanes) {
    compare(planes_around(GetParam().xyz));
}

// The bound of a corner's error is kept, and not by much more than it has to be.
TEST(CornerBound, IsKeptAndTight) {
    std::mt19937_64 random(9);
    const auto coordinate = [&](double spread) {
        return 1 + spread * (static_cast<double>(random() >> 11) * 0x1p-53 - 0.5);
    };
    double largest = 0;
    for (int i = 0; i < (is_small() ? 300 : 3000); ++i) {
        const double spread = std::ldexp(1, -(i % 12));
        Side side[3];
        exact_cells::HalfSpace exact[3];
        const double origin[3] = {coordinate(2), coordinate(2), coordinate(2)};
        for (int j = 0; j < 3; ++j) {
            for (std::size_t k = 0; k < 3; ++k) {
                const double x = coordinate(spread);
                side[j].normal.x[k] = x - origin[k];
                exact[j].normal[k] = Rational(x) - Rational(origin[k]);
            }
            side[j].offset = 0.5 * dot(side[j].normal, side[j].normal);
            side[j].size = length(side[j].normal);
            side[j].error = 5 * 0x1p-53 * side[j].offset;
            exact[j].offset = exact_cells::dot(exact[j].normal, exact[j].normal) / 2;
        }
        exact_cells::V x;
        Corner corner;
        if (!exact_cells::meet(exact[0], exact[1], exact[2], x) ||
            !meet(side[0], side[1], side[2], corner))
            continue;
        double square = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double d = static_cast<double>(Rational(corner.x.x[k]) - x[k]);
            square += d * d;
        }
        largest = std::max(largest, std::sqrt(square) / corner.error);
    }
    EXPECT_LE(largest, 1);
    EXPECT_GT(largest, 0.01);
}

const Set sets[] = {{"uniform", uniform(20)},
                    {"lattice", lattice(3)},
                    {"sphere", sphere(20)},
                    {"anisotropic", uniform(20, 1, 1, 1e-3, 1e-6)},
                    {"flat", uniform(20, 1, 1, 1, 1e-12)},
                    {"needle", uniform(20, 1, 1, 1e-9, 1e-9)},
                    {"clusters", clusters(20, 1e-7)},
                    {"tiny", scaled(uniform(20), 1e-90)},
                    {"huge", scaled(uniform(20), 1e90)}};
INSTANTIATE_TEST_SUITE_P(Sets, CellBounds, testing::ValuesIn(sets),
                         [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace mgdt
