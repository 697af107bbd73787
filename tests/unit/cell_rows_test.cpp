// SPDX-License-Identifier: MIT
// Cells of a few points of every distribution, the hostile ones and extreme scales included, in
// their box and unbounded, beside cells that are cut out of space in rational numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "../property/rows.hpp"
#include "cells_and_rationals.hpp"

namespace mgdt {
namespace {

using exact_cells::Rational;
using Point = std::array<double, 3>;

// Points of a row, each once.
std::vector<double> distinct_points(const property::Row& row, std::size_t n) {
    // The first ones of a lattice are on a line, and rows with repeats have few others.
    const std::vector<double> all = property::points(row, 64);
    std::set<Point> seen;
    std::vector<double> xyz;
    const std::size_t count = all.size() / 3;
    for (std::size_t i = 0; i < count && seen.size() < n; ++i) {
        const double* const p = all.data() + 3 * (i * 37 % count);
        if (seen.insert({p[0], p[1], p[2]}).second) xyz.insert(xyz.end(), p, p + 3);
    }
    return xyz;
}

// More than the distance of any circumcentre: this is a quotient of determinants of degrees 4 and
// 3, and the lower one is at least the cube of the unit of the coordinates.
Rational farther_than_corners(const std::vector<double>& xyz) {
    Rational largest = 0, unit = 0;
    for (const double x : xyz) {
        if (x == 0) continue;
        int exponent = 0;
        std::frexp(x, &exponent);
        const Rational lowest = Rational(std::ldexp(1, std::max(exponent - 53, -1074)));
        largest = std::max(largest, Rational(std::fabs(x)));
        unit = unit == 0 ? lowest : std::min(unit, lowest);
    }
    const Rational ratio = largest / unit;
    return 1000 * ratio * ratio * ratio * largest;
}

class CellRows : public testing::TestWithParam<property::Row> {};

TEST_P(CellRows, AreThoseOfRationalNumbers) {
    const std::vector<double> xyz = distinct_points(GetParam(), is_small() ? 5 : 10);
    Triangulation t(nullptr, nullptr, nullptr);
    const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
    t.insert(xyz.size() / 3, axis, 3);
    if (t.dimension() < 3) {
        const std::string name = GetParam().name;
        EXPECT_TRUE(name == "Coplanar" || name == "Collinear" || name == "OnePoint");
        return;  // no cells
    }
    const Rational far = farther_than_corners(xyz);
    compare_cells_with_rationals(xyz, {}, 2, far);
    std::vector<double> box;
    for (std::size_t k = 0; k < 3; ++k) {
        for (const double sign : {-1.0, 1.0}) {
            double most = -HUGE_VAL;
            for (std::size_t i = k; i < xyz.size(); i += 3) most = std::max(most, sign * xyz[i]);
            double plane[4] = {0, 0, 0, most};
            plane[k] = sign;
            box.insert(box.end(), plane, plane + 4);
        }
    }
    EXPECT_EQ(compare_cells_with_rationals(xyz, box, 2, far), (xyz.size() / 3 + 1) / 2);
}

INSTANTIATE_TEST_SUITE_P(Rows, CellRows, testing::ValuesIn(property::rows),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace mgdt
