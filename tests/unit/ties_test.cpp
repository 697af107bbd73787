// SPDX-License-Identifier: MIT
// What the kernels decide in doubles when their filter has failed, in each island that runs
// here: right or left open, and not left open on a lattice or where the predicates' filter
// decides.
#include "kernel/ties.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "exact_reference.hpp"
#include "islands.hpp"
#include "point_families.hpp"

namespace {

using families::Five;
using families::Random;
using mgdt::exact::undecided;

// Positively oriented, the last point none of the first four; false if it cannot be.
bool prepare(Five& p) {
    const int o = mgdt::orientation(p[0].data(), p[1].data(), p[2].data(), p[3].data());
    if (o == 0 || std::find(p.begin(), p.begin() + 4, p[4]) != p.begin() + 4) return false;
    if (o < 0) std::swap(p[0], p[1]);
    return true;
}

int expected(const Five& p) {
    return mgdt::exact::perturbed_by_parts(p[0].data(), p[1].data(), p[2].data(), p[3].data(),
                                           p[4].data());
}

// The tetrahedron of vertices 1 to 4, the last point vertex 5.
template <class Decide>
int decide_by(Decide decide, const Five& p) {
    alignas(32) mgdt::Vertex vertices[6] = {};
    for (unsigned i = 0; i < 5; ++i) {
        std::copy(p[i].begin(), p[i].end(), vertices[i + 1].x);
        vertices[i + 1].index = 0xFFFFFFFF;  // as a double not a number
        vertices[i + 1].moved_to = 0xFFFFFFFF;
    }
    const mgdt::Tetrahedron t = {{1, 2, 3, 4}, {}};
    return decide(t, vertices, vertices[5].x);
}

class Ties : public testing::TestWithParam<islands::Island> {
  protected:
    void SetUp() override {
        if (!GetParam().runs()) GTEST_SKIP() << "not on this processor";
    }

    static int decide(const Five& p) { return decide_by(GetParam().perturbed_doubles, p); }
};

TEST_P(Ties, AreBrokenRightOrLeftOpen) {
    Random random(21);
    for (const auto& f : families::all()) {
        SCOPED_TRACE(f.name);
        int wrong = 0, asked = 0, filtered = 0, open = 0;
        for (int i = 0; i < reference::cases(4000); ++i) {
            Five p = f.make(random);
            if (!prepare(p)) continue;
            ++asked;
            const int s = decide(p);
            wrong += s != undecided && s != expected(p);
            const bool decides = mgdt::exact::sphere_filter(p[0].data(), p[1].data(), p[2].data(),
                                                            p[3].data(), p[4].data()) != undecided;
            filtered += decides;
            // The determinants may be rounded otherwise.
            open += decides && s == undecided;
        }
        EXPECT_EQ(wrong, 0);
        // The range of differences that the lattice admits is smaller than the filter's.
        if (f.name == "anisotropic" || f.name == "uniform") {
            EXPECT_GT(filtered, asked / 2);
            EXPECT_LE(open, asked / 1000);
        }
    }
}

TEST_P(Ties, OfALatticeAreAllBroken) {
    Random random(22);
    int ties = 0;
    for (const double unit : {1.0, 0x1p-30, 0x1p100}) {
        for (const double offset : {0.0, 1000.0, -123456.0}) {
            for (int i = 0; i < reference::cases(4000); ++i) {
                const int side = i % 3 == 0 ? 2 : i % 3 == 1 ? 5 : 300;
                Five p;
                for (auto& v : p)
                    for (double& x : v) x = unit * (offset + random.integer(0, side - 1));
                if (!prepare(p)) continue;
                const int s = decide(p);
                ASSERT_EQ(s, expected(p));
                ties += mgdt::side_of_sphere(p[0].data(), p[1].data(), p[2].data(), p[3].data(),
                                             p[4].data()) == 0;
            }
        }
    }
    EXPECT_GT(ties, reference::cases(100));
}

// Wide lattices: integers on spheres, of all sizes to beyond those that the vectors take.
TEST_P(Ties, OfAWideLatticeAreBrokenOrLeftOpen) {
    Random random(24);
    int open[26] = {}, ties[26] = {};
    for (int i = 0; i < reference::cases(60000); ++i) {
        const int bits = 4 + i % 22, n = 1 << bits;
        const double unit = std::ldexp(1.0, random.integer(-60, 60));
        Five p;
        const std::array<int, 3> base = {random.integer(0, n - 1), random.integer(0, n - 1),
                                         i % 5 == 0 ? n - 1 : random.integer(0, n - 1)};
        for (auto& v : p) {
            v = {double(base[0]), double(base[1]), double(base[2])};
            std::swap(v[0], v[static_cast<std::size_t>(random.integer(0, 2))]);
            std::swap(v[1], v[static_cast<std::size_t>(random.integer(1, 2))]);
            for (double& x : v) x *= random.integer(0, 1) ? unit : -unit;
        }
        // Some all but on the sphere, for the filter to leave open or not.
        if (i % 7 == 0) p[4][0] += unit;
        if (!prepare(p)) continue;
        const int s = decide(p);
        if (s != undecided) {
            ASSERT_EQ(s, expected(p)) << bits;
        }
        ++ties[bits];
        open[bits] += s == undecided;
    }
    const int most = GetParam().decided_modulo ? 19 : 8;
    for (int bits = 4; bits < most; ++bits) {
        EXPECT_GT(ties[bits], reference::cases(100)) << bits;
        EXPECT_EQ(open[bits], 0) << bits;
    }
}

// Modulo 2^64 a determinant that is not 0 has its sign, too.
TEST_P(Ties, ModuloHaveTheSignsOfSmallDeterminants) {
    if (!GetParam().decided_modulo) GTEST_SKIP() << "not in this island";
    Random random(26);
    int inside = 0, outside = 0;
    for (int i = 0; i < 2000; ++i) {
        Five p;
        for (auto& v : p)
            for (double& x : v) x = random.integer(0, 1 << (1 + i % 10));
        if (!prepare(p)) continue;
        const int side = expected(p);
        ASSERT_EQ(decide_by(GetParam().decided_modulo, p), side);
        ++(side > 0 ? inside : outside);
    }
    EXPECT_GT(inside, 50);
    EXPECT_GT(outside, 50);
}

// What the kernels ask last of all, for a finite tetrahedron too: the same as near ties.
TEST(ExactConflicts, AgreeWithTies) {
    Random random(25);
    mgdt::Allocator allocator;
    mgdt::Mesh mesh(allocator);
    mesh.clear();
    mesh.vertices.resize(6);
    int inside = 0, outside = 0;
    for (int i = 0; i < 200; ++i) {
        Five p;
        for (auto& v : p)
            for (double& x : v) x = random.integer(0, 2);
        if (!prepare(p)) continue;
        for (unsigned k = 0; k < 5; ++k)
            std::copy(p[k].begin(), p[k].end(), mesh.vertices[k + 1].x);
        const mgdt::Tetrahedron t = {{1, 2, 3, 4}, {}};
        const double* const q = mesh.vertices[5].x;
        const bool conflict = mgdt::is_conflict_exact(mesh, t, q);
        EXPECT_EQ(mgdt::is_conflict_near_tie(mesh, t, mgdt::Query(q)), conflict);
        ++(conflict ? inside : outside);
    }
    EXPECT_GT(inside, 10);
    EXPECT_GT(outside, 10);
}

// Corners of a box are on one sphere, however long their coordinates; and three values along an
// axis are no box.
TEST_P(Ties, OfABoxAreBrokenByWhateverKnowsThem) {
    Random random(23);
    int ties = 0, open = 0, others = 0;
    for (int i = 0; i < reference::cases(20000); ++i) {
        double value[3][3];
        for (auto& axis : value)
            for (double& x : axis) x = random.uniform(-1, 10);
        const bool is_box = i % 2 == 0;
        Five p;
        for (auto& v : p)
            for (std::size_t k = 0; k < 3; ++k) v[k] = value[k][random.integer(0, is_box ? 1 : 2)];
        if (!prepare(p)) continue;
        const int s = decide(p);
        if (s != undecided) {
            ASSERT_EQ(s, expected(p));
        }
        const bool is_tie = mgdt::side_of_sphere(p[0].data(), p[1].data(), p[2].data(), p[3].data(),
                                                 p[4].data()) == 0;
        EXPECT_TRUE(is_tie || !is_box);
        ties += is_box;
        open += is_box && s == undecided;
        others += !is_box && !is_tie;
    }
    EXPECT_GT(ties, reference::cases(100));
    EXPECT_GT(others, 100);
    if (GetParam().decided_modulo) {
        EXPECT_EQ(open, 0);
    }
}

INSTANTIATE_TEST_SUITE_P(Each, Ties, testing::ValuesIn(islands::all()),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
