// SPDX-License-Identifier: MIT
// The tetrahedra along segments beside the pieces of the segments in every tetrahedron, in rational
// numbers, and the stages of the predicates of segments.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "../support/points.hpp"
#include "../support/small.h"
#include "exact_cells.hpp"
#include "mgdt/mgdt.hpp"
#include "predicates/segment.hpp"

namespace mgdt {
namespace {

using mgdt_tests::lattice;

using exact_cells::cross;
using exact_cells::dot;
using exact_cells::Rational;
using exact_cells::V;
using exact_cells::operator-;

V exact(const double* p) {
    return {Rational(p[0]), Rational(p[1]), Rational(p[2])};
}
Rational orientation_of(const V& a, const V& b, const V& c, const V& d) {
    return dot(cross(b - a, c - a), d - a);
}

// The part of the segment ab in a closed tetrahedron.
struct Piece {
    Rational begin = 0, end = 1;
    bool is_empty = false;
    bool has_length() const { return !is_empty && begin < end; }
};
Piece piece(const V& a, const V& b, const V (&p)[4]) {
    Piece r;
    for (unsigned i = 0; i < 4; ++i) {
        V on_a[4], on_b[4];
        std::copy_n(p, 4, on_a);
        std::copy_n(p, 4, on_b);
        on_a[i] = a;
        on_b[i] = b;
        // Not negative on the inner side of the face.
        const Rational at_a = orientation_of(on_a[0], on_a[1], on_a[2], on_a[3]),
                       at_b = orientation_of(on_b[0], on_b[1], on_b[2], on_b[3]);
        if (at_a < 0 && at_b < 0) r.is_empty = true;
        if ((at_a < 0) == (at_b < 0)) continue;
        const Rational t = at_a / (at_a - at_b);
        if (at_a < 0)
            r.begin = std::max(r.begin, t);
        else
            r.end = std::min(r.end, t);
    }
    if (r.begin > r.end) r.is_empty = true;
    return r;
}

// Whether t is a nearest double of x.
bool is_nearest(double t, const Rational& x) {
    const double below = std::nextafter(t, -1), above = std::nextafter(t, 2);
    return (Rational(below) + Rational(t)) / 2 <= x && x <= (Rational(above) + Rational(t)) / 2;
}

class Walks {
  public:
    explicit Walks(const std::vector<double>& xyz) : xyz_(xyz) {
        triangulation_.insert(xyz);
        triangulation_.set_canonical_output(true);
        tetrahedra_ = triangulation_.tetrahedra();
    }
    // Checks a segment, and returns the number of its tetrahedra.
    std::size_t check(const Point& from, const Point& to) const {
        SCOPED_TRACE(text(from) + " to " + text(to));
        const auto way = triangulation_.traverse_segment(from, to);
        const std::size_t n = way.tetrahedra.size();
        const V a = exact(from.data()), b = exact(to.data());
        Rational begin = 2, end = -1, shared = 0;
        std::size_t with_length = 0;
        for (std::size_t i = 0; i < tetrahedra_.size(); ++i) {
            if (is_apart(i, from, to)) continue;
            const Piece inside = piece_of(i, a, b);
            if (!inside.has_length()) continue;
            ++with_length;
            begin = std::min(begin, inside.begin);
            end = std::max(end, inside.end);
            shared += inside.end - inside.begin;
        }
        if (with_length == 0) {
            EXPECT_EQ(n, 0u);
            return n;
        }
        EXPECT_GT(n, 0u);
        if (n == 0) return n;
        EXPECT_EQ(way.parameters.size(), n + 1);
        Rational reached = begin;
        for (std::size_t i = 0; i < n; ++i) {
            const Piece inside = piece_of(static_cast<std::size_t>(way.tetrahedra[i]), a, b);
            EXPECT_TRUE(inside.has_length()) << i;
            EXPECT_EQ(inside.begin, reached) << i;
            EXPECT_TRUE(is_nearest(way.parameters[i], inside.begin)) << way.parameters[i];
            EXPECT_TRUE(is_nearest(way.parameters[i + 1], inside.end)) << way.parameters[i + 1];
            reached = inside.end;
        }
        EXPECT_EQ(reached, end);
        // Where the segment runs in no facet, there is no choice.
        if (shared == end - begin) {
            EXPECT_EQ(n, with_length);
        }
        return n;
    }
    const Triangulation& triangulation() const { return triangulation_; }
    Point point(std::size_t i) const { return {xyz_[3 * i], xyz_[3 * i + 1], xyz_[3 * i + 2]}; }
    std::size_t size() const { return xyz_.size() / 3; }

  private:
    static std::string text(const Point& p) {
        char out[100];
        std::snprintf(out, sizeof out, "(%.17g %.17g %.17g)", p[0], p[1], p[2]);
        return out;
    }
    // Whether the bounding boxes of a tetrahedron and of the segment have no common point.
    bool is_apart(std::size_t t, const Point& a, const Point& b) const {
        for (unsigned k = 0; k < 3; ++k) {
            double least = std::numeric_limits<double>::infinity(), most = -least;
            for (const std::int64_t v : tetrahedra_[t]) {
                const double x = xyz_[3 * static_cast<std::size_t>(v) + k];
                least = std::min(least, x);
                most = std::max(most, x);
            }
            if (most < std::min(a[k], b[k]) || least > std::max(a[k], b[k])) return true;
        }
        return false;
    }
    Piece piece_of(std::size_t t, const V& a, const V& b) const {
        V p[4];
        for (unsigned i = 0; i < 4; ++i)
            p[i] = exact(&xyz_[3 * static_cast<std::size_t>(tetrahedra_[t][i])]);
        return piece(a, b, p);
    }

    const std::vector<double>& xyz_;
    Triangulation triangulation_;
    std::vector<std::array<std::int64_t, 4>> tetrahedra_;
};

std::vector<double> uniform(std::size_t n, std::mt19937& random) {
    std::uniform_real_distribution<double> in(0, 1);
    std::vector<double> xyz(3 * n);
    for (double& x : xyz) x = in(random);
    return xyz;
}

TEST(SegmentWalk, MeetsTheTetrahedraThatContainItsPieces) {
    std::mt19937 random(1);
    const std::vector<double> xyz = uniform(40, random);
    const Walks walks(xyz);
    std::uniform_real_distribution<double> around(-0.5, 1.5);
    const auto place = [&] { return Point{around(random), around(random), around(random)}; };
    std::size_t met = 0;
    for (int i = 0; i < std::max(fewer(40), 8); ++i) met += walks.check(place(), place()) > 0;
    EXPECT_GT(met, 2u);
    // Through vertices, along edges and in facets.
    for (std::size_t i = 0; i < static_cast<std::size_t>(fewer(30)); ++i) {
        walks.check(walks.point(i), walks.point(i + 1));
        walks.check(place(), walks.point(i));
        walks.check(walks.point(i), place());
    }
    for (const auto& [i, j] : walks.triangulation().edges())
        if (i < fewer(12)) {
            const Point p = walks.point(static_cast<std::size_t>(i)),
                        q = walks.point(static_cast<std::size_t>(j));
            EXPECT_EQ(walks.check(p, q), 1u);
            EXPECT_EQ(walks.check(q, p), 1u);
        }
}

// Every tie: the ends are vertices, midpoints of edges or places outside, on lines of the lattice.
TEST(SegmentWalk, BreaksTiesInALattice) {
    std::mt19937 random(2);
    const std::vector<double> xyz = lattice(4);
    const Walks walks(xyz);
    std::uniform_int_distribution<int> half(-2, 8);
    const auto place = [&] {
        return Point{0.5 * half(random), 0.5 * half(random), 0.5 * half(random)};
    };
    for (int i = 0; i < fewer(300); ++i) {
        Point a = place(), b = place();
        if (i % 3 == 1) b[0] = a[0];
        if (i % 3 == 2) b = {a[0], a[1], b[2]};
        if (a == b) continue;
        walks.check(a, b);
    }
    // The edges of the cube and the diagonals of its faces and of the cube.
    const double most = 3;
    for (int i = 0; i < 8; i += is_smallest() ? 3 : 1)
        for (int j = 0; j < 8; ++j) {
            if (i == j) continue;
            const Point a = {most * (i & 1), most * (i >> 1 & 1), most * (i >> 2)},
                        b = {most * (j & 1), most * (j >> 1 & 1), most * (j >> 2)};
            EXPECT_GE(walks.check(a, b), 3u);
            Point before, beyond;
            for (unsigned k = 0; k < 3; ++k) {
                before[k] = 2 * a[k] - b[k];
                beyond[k] = 2 * b[k] - a[k];
            }
            EXPECT_GE(walks.check(before, beyond), 3u);
        }
}

// Points on a sphere: the hull has all of them, and walks over it are long.
TEST(SegmentWalk, EntersRoundHulls) {
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    std::vector<double> xyz;
    for (int i = 0; i < 80; ++i) {
        const double p[3] = {normal(random), normal(random), normal(random)};
        const double r = std::hypot(p[0], p[1], p[2]);
        for (const double x : p) xyz.push_back(x / r);
    }
    const Walks walks(xyz);
    for (int i = 0; i < fewer(40); ++i) {
        const Point a = {2 * normal(random), 2 * normal(random), 2 * normal(random)};
        walks.check(a, {-a[0], -a[1], -a[2]});
        walks.check(a, {normal(random), normal(random), normal(random)});
        const double far = 1e10;
        walks.check({far * a[0], far * a[1], far * a[2]}, {0, 0.01, 0});
        walks.check({far * a[0], far * a[1], far * a[2]}, {-far * a[0], -far * a[1], -far * a[2]});
    }
}

TEST(SegmentWalk, TakesAnyDoubles) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> in(0, 1);
    for (const double scale : {1e-300, 0x1p-1060, 1e300, 1e150}) {
        for (const double flatness : {1.0, scale < 1e-310 ? 0.1 : 1e-6}) {
            std::vector<double> xyz;
            for (int i = 0; i < 25; ++i) {
                xyz.push_back(scale * in(random));
                xyz.push_back(scale * in(random));
                xyz.push_back(scale * flatness * in(random));
            }
            const Walks walks(xyz);
            std::size_t met = 0;
            for (int i = 0; i < fewer(12); ++i) {
                const auto place = [&] {
                    return Point{scale * in(random), scale * in(random),
                                 flatness * scale * in(random)};
                };
                met += walks.check(place(), place()) > 0;
                walks.check(walks.point(static_cast<std::size_t>(i)), walks.point(20));
                walks.check({-1e308, in(random), 0}, place());
            }
            if (!is_small()) {
                EXPECT_GT(met, 3u);
            }
        }
    }
    // Magnitudes of all sizes in one set.
    std::vector<double> xyz;
    std::uniform_int_distribution<int> exponent(-1074, 1020);
    for (int i = 0; i < 45; ++i)
        xyz.push_back(std::ldexp(in(random)-0.5, i % 3 == 0 ? exponent(random) : 0));
    const Walks walks(xyz);
    for (std::size_t i = 0; i + 1 < walks.size(); i += is_smallest() ? 4 : 1)
        walks.check(walks.point(i), walks.point(i + 1));
}

// The same result for another order of insertion and another history, ties included.
TEST(SegmentWalk, DependsOnThePointsAlone) {
    const std::vector<double> xyz = lattice(9);
    Triangulation one, other;
    one.set_canonical_output(true);
    one.insert(xyz);
    other.set_canonical_output(true);
    other.set_order_scheme(Order::random);
    std::vector<double> more = xyz;
    for (int i = 0; i < 200; ++i) {
        more.push_back(0.03 * i);
        more.push_back(0.01 * i * (i % 7));
        more.push_back(0.07 * (i % 100));
    }
    other.insert(more);
    std::vector<std::int64_t> last(200);
    for (std::size_t i = 0; i < last.size(); ++i)
        last[i] = static_cast<std::int64_t>(xyz.size() / 3 + i);
    other.remove(last);
    std::mt19937 random(5);
    std::uniform_int_distribution<int> on(-1, 9);
    for (int i = 0; i < fewer(400); ++i) {
        const Point a = {double(on(random)), double(on(random)), double(on(random))},
                    b = {double(on(random)), double(on(random)), double(on(random))};
        const auto way = one.traverse_segment(a, b), as_well = other.traverse_segment(a, b);
        EXPECT_EQ(way.parameters, as_well.parameters);
        if (a != b) {
            EXPECT_EQ(way.tetrahedra, as_well.tetrahedra);
        }
    }
}

TEST(SegmentWalk, OfOnePointNamesATetrahedron) {
    const std::vector<double> xyz = lattice(3);
    Triangulation t;
    EXPECT_TRUE(t.traverse_segment({0, 0, 0}, {1, 1, 1}).tetrahedra.empty());
    t.insert(xyz);
    const auto way = t.traverse_segment<std::int32_t>({0.5, 0.25, 0.125}, {0.5, 0.25, 0.125});
    ASSERT_EQ(way.tetrahedra.size(), 1u);
    EXPECT_EQ(way.tetrahedra[0], t.locate({0.5, 0.25, 0.125}));
    EXPECT_EQ(way.parameters, (std::vector<double>{0, 1}));
    EXPECT_TRUE(t.traverse_segment({5, 5, 5}, {5, 5, 5}).tetrahedra.empty());
}

// Thin triangles, whose planes are hardly known.
TEST(SegmentWalk, BoundsOfParametersAreNeeded) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> in(0.5, 1);
    int wrong = 0, known = 0;
    for (int i = 0; i < 20000; ++i) {
        double p[5][3];
        for (auto& point : p)
            for (double& x : point) x = in(random);
        const double along = 2 * in(random), thinness = std::ldexp(1, -30 - i % 23);
        for (int k = 0; k < 3; ++k)
            p[4][k] = p[2][k] + along * (p[3][k] - p[2][k]) + thinness * (in(random)-0.75);
        const double* const triangle[3] = {p[2], p[3], p[4]};
        double t = 0;
        const double nearest = crossing_parameter(p[0], p[1], triangle);
        if (exact::crossing_parameter_twofold(p[0], p[1], triangle, t)) {
            ++known;
            EXPECT_EQ(t, nearest);
        }
        const double too_small = 0.0005;
        if (exact::crossing_parameter_twofold(p[0], p[1], triangle, t, too_small))
            wrong += t != nearest;
    }
    EXPECT_GT(known, 5000);
    EXPECT_GT(wrong, 0);
}

TEST(SegmentWalk, StagesAgree) {
    std::mt19937 random(6);
    std::uniform_int_distribution<int> digit(-4, 4);
    std::uniform_real_distribution<double> in(-1, 1);
    int ties = 0, known = 0;
    for (int i = 0; i < fewer(3000); ++i) {
        double p[5][3];
        for (auto& point : p)
            for (double& x : point) x = i % 2 ? digit(random) : in(random);
        const V a = exact(p[0]), b = exact(p[1]), d = exact(p[2]);
        const Rational change = dot(cross(b - a, d - a), exact(p[3]) - exact(p[4]));
        const int sign = change > 0 ? 1 : change < 0 ? -1 : 0;
        ties += sign == 0;
        EXPECT_EQ(change_of_orientation(p[0], p[1], p[2], p[3], p[4]), sign);
        EXPECT_EQ(exact::change_of_orientation_integer(p[0], p[1], p[2], p[3], p[4]), sign);
        EXPECT_EQ(exact::change_of_orientation_integer(p[0], p[1], p[2], p[3], p[4], 1000), sign);
        const int bounded = exact::change_of_orientation_bounded(p[0], p[1], p[2], p[3], p[4]);
        EXPECT_TRUE(bounded == sign || bounded == 2);
        known += bounded != 2;

        const V normal = cross(exact(p[3]) - exact(p[2]), exact(p[4]) - exact(p[2]));
        const Rational distance = dot(normal, exact(p[2]) - a), whole = dot(normal, b - a);
        if (distance == 0 || whole == 0) continue;
        const double* const triangle[3] = {p[2], p[3], p[4]};
        const double t = exact::crossing_parameter_integer(p[0], p[1], triangle);
        const Rational x = distance / whole;
        const double step = std::nextafter(std::fabs(t), 1e308) - std::fabs(t);
        EXPECT_LE(abs(Rational(t) - x), Rational(step) / 2);
        EXPECT_EQ(exact::crossing_parameter_integer(p[0], p[1], triangle, 1000), t);
        EXPECT_EQ(crossing_parameter(p[0], p[1], triangle), t);
        double rounded;
        if (exact::crossing_parameter_twofold(p[0], p[1], triangle, rounded)) {
            EXPECT_EQ(rounded, t);
        }
        if (exact::crossing_parameter_bounded(p[0], p[1], triangle, rounded)) {
            EXPECT_EQ(rounded, t);
        }
    }
    EXPECT_GT(ties, 0);
    EXPECT_GT(known, fewer(1500));
}

}  // namespace
}  // namespace mgdt
