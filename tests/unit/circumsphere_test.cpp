// SPDX-License-Identifier: MIT
// The kernel's filter: a power that it decides has the sign of the exact one, and its
// coefficients are not larger than they need to be by much.
#include "kernel/circumsphere.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "../support/small.h"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

struct Sample {
    Vertex vertices[6];  // 0: infinity, 1 to 4: the tetrahedron, 5: q
};

int size_of_test(int full) {
    return is_small() ? full / 50 : full;
}

constexpr double origin[3] = {0, 0, 0}, half_way_up[3] = {0, 0, 0.5};

class Samples {
  public:
    explicit Samples(unsigned seed) : random_(seed) {}

    // A tetrahedron of any shape (slivers and needles among them, far from the origin or not)
    // and a point within rounding of its circumsphere.
    bool next(Sample& s) {
        const double offset = std::ldexp(uniform(), static_cast<int>(uniform() * 30));
        const double flatness = std::ldexp(1.0, -static_cast<int>(std::fabs(uniform()) * 25));
        for (int i = 1; i <= 5; ++i) {
            double* x = s.vertices[i].x;
            for (int k = 0; k < 3; ++k) x[k] = offset + uniform();
            x[2] = offset + flatness * uniform();
            s.vertices[i].index = static_cast<std::uint32_t>(i);
        }
        const int sign =
            orientation(s.vertices[1].x, s.vertices[2].x, s.vertices[3].x, s.vertices[4].x);
        if (sign == 0) return false;
        if (sign < 0) std::swap(s.vertices[3], s.vertices[4]);
        move_to_sphere(s);
        return true;
    }

  private:
    double uniform() { return std::uniform_real_distribution<double>(-1, 1)(random_); }

    // q slides along a line through the first vertex until it meets the sphere again.
    void move_to_sphere(Sample& s) {
        const auto relative = [&](int i) {
            std::array<long double, 3> r;
            for (std::size_t k = 0; k < 3; ++k)
                r[k] = static_cast<long double>(s.vertices[i].x[k]) -
                       static_cast<long double>(s.vertices[1].x[k]);
            return r;
        };
        const auto a = relative(2), b = relative(3), c = relative(4), v = relative(5);
        const auto dot = [](const auto& x, const auto& y) {
            return x[0] * y[0] + x[1] * y[1] + x[2] * y[2];
        };
        const auto cross = [](const auto& x, const auto& y) {
            return std::array<long double, 3>{x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2],
                                              x[0] * y[1] - x[1] * y[0]};
        };
        const auto bc = cross(b, c), ca = cross(c, a), ab = cross(a, b);
        const long double det = dot(a, bc);
        std::array<long double, 3> w;
        for (std::size_t k = 0; k < 3; ++k)
            w[k] = (dot(a, a) * bc[k] + dot(b, b) * ca[k] + dot(c, c) * ab[k]) / det;
        const long double t = dot(w, v) / dot(v, v);
        for (std::size_t k = 0; k < 3; ++k)
            s.vertices[5].x[k] =
                static_cast<double>(static_cast<long double>(s.vertices[1].x[k]) + t * v[k]);
    }

    std::mt19937_64 random_;
};

// Of vertices 1 to 4.
Sphere sphere_of(const Sample& s, const FilterBounds& bounds) {
    Sphere sphere;
    const double* base = s.vertices[1].x;
    set_sphere(relative_to(s.vertices[2].x, base), relative_to(s.vertices[3].x, base),
               relative_to(s.vertices[4].x, base), sphere, bounds);
    return sphere;
}

// How many of the powers that the filter decides have the wrong sign, and how many it decides.
struct Outcome {
    int wrong = 0, decided = 0;
};

// Spheres and normals as they are computed, or as they are kept.
constexpr auto as_computed = [](const Sphere& s) { return s; };
auto as_kept(double roundoff) {
    return [=](const Sphere& s) { return rounded(s, roundoff).in_doubles(); };
}

template <class Kept>
Outcome try_spheres(const FilterBounds& bounds, int samples, Kept kept) {
    Outcome outcome;
    Samples source(1);
    Sample s;
    for (int i = 0; i < samples; ++i) {
        if (!source.next(s)) continue;
        Query q(s.vertices[5].x);
        q.quadratic = bounds.quadratic * unit_roundoff;
        const Power p = power(kept(sphere_of(s, bounds)), s.vertices[1].x, q);
        if (!p.is_decided()) continue;
        ++outcome.decided;
        const int side = side_of_sphere(s.vertices[1].x, s.vertices[2].x, s.vertices[3].x,
                                        s.vertices[4].x, s.vertices[5].x);
        outcome.wrong += side != (p.value < 0 ? 1 : -1);
    }
    return outcome;
}

TEST(Filter, DecidesPowersCorrectly) {
    const Outcome outcome = try_spheres(proved_bounds, size_of_test(400000), as_computed);
    EXPECT_EQ(outcome.wrong, 0);
}

// On points chosen to defeat it the filter must turn wrong when its coefficients are smaller: the
// test above would otherwise not see a bound that is too small.
TEST(Filter, FailsWithSmallerCoefficients) {
    // Memcheck has no extended precision: its points are not as close to the spheres.
    const double divisor = is_small() ? 4096 : 64;
    FilterBounds all;
    all.sphere_sum /= divisor;
    all.sphere_det /= divisor;
    all.quadratic /= divisor;
    EXPECT_GT(try_spheres(all, size_of_test(400000), as_computed).wrong, 0);
    FilterBounds sphere;
    sphere.sphere_sum = sphere.sphere_det = 0.01;
    EXPECT_GT(try_spheres(sphere, size_of_test(400000), as_computed).wrong, 0);
}

TEST(Filter, DecidesTypicalPowers) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> uniform(0, 1);
    int undecided = 0;
    for (int i = 0; i < 10000; ++i) {
        Sample s;
        for (int j = 1; j <= 5; ++j)
            for (double& x : s.vertices[j].x) x = uniform(random);
        if (orientation(s.vertices[1].x, s.vertices[2].x, s.vertices[3].x, s.vertices[4].x) < 0)
            std::swap(s.vertices[3], s.vertices[4]);
        const Power p = power(sphere_of(s, proved_bounds), s.vertices[1].x, Query(s.vertices[5].x));
        undecided += !p.is_decided();
    }
    EXPECT_LE(undecided, 2);
}

// A ghost's normal, with q within rounding of the facet's plane.
template <class Kept>
Outcome try_normals(const FilterBounds& bounds, int samples, Kept kept) {
    Outcome outcome;
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int i = 0; i < samples; ++i) {
        Vertex vertices[5];
        const double offset = std::ldexp(uniform(random), static_cast<int>(uniform(random) * 20));
        for (int j = 1; j <= 4; ++j)
            for (double& x : vertices[j].x) x = offset + uniform(random);
        const long double r = uniform(random), t = uniform(random);
        for (int k = 0; k < 3; ++k) {
            const long double a = vertices[1].x[k], b = vertices[2].x[k], c = vertices[3].x[k];
            vertices[4].x[k] = static_cast<double>(a + r * (b - a) + t * (c - a));
        }
        Sphere ghost;
        set_normal(relative_to(vertices[2].x, vertices[1].x),
                   relative_to(vertices[3].x, vertices[1].x), ghost, bounds);
        const Power p = power(kept(ghost), vertices[1].x, Query(vertices[4].x));
        if (!p.is_decided()) continue;
        ++outcome.decided;
        const int side = orientation(vertices[1].x, vertices[2].x, vertices[3].x, vertices[4].x);
        outcome.wrong += side != (p.value < 0 ? 1 : -1);
    }
    return outcome;
}

TEST(Filter, DecidesNormalsCorrectly) {
    EXPECT_EQ(try_normals(proved_bounds, size_of_test(400000), as_computed).wrong, 0);
    FilterBounds small;
    small.normal /= 64;
    EXPECT_GT(try_normals(small, size_of_test(400000), as_computed).wrong, 0);
}

// Rounding is all the error there is beside what it adds to the bound, so less must be wrong soon.
TEST(Filter, DecidesWithWhatIsKept) {
    const int samples = size_of_test(400000);
    EXPECT_EQ(try_spheres(proved_bounds, samples, as_kept(kept_roundoff)).wrong, 0);
    EXPECT_EQ(try_normals(proved_bounds, samples, as_kept(kept_roundoff)).wrong, 0);
    EXPECT_GT(try_spheres(proved_bounds, samples, as_kept(kept_roundoff / 4)).wrong, 0);
    EXPECT_GT(try_normals(proved_bounds, samples, as_kept(kept_roundoff / 4)).wrong, 0);
}

// w is off by no more than the bound has for that, and w = 1 + 2^-21, half way between two upper
// halves, is off by all but 2^-17 of it.
TEST(Filter, KeepsSpheresWithinTheirBounds) {
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int i = 0; i < 10000; ++i) {
        Sphere s;
        for (double& w : s.w)
            w = std::ldexp(uniform(random), static_cast<int>(uniform(random) * 9));
        const double scale = std::ldexp(1.0, static_cast<int>(uniform(random) * 200));
        for (double& w : s.w) w *= scale;
        s.e = std::ldexp(uniform(random), -40) * scale;
        const Sphere k = rounded(s).in_doubles();
        EXPECT_EQ(k.is_ghost(), s.is_ghost());
        for (int j = 0; j < 3; ++j)
            EXPECT_LE(std::fabs(k.w[j] - s.w[j]) + (1 - 0x1p-19) * std::fabs(s.e), std::fabs(k.e));
    }
    const Sphere half_way = {{1 + 0x1p-21, 0, 0}, 0};
    const Sphere k = rounded(half_way).in_doubles();
    EXPECT_EQ(std::fabs(k.w[0] - half_way.w[0]), 0x1p-21);
    EXPECT_GE(k.e, 0x1p-21);
    EXPECT_LE(k.e, 0x1p-21 * (1 + 0x1p-17));
    // Of this bound all is cut off that can be.
    const Sphere cut = {{1 + 0x1p-21, 0, 0}, 0x1.cp-43};
    EXPECT_GE(rounded(cut).in_doubles().e, 0x1p-21 + (1 - 0x1p-19) * cut.e);
}

TEST(Filter, KeepsWhatIsNotTrusted) {
    for (const double w : {1.0, infinity, std::nan("")})
        for (const double e : {infinity, -infinity}) {
            const KeptSphere k = rounded({{w, 0, -w}, e});
            EXPECT_EQ(k.in_doubles().e, e);
            EXPECT_EQ(k.is_ghost(), e < 0);
            EXPECT_FALSE(power(k.in_doubles(), half_way_up, Query(origin)).is_decided());
        }
}

TEST(Filter, LeavesExtremesOpen) {
    const double huge = 0x1p151;
    const double far[3] = {huge, 0, 0};
    EXPECT_FALSE(in_normal_range(far));
    EXPECT_EQ(Query(far).quadratic, infinity);
    const double tiny[3] = {0, 0x1p-151, 0};
    EXPECT_FALSE(in_normal_range(tiny));
    const double normal[3] = {0, -0x1p-150, 0x1p150};
    EXPECT_TRUE(in_normal_range(normal));

    Sample s{};
    const double corner[6][3] = {{0, 0, 0}, {0, 0, 0}, {huge, 0, 0},
                                 {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};
    for (int i = 0; i < 6; ++i)
        for (int k = 0; k < 3; ++k) s.vertices[i].x[k] = corner[i][k];
    Tetrahedron t{};
    for (unsigned i = 0; i < 4; ++i) t.v[i] = i + 1;
    const Sphere sphere = circumsphere(t, s.vertices);
    EXPECT_FALSE(sphere.is_ghost());
    EXPECT_FALSE(power(sphere, s.vertices[1].x, Query(s.vertices[5].x)).is_decided());
}

// The vertex at infinity may stand in either of the last two places: turned about, the facet is the
// same one.
TEST(Circumsphere, OfAGhostHoweverItIsTurned) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int i = 0; i < 100; ++i) {
        Vertex vertices[4]{};
        for (int j = 1; j < 4; ++j)
            for (double& x : vertices[j].x) x = uniform(random);
        const Tetrahedron turns[2] = {{{1, 2, 3, infinite_vertex}, {}},
                                      {{1, 3, infinite_vertex, 2}, {}}};
        Sphere ghosts[2];
        for (int turn = 0; turn < 2; ++turn) {
            const Tetrahedron& t = turns[turn];
            ghosts[turn] = circumsphere(t, vertices);
            EXPECT_TRUE(t.is_ghost());
            EXPECT_TRUE(ghosts[turn].is_ghost());
            EXPECT_EQ(t.v[t.infinite_slot()], infinite_vertex);
            EXPECT_EQ(ghosts[turn].e, ghosts[0].e);
            for (int k = 0; k < 3; ++k) EXPECT_EQ(ghosts[turn].w[k], ghosts[0].w[k]);
        }
        // It points away from what is in front of the facet.
        const double outside[3] = {uniform(random), uniform(random), uniform(random)};
        const Power p = power(ghosts[1], vertices[1].x, Query(outside));
        const int side = orientation(vertices[1].x, vertices[2].x, vertices[3].x, outside);
        if (p.is_decided()) {
            EXPECT_EQ(p.is_conflict(), side > 0);
        }
    }
}

}  // namespace
}  // namespace mgdt
