// SPDX-License-Identifier: MIT
// Every predicate against integers without limit, on every family of points.
#include "predicates/predicates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "exact_reference.hpp"
#include "point_families.hpp"

namespace {

using families::Five;
using families::Random;

class Predicates : public testing::TestWithParam<families::Family> {
  protected:
    template <class Check>
    void on_each(int count, const Check& check) {
        Random random(20140113);
        for (int i = 0; i < reference::cases(count); ++i) {
            const Five p = GetParam().make(random);
            check(p);
            if (HasFailure()) {
                for (const auto& q : p) {
                    ADD_FAILURE() << std::hexfloat << q[0] << " " << q[1] << " " << q[2];
                }
                FAIL() << "case " << i;
            }
        }
    }
};

TEST_P(Predicates, Orientation) {
    on_each(2000, [](const Five& p) {
        EXPECT_EQ(mgdt::orientation(p[0].data(), p[1].data(), p[2].data(), p[3].data()),
                  reference::orientation(p[0], p[1], p[2], p[3]));
    });
}

TEST_P(Predicates, SideOfSphere) {
    on_each(2000, [](const Five& p) {
        EXPECT_EQ(
            mgdt::side_of_sphere(p[0].data(), p[1].data(), p[2].data(), p[3].data(), p[4].data()),
            reference::side_of_sphere(p[0], p[1], p[2], p[3], p[4]));
    });
}

TEST_P(Predicates, Collinear) {
    on_each(2000, [](const Five& p) {
        EXPECT_EQ(mgdt::collinear(p[0].data(), p[1].data(), p[2].data()),
                  reference::collinear(p[0], p[1], p[2]));
    });
}

TEST_P(Predicates, RoughTurns) {
    on_each(2000, [](const Five& p) {
        int turns[3];
        mgdt::find_rough_turns(p[0].data(), p[1].data(), p[2].data(), turns);
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (turns[axis] != 0) {
                EXPECT_EQ(turns[axis], reference::turn(p[0], p[1], p[2], axis));
            }
    });
    const double a[3] = {0, 0, 0}, b[3] = {1, 2, 4}, c[3] = {8, -1, 2};
    int turns[3];
    mgdt::find_rough_turns(a, b, c, turns);
    EXPECT_TRUE(turns[0] == 1 && turns[1] == 1 && turns[2] == -1);
}

TEST_P(Predicates, CompareDistance) {
    on_each(2000, [](const Five& p) {
        EXPECT_EQ(mgdt::compare_distance(p[0].data(), p[1].data(), p[2].data()),
                  reference::compare_distance(p[0], p[1], p[2]));
    });
}

int parity(const std::array<std::size_t, 5>& order) {
    int sign = 1;
    for (std::size_t i = 0; i < order.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) sign = order[j] > order[i] ? -sign : sign;
    }
    return sign;
}

// side_of_sphere is, up to its sign, a determinant of five rows, orientation of four.
TEST_P(Predicates, AntisymmetricUnderAllPermutations) {
    on_each(40, [](const Five& p) {
        std::array<std::size_t, 5> o = {0, 1, 2, 3, 4};
        const auto x = [&](std::size_t i) { return p[o[i]].data(); };
        const int sphere = mgdt::side_of_sphere(x(0), x(1), x(2), x(3), x(4));
        const int solid = mgdt::orientation(x(0), x(1), x(2), x(3));
        do {
            EXPECT_EQ(mgdt::side_of_sphere(x(0), x(1), x(2), x(3), x(4)), sphere * parity(o));
            if (o[4] == 4) {
                EXPECT_EQ(mgdt::orientation(x(0), x(1), x(2), x(3)), solid * parity(o));
            }
        } while (std::next_permutation(o.begin(), o.end()));
    });
}

TEST_P(Predicates, DistanceIsAntisymmetricAndCollinearitySymmetric) {
    on_each(500, [](const Five& p) {
        const double *a = p[0].data(), *b = p[1].data(), *c = p[2].data();
        EXPECT_EQ(mgdt::compare_distance(a, b, c), -mgdt::compare_distance(a, c, b));
        EXPECT_EQ(mgdt::compare_distance(a, b, b), 0);
        EXPECT_EQ(mgdt::collinear(a, b, c), mgdt::collinear(c, a, b));
        EXPECT_EQ(mgdt::collinear(a, b, c), mgdt::collinear(b, a, c));
        EXPECT_TRUE(mgdt::collinear(a, b, b));
    });
}

// A family that never ties, or always does, would leave one side of the tests above untried.
TEST(Families, HoldBothTiesAndNone) {
    int ties = 0, inside = 0, outside = 0, flat = 0, lines = 0, equidistant = 0;
    Random random(7);
    for (const auto& family : families::all()) {
        for (int i = 0; i < 200; ++i) {
            const Five p = family.make(random);
            const int s = reference::side_of_sphere(p[0], p[1], p[2], p[3], p[4]);
            ties += s == 0;
            inside += s > 0;
            outside += s < 0;
            flat += reference::orientation(p[0], p[1], p[2], p[3]) == 0;
            lines += reference::collinear(p[0], p[1], p[2]);
            equidistant += reference::compare_distance(p[0], p[1], p[2]) == 0;
        }
    }
    EXPECT_GT(ties, 400);
    EXPECT_GT(inside, 400);
    EXPECT_GT(outside, 400);
    EXPECT_GT(flat, 200);
    EXPECT_GT(lines, 100);
    EXPECT_GT(equidistant, 100);
}

INSTANTIATE_TEST_SUITE_P(EveryFamily, Predicates, testing::ValuesIn(families::all()),
                         [](const auto& info) {
                             std::string name = info.param.name;
                             for (char& c : name) {
                                 if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
                             }
                             return name;
                         });

TEST(Predicates, SignsAsDocumented) {
    const double a[] = {0, 0, 0}, b[] = {1, 0, 0}, c[] = {0, 1, 0}, d[] = {0, 0, 1};
    const double in[] = {0.25, 0.25, 0.25}, on[] = {1, 1, 1}, out[] = {2, 2, 2};
    EXPECT_EQ(mgdt::orientation(a, b, c, d), 1);
    EXPECT_EQ(mgdt::orientation(b, a, c, d), -1);
    EXPECT_EQ(mgdt::side_of_sphere(a, b, c, d, in), 1);
    EXPECT_EQ(mgdt::side_of_sphere(a, b, c, d, on), 0);
    EXPECT_EQ(mgdt::side_of_sphere(a, b, c, d, out), -1);
    EXPECT_EQ(mgdt::compare_distance(a, in, on), -1);
    EXPECT_EQ(mgdt::compare_distance(a, b, c), 0);
    EXPECT_FALSE(mgdt::collinear(a, b, c));
    EXPECT_TRUE(mgdt::collinear(a, on, out));
}

TEST(CompareLexicographic, OrdersByXThenYThenZ) {
    const double points[][3] = {{-DBL_MAX, 5, 5}, {-1, 9, 9}, {0, -2, 7}, {0, 0, -0x1p-1074},
                                {0, 0, 0},        {0, 0, 1},  {0, 1, -3}, {DBL_MAX, -1, -1}};
    for (std::size_t i = 0; i < std::size(points); ++i) {
        for (std::size_t j = 0; j < std::size(points); ++j) {
            EXPECT_EQ(mgdt::compare_lexicographic(points[i], points[j]), (i > j) - (i < j));
        }
    }
    const double plus[] = {0.0, -0.0, 1}, minus[] = {-0.0, 0.0, 1};
    EXPECT_EQ(mgdt::compare_lexicographic(plus, minus), 0);
}

}  // namespace
