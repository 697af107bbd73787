// SPDX-License-Identifier: MIT
// Whether a cached sphere is within its bound, against rational arithmetic: it must be refused when
// it is not, and accepted as the kernel computes it and with errors that leave room.
#include "query/sphere_bound.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <random>

#include "exact_reference.hpp"
#include "kernel/circumsphere.hpp"

namespace mgdt {
namespace {

using Rational = boost::multiprecision::cpp_rational;
using Random = std::mt19937_64;

double uniform(Random& random) {
    return static_cast<double>(random() >> 11) * 0x1p-52 - 1;
}

struct Case {
    Vertex vertices[5] = {};
    Tetrahedron t = {};
    Sphere s;

    // Some flat, some off the origin, some large or small.
    explicit Case(Random& random) {
        const double flat = std::ldexp(1.0, -static_cast<int>(random() % 44));
        const double size = std::ldexp(1.0, static_cast<int>(random() % 200) - 100);
        const double offset = random() % 2 ? 0 : 100 * uniform(random);
        for (Vertex& v : vertices)
            for (double& x : v.x) x = size * (offset + uniform(random));
        for (Vertex& v : vertices) v.x[random() % 3] = size * (offset + flat * uniform(random));
        for (VertexId i = 0; i < 4; ++i) t.v[i] = i + 1;
        if (volume() < 0) std::swap(t.v[2], t.v[3]);
        s = circumsphere(t, vertices);
    }
    Rational coordinate(int i, int k) const {
        return Rational(vertices[t.v[i]].x[k]) - Rational(vertices[t.v[0]].x[k]);
    }
    Rational minor(int i, int j, int k) const {
        const int a = (k + 1) % 3, b = (k + 2) % 3;
        return coordinate(i, a) * coordinate(j, b) - coordinate(i, b) * coordinate(j, a);
    }
    Rational volume() const {
        Rational sum;
        for (int k = 0; k < 3; ++k) sum += coordinate(1, k) * minor(2, 3, k);
        return sum;
    }
    // What the bound has to be at least.
    Rational needed() const {
        const Rational det = volume();
        Rational square[4], error, largest;
        for (int i = 1; i < 4; ++i)
            for (int k = 0; k < 3; ++k) square[i] += coordinate(i, k) * coordinate(i, k);
        for (int k = 0; k < 3; ++k) {
            const Rational exact = (square[1] * minor(2, 3, k) + square[2] * minor(3, 1, k) +
                                    square[3] * minor(1, 2, k)) /
                                   det;
            error = std::max<Rational>(error, abs(Rational(s.w[k]) - exact));
            largest = std::max<Rational>(largest, abs(Rational(s.w[k])));
        }
        return error + 6 * Rational(0x1p-53) * largest;
    }
};

TEST(SphereBound, AgainstRationalArithmetic) {
    Random random(1);
    int trusted = 0, refused = 0, accepted_off = 0;
    for (int i = 0; i < reference::cases(1500); ++i) {
        Case c(random);
        if (c.volume() == 0) continue;
        ASSERT_TRUE(sphere_is_within_bound(c.s, c.t, c.vertices));
        if (std::isinf(c.s.e)) continue;
        ++trusted;
        ASSERT_LE(c.needed(), Rational(c.s.e));
        // Off by up to twice the bound, with bounds from a quarter to four times of it.
        c.s.w[random() % 3] += 2 * c.s.e * uniform(random);
        c.s.e *= std::exp2(2 * uniform(random));
        const bool within = c.needed() <= Rational(c.s.e);
        if (sphere_is_within_bound(c.s, c.t, c.vertices)) {
            ASSERT_TRUE(within);
            ++accepted_off;
        } else {
            ++refused;
        }
    }
    EXPECT_GT(trusted, 10);
    EXPECT_GT(refused, 5);
    EXPECT_GT(accepted_off, 5);
}

// The other instruction sets round otherwise: a hair's breadth needs the second step.
TEST(SphereBound, AcceptsOtherRoundings) {
    Random random(2);
    for (int i = 0; i < reference::cases(500); ++i) {
        Case c(random);
        if (std::isinf(c.s.e) || c.volume() == 0) continue;
        for (double& w : c.s.w) w += 0.1 * c.s.e * uniform(random);
        c.s.e *= 1 + 0x1p-50 * uniform(random);
        EXPECT_EQ(sphere_is_within_bound(c.s, c.t, c.vertices),
                  c.needed() < Rational((1 - 0x1p-40) * c.s.e));
    }
}

// As they are kept, most of the bound is for rounding, and used up to the last bits.
TEST(SphereBound, OfSpheresThatAreKept) {
    Random random(3);
    int tight = 0;
    for (int i = 0; i < reference::cases(500); ++i) {
        Case c(random);
        if (std::isinf(c.s.e) || c.volume() == 0) continue;
        const double exact = c.s.e;
        c.s = rounded(c.s).in_doubles();
        EXPECT_TRUE(sphere_is_within_bound(c.s, c.t, c.vertices));
        const Rational needed = c.needed();
        EXPECT_LE(needed, Rational(c.s.e));
        // Less than what is computed is refused for that.
        if (needed < Rational(4 * exact)) continue;
        ++tight;
        c.s.e = static_cast<double>(Rational(needed * Rational(1 + 0x1p-38)));
        EXPECT_TRUE(sphere_is_within_bound(c.s, c.t, c.vertices));
        c.s.e = static_cast<double>(Rational(needed * Rational(1 + 0x1p-42)));
        EXPECT_FALSE(sphere_is_within_bound(c.s, c.t, c.vertices));
    }
    EXPECT_GT(tight, 5);
}

// (1, 1, h) is twice the centre exactly, yet so flat a determinant could not have been computed.
TEST(SphereBound, NeedsADeterminant) {
    const auto accepts = [](double h, double bound) {
        const Vertex vertices[5] = {
            {}, {{0, 0, 0}, 0, 0}, {{1, 0, 0}, 0, 0}, {{0, 1, 0}, 0, 0}, {{1, 1, h}, 0, 0}};
        const Tetrahedron t = {{1, 2, 3, 4}, {}};
        return sphere_is_within_bound({{1, 1, h}, bound}, t, vertices);
    };
    EXPECT_TRUE(accepts(0x1p-40, 0.02));
    EXPECT_FALSE(accepts(0x1p-40, 0.011));
    EXPECT_FALSE(accepts(0x1p-50, 20));
}

// A sound sphere, moved with its bound to where nothing is proved.
TEST(SphereBound, ExtremeVerticesNeedAnInfiniteBound) {
    for (const double factor : {1.0, 0x1p-160}) {
        const double f = factor;
        const Vertex vertices[5] = {
            {}, {{0, 0, 0}, 0, 0}, {{f, 0, 0}, 0, 0}, {{0, f, 0}, 0, 0}, {{0, 0, f}, 0, 0}};
        const Tetrahedron t = {{1, 2, 3, 4}, {}};
        Sphere s = {{f, f, f}, f * 0x1p-40};
        EXPECT_EQ(sphere_is_within_bound(s, t, vertices), factor == 1);
        s.e = infinity;
        EXPECT_TRUE(sphere_is_within_bound(s, t, vertices));
        EXPECT_EQ(std::isinf(circumsphere(t, vertices).e), factor != 1);
    }
}

}  // namespace
}  // namespace mgdt
