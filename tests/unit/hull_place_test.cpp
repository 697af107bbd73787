// SPDX-License-Identifier: MIT
// The nearest place of the hull, against all facets one by one, from wherever the walk begins.
#include "interpolation/hull_place.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

#include "../small.h"
#include "core/triangulation.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

using Points = std::vector<double>;
using P = std::array<double, 3>;

double dot(const P& a, const P& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
P operator-(const P& a, const P& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
P at(const double* x) {
    return {x[0], x[1], x[2]};
}

double distance_from_segment(const P& q, const P& a, const P& b) {
    const P e = b - a, w = q - a;
    const double s = std::min(std::max(dot(e, w) / dot(e, e), 0.0), 1.0);
    const P d = {w[0] - s * e[0], w[1] - s * e[1], w[2] - s * e[2]};
    return std::sqrt(dot(d, d));
}
double distance_from_triangle(const P& q, const P& a, const P& b, const P& c) {
    const P e = b - a, f = c - a, w = q - a;
    const double ee = dot(e, e), ef = dot(e, f), ff = dot(f, f), ew = dot(e, w), fw = dot(f, w);
    const double whole = ee * ff - ef * ef, s = (ff * ew - ef * fw) / whole,
                 t = (ee * fw - ef * ew) / whole;
    if (s >= 0 && t >= 0 && s + t <= 1) {
        const P d = {w[0] - s * e[0] - t * f[0], w[1] - s * e[1] - t * f[1],
                     w[2] - s * e[2] - t * f[2]};
        return std::sqrt(dot(d, d));
    }
    return std::min({distance_from_segment(q, a, b), distance_from_segment(q, b, c),
                     distance_from_segment(q, c, a)});
}

void try_places(const Points& xyz, double size, std::mt19937& random, int places) {
    Triangulation t(nullptr, nullptr, nullptr);
    const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
    t.insert(xyz.size() / 3, axis, 3);
    const Mesh& mesh = t.mesh();
    ASSERT_EQ(mesh.scale, 0);
    int outside = 0;
    for (int k = 0; k < places; ++k) {
        double q[3];
        const double far = k % 3 == 0 ? 1.2 : k % 3 == 1 ? 4 : 100;
        // On a grid, so that q is often over edges and corners exactly.
        for (double& x : q) x = size * far * (static_cast<double>(random() % 129) / 64 - 1);
        double least = std::numeric_limits<double>::infinity();
        std::vector<TetId> beyond;
        for (TetId id = 0; id < mesh.tetrahedra.size(); ++id) {
            const Tetrahedron& g = mesh.tetrahedra[id];
            if (g.is_dead() || !g.is_ghost()) continue;
            const unsigned char* const facet = outer_face[g.infinite_slot()];
            const double *const a = mesh.point(g.v[facet[0]]), *const b = mesh.point(g.v[facet[1]]),
                                *const c = mesh.point(g.v[facet[2]]);
            least = std::min(least, distance_from_triangle(at(q), at(a), at(b), at(c)));
            if (orientation(q, a, b, c) < 0) beyond.push_back(id);
        }
        if (beyond.empty()) continue;
        ++outside;
        const HullPlace first = nearest_hull_place(mesh, q, beyond[0]);
        const P d = at(q) - at(first.x);
        EXPECT_NEAR(std::sqrt(dot(d, d)), least, 1e-13 * (size + least));
        double sum = 0;
        for (unsigned i = 0; i < 3; ++i) {
            EXPECT_GE(first.weight[i], 0);
            sum += first.weight[i];
        }
        EXPECT_NEAR(sum, 1, 1e-15);
        for (const TetId from : beyond) {
            const HullPlace again = nearest_hull_place(mesh, q, from);
            EXPECT_EQ(std::memcmp(&first, &again, sizeof first), 0);
        }
    }
    EXPECT_GT(outside, places / 3);
}

TEST(HullPlace, IsTheNearestOfAllFacets) {
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    const int places = is_small() ? 30 : 300;
    Points ball, lattice, needle, turned;
    for (int i = 0; i < 200; ++i) {
        P p;
        for (double& x : p) x = normal(random);
        for (const double x : p) {
            ball.push_back(x / std::sqrt(dot(p, p)));
            needle.push_back(x * (needle.size() % 3 == 0 ? 1 : 1e-3));
        }
        // A cube turned about z, whose faces are flat but for rounding.
        const double a = i % 6 - 2.5, b = i / 6 % 6 - 2.5, c = i / 36 - 2.5;
        lattice.insert(lattice.end(), {a, b, c});
        turned.insert(turned.end(), {.6 * a - .8 * b, .8 * a + .6 * b, c / 3});
    }
    try_places(ball, 1, random, places);
    try_places(lattice, 2.5, random, places);
    try_places(needle, 2, random, places);
    try_places(turned, 2.5, random, places);
    try_places({0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1}, 1, random, places);
}

}  // namespace
}  // namespace mgdt
