// SPDX-License-Identifier: MIT
// Pairs of points, segments and triangles beside the vertices of the polytope of their common
// points, in integers.
#include "boundary/simplex_pair.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <map>
#include <numeric>
#include <random>
#include <tuple>
#include <vector>

namespace mgdt {
namespace {

using Grid = std::array<int, 3>;
using Row = std::array<long long, 7>;

// The corners of one simplex, on a grid of integers.
struct Corners {
    std::vector<Grid> at;
    bool has(const Grid& x) const {
        for (const Grid& of : at)
            if (of == x) return true;
        return false;
    }
};

bool are_collinear(const Grid& a, const Grid& b, const Grid& c) {
    for (unsigned k = 0; k < 3; ++k) {
        const unsigned l = (k + 1) % 3;
        if ((b[k] - a[k]) * (c[l] - a[l]) != (b[l] - a[l]) * (c[k] - a[k])) return false;
    }
    return true;
}

void divide_by_common_factor(Row& row) {
    long long g = 0;
    for (const long long x : row) g = std::gcd(g, std::llabs(x));
    if (g > 1)
        for (long long& x : row) x /= g;
}

// Solves the equations for the weights of the chosen columns. Returns whether there is one solution
// and no weight is negative; `rows` then has the weights on the diagonal, each with its divisor.
bool solve(std::vector<Row>& rows, const std::vector<unsigned>& chosen) {
    for (unsigned c = 0; c < chosen.size(); ++c) {
        unsigned pivot = c;
        while (pivot < rows.size() && rows[pivot][chosen[c]] == 0) ++pivot;
        if (pivot >= rows.size()) return false;
        std::swap(rows[c], rows[pivot]);
        for (unsigned r = 0; r < rows.size(); ++r) {
            if (r == c || rows[r][chosen[c]] == 0) continue;
            const long long p = rows[c][chosen[c]], q = rows[r][chosen[c]];
            for (unsigned k = 0; k < 7; ++k) rows[r][k] = p * rows[r][k] - q * rows[c][k];
            divide_by_common_factor(rows[r]);
        }
    }
    for (unsigned r = 0; r < rows.size(); ++r) {
        if (r >= chosen.size() && rows[r][6] != 0) return false;
        if (r < chosen.size() && rows[r][6] * rows[r][chosen[r]] < 0) return false;
    }
    return true;
}

// Whether a common point of the two simplices needs a corner that they do not have in common. The
// common points, as weights of all corners, are a polytope; a vertex of it has as few weights as
// possible, so all choices of corners find it.
bool meet_elsewhere(const Corners& a, const Corners& b) {
    const unsigned m = static_cast<unsigned>(a.at.size()), n = static_cast<unsigned>(b.at.size());
    for (unsigned choice = 1; choice < 1u << (m + n); ++choice) {
        std::vector<unsigned> chosen;
        for (unsigned c = 0; c < m + n; ++c)
            if ((choice >> c & 1) != 0) chosen.push_back(c);
        std::vector<Row> rows(5, Row{});
        for (const unsigned c : chosen) {
            for (unsigned k = 0; k < 3; ++k) rows[k][c] = c < m ? a.at[c][k] : -b.at[c - m][k];
            rows[c < m ? 3 : 4][c] = 1;
        }
        rows[3][6] = rows[4][6] = 1;
        if (!solve(rows, chosen)) continue;
        for (unsigned r = 0; r < chosen.size(); ++r)
            if (chosen[r] < m && rows[r][6] != 0 && !b.has(a.at[chosen[r]])) return true;
    }
    return false;
}

class Points {
  public:
    explicit Points(double scale) : scale_(scale) {}
    Simplex simplex(const Corners& corners) {
        Simplex s = {static_cast<int>(corners.at.size()), {}, {}};
        for (unsigned i = 0; i < corners.at.size(); ++i) {
            const auto [place, is_new] =
                numbers_.try_emplace(corners.at[i], static_cast<std::uint32_t>(numbers_.size()),
                                     std::array<double, 3>{});
            auto& [number, x] = place->second;
            if (is_new)
                for (unsigned k = 0; k < 3; ++k) x[k] = corners.at[i][k] * scale_;
            s.x[i] = x.data();
            s.number[i] = number;
        }
        return s;
    }

  private:
    double scale_;
    std::map<Grid, std::pair<std::uint32_t, std::array<double, 3>>> numbers_;
};

class SimplexPairs : public ::testing::TestWithParam<std::tuple<int, bool, double>> {};

TEST_P(SimplexPairs, AreThoseOfIntegers) {
    const auto [width, is_flat, scale] = GetParam();
    std::mt19937 random(static_cast<unsigned>(7 * width + (is_flat ? 1 : 0)));
    // Some corners are those of another simplex.
    const auto corners = [&, width = width, is_flat = is_flat](const Corners& other) {
        Corners c;
        const std::size_t size = 1 + random() % 3;
        while (c.at.size() < size) {
            Grid x;
            for (int& of : x) of = static_cast<int>(random() % static_cast<unsigned>(width));
            if (is_flat) x[2] = x[0] + 2 * x[1];
            if (!other.at.empty() && random() % 3 == 0) x = other.at[random() % other.at.size()];
            if (!c.has(x)) c.at.push_back(x);
            if (c.at.size() == 3 && are_collinear(c.at[0], c.at[1], c.at[2])) c.at.pop_back();
        }
        return c;
    };
    Points points(scale);
    // For each kind of pair, how many meet elsewhere and how many do not.
    std::map<std::array<std::size_t, 3>, std::array<int, 2>> kinds;
    for (int i = 0; i < 20000; ++i) {
        const Corners a = corners({}), b = corners(a);
        const bool expected = !meet_elsewhere(a, b);
        ASSERT_EQ(meet_in_common_face(points.simplex(a), points.simplex(b)), expected)
            << "pair " << i;
        ASSERT_EQ(meet_in_common_face(points.simplex(b), points.simplex(a)), expected)
            << "pair " << i;
        std::size_t common = 0;
        for (const Grid& x : a.at) common += b.has(x) ? 1 : 0;
        ++kinds[{std::min(a.at.size(), b.at.size()), std::max(a.at.size(), b.at.size()), common}]
               [expected ? 1 : 0];
    }
    for (const auto& [kind, counts] : kinds) {
        const auto [least, most, common] = kind;
        EXPECT_GT(counts[1], 0) << least << ' ' << most << ' ' << common;
        // Equal corners and faces always pass, and so do two points.
        if (common < least && most > 1) {
            EXPECT_GT(counts[0], 0) << least << ' ' << most << ' ' << common;
        }
    }
    EXPECT_EQ(kinds.size(), 16u);
}

INSTANTIATE_TEST_SUITE_P(Grids, SimplexPairs,
                         ::testing::Combine(::testing::Values(3, 5), ::testing::Bool(),
                                            ::testing::Values(1.0, 0x1p-1070, 0x1p1000)));

}  // namespace
}  // namespace mgdt
