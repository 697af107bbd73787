// SPDX-License-Identifier: MIT
// The predicates and each of their stages against integers without limit, on five points that are
// nearly, or exactly, on one line, plane or sphere.
#include <algorithm>

#include "../property/oracle.hpp"
#include "../support/reproduction.h"
#include "../unit/exact_reference.hpp"
#include "points.hpp"
#include "predicates/barycentric.hpp"
#include "predicates/predicates.hpp"
#include "predicates/stages.hpp"

namespace {

using fuzz::Input;
using fuzz::Point;
namespace exact = mgdt::exact;

// Points 3 and 4 are often what completes a parallelogram, a line, a cube's diagonal: ties.
Point completed(Input& in, const std::vector<Point>& p) {
    static constexpr int weights[8][4] = {{-1, 1, 1, 0},  {1, -1, 1, 0}, {1, 1, -1, 0},
                                          {2, -1, 0, 0},  {0, 1, 1, -1}, {-1, 1, 1, 0},
                                          {3, -1, -1, 0}, {-2, 1, 1, 1}};
    const unsigned which = in.byte() & 7;
    Point q{};
    for (std::size_t i = 0; i < std::min<std::size_t>(p.size(), 4); ++i)
        for (std::size_t k = 0; k < 3; ++k) q[k] += weights[which][i] * p[i][k];
    return q;
}

std::vector<Point> five_points(Input& in) {
    fuzz::PointSource source;
    source.choose_sphere(in.byte());
    std::vector<Point> p;
    // One kind for all, or one each.
    constexpr unsigned kinds = fuzz::PointSource::kinds;
    const unsigned common = in.below(2 * kinds);
    for (int i = 0; i < 5; ++i) {
        const unsigned kind = common < kinds ? common : in.below(kinds + 2);
        p.push_back(kind < kinds ? source.draw(in, kind, p) : completed(in, p));
    }
    // All times one power of two, and then each coordinate some units in the last place away.
    const int scale = in.byte() % 3 == 0 ? static_cast<int>(in.value<std::int16_t>() % 2100) : 0;
    const bool shift = in.byte() % 3 == 0;
    for (Point& q : p) {
        for (double& x : q) {
            x = std::ldexp(x, scale);
            if (!shift) continue;
            const unsigned b = in.byte();
            if ((b & 3) == 0) x = fuzz::moved(x, static_cast<int>(b >> 4) - 8);
        }
    }
    return p;
}

std::string text(const std::vector<Point>& points) {
    std::string out;
    for (const Point& p : points) {
        char line[128];
        std::snprintf(line, sizeof line, "\n%a %a %a", p[0], p[1], p[2]);
        out += line;
    }
    return out;
}

// The weights at the last of five points, the others positively oriented: 0 and negative where the
// place is on and beyond the plane of a facet, and those that give it again within.
void check_weights(const std::vector<Point>& p, const double* t) {
    const double *a = t, *b = t + 3, *c = t + 6, *d = t + 9, *q = t + 12;
    double w[4], native[4], least[4];
    mgdt::barycentric_weights({a, b, c, d}, q, w);
    exact::barycentric_integer({a, b, c, d}, q, least);
    FUZZ_REQUIRE(std::equal(w, w + 4, least), text(p));
    FUZZ_REQUIRE(
        !exact::barycentric_native({a, b, c, d}, q, native) || std::equal(w, w + 4, native),
        text(p));
    const int side[4] = {mgdt::orientation(q, b, c, d), mgdt::orientation(a, q, c, d),
                         mgdt::orientation(a, b, q, d), mgdt::orientation(a, b, c, q)};
    for (int i = 0; i < 4; ++i)
        FUZZ_REQUIRE(side[i] > 0 ? w[i] >= 0 : (side[i] < 0 ? w[i] <= 0 : w[i] == 0), text(p));
    const double* vertices[4] = {a, b, c, d};
    FUZZ_REQUIRE(*std::min_element(side, side + 4) < 0 || reproduces(vertices, q, w), text(p));
}

void check(const std::vector<Point>& p) {
    const double *a = p[0].data(), *b = p[1].data(), *c = p[2].data(), *d = p[3].data(),
                 *q = p[4].data();
    const int solid = reference::orientation(p[0], p[1], p[2], p[3]);
    const int sphere = reference::side_of_sphere(p[0], p[1], p[2], p[3], p[4]);
    const bool line = reference::collinear(p[0], p[1], p[2]);
    const int nearer = reference::compare_distance(p[0], p[1], p[2]);
    const auto right = [](int s, int expected) { return s == expected || s == exact::undecided; };

    FUZZ_REQUIRE(mgdt::orientation(a, b, c, d) == solid, text(p));
    FUZZ_REQUIRE(mgdt::side_of_sphere(a, b, c, d, q) == sphere, text(p));
    FUZZ_REQUIRE(mgdt::collinear(a, b, c) == line, text(p));
    FUZZ_REQUIRE(mgdt::compare_distance(a, b, c) == nearer, text(p));
    FUZZ_REQUIRE(right(exact::orientation_filter(a, b, c, d), solid), text(p));
    FUZZ_REQUIRE(right(exact::orientation_lattice(a, b, c, d), solid), text(p));
    FUZZ_REQUIRE(right(exact::orientation_native(a, b, c, d), solid), text(p));
    FUZZ_REQUIRE(right(exact::orientation_scaled(a, b, c, d), solid), text(p));
    FUZZ_REQUIRE(right(exact::orientation_ranged(a, b, c, d), solid), text(p));
    FUZZ_REQUIRE(right(exact::orientation_sparse(a, b, c, d, exact::Terms::any, 0), solid),
                 text(p));
    FUZZ_REQUIRE(exact::orientation_integer(a, b, c, d) == solid, text(p));
    FUZZ_REQUIRE(right(exact::sphere_filter(a, b, c, d, q), sphere), text(p));
    FUZZ_REQUIRE(right(exact::sphere_lattice(a, b, c, d, q), sphere), text(p));
    FUZZ_REQUIRE(right(exact::sphere_native(a, b, c, d, q), sphere), text(p));
    FUZZ_REQUIRE(right(exact::sphere_scaled(a, b, c, d, q), sphere), text(p));
    FUZZ_REQUIRE(right(exact::sphere_ranged(a, b, c, d, q), sphere), text(p));
    FUZZ_REQUIRE(right(exact::sphere_sparse(a, b, c, d, q, exact::Terms::any, nullptr, 0), sphere),
                 text(p));
    FUZZ_REQUIRE(exact::sphere_integer(a, b, c, d, q) == sphere, text(p));
    FUZZ_REQUIRE(right(exact::collinear_filter(a, b, c), line ? exact::undecided : 1), text(p));
    FUZZ_REQUIRE(right(exact::collinear_ranged(a, b, c), line ? 0 : 1), text(p));
    FUZZ_REQUIRE(exact::collinear_integer(a, b, c) == line, text(p));
    FUZZ_REQUIRE(right(exact::distance_filter(a, b, c), nearer), text(p));
    FUZZ_REQUIRE(right(exact::distance_ranged(a, b, c), nearer), text(p));
    FUZZ_REQUIRE(exact::distance_integer(a, b, c) == nearer, text(p));

    const auto less = [](const Point& u, const Point& v) { return u < v ? -1 : (v < u ? 1 : 0); };
    FUZZ_REQUIRE(mgdt::compare_lexicographic(a, b) == less(p[0], p[1]), text(p));

    // The perturbation is defined for positively oriented tetrahedra.
    if (solid == 0) return;
    std::vector<double> xyz;
    for (const int i : {0, 1, solid > 0 ? 2 : 3, solid > 0 ? 3 : 2, 4}) {
        const Point& v = p[static_cast<std::size_t>(i)];
        xyz.insert(xyz.end(), v.begin(), v.end());
    }
    const auto big = oracle::exact_points(xyz);
    const bool is_vertex = std::find(p.begin(), p.begin() + 4, p[4]) != p.begin() + 4;
    const int expected = is_vertex ? 0
                                   : oracle::side_of_sphere<oracle::BigInteger>(
                                         {big[0], big[1], big[2], big[3]}, big[4]);
    const double* t = xyz.data();
    FUZZ_REQUIRE(mgdt::side_of_sphere_perturbed(t, t + 3, t + 6, t + 9, t + 12) == expected,
                 text(p));
    FUZZ_REQUIRE(right(exact::perturbed_doubles(t, t + 3, t + 6, t + 9, t + 12), expected),
                 text(p));
    FUZZ_REQUIRE(right(exact::perturbed_native(t, t + 3, t + 6, t + 9, t + 12), expected), text(p));
    FUZZ_REQUIRE(
        right(exact::perturbed_sparse(t, t + 3, t + 6, t + 9, t + 12, exact::Terms::any), expected),
        text(p));
    FUZZ_REQUIRE(exact::perturbed_by_parts(t, t + 3, t + 6, t + 9, t + 12) == expected, text(p));
    check_weights(p, t);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Input in(data, size);
    while (!in.empty()) {
        const std::vector<Point> p = five_points(in);
        const bool finite = std::all_of(p.begin(), p.end(), [](const Point& q) {
            return std::isfinite(q[0]) && std::isfinite(q[1]) && std::isfinite(q[2]);
        });
        if (finite) check(p);
    }
    return 0;
}
