// SPDX-License-Identifier: MIT
// Natural-neighbour coordinates, against cells cut out in rational numbers, and where doubles do
// not do.
#include "interpolation/natural_weights.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <vector>

#include "../support/points.hpp"
#include "../support/small.h"
#include "core/triangulation.hpp"
#include "exact_cells.hpp"
#include "mesh/scale.hpp"
#include "query/locate.hpp"

namespace mgdt {
namespace {

using mgdt_tests::Points;
using mgdt_tests::uniform;
using Weights = std::map<std::uint32_t, double>;  // by point, none of them 0
using Stage = NaturalWeights::Stage;

class Set {
  public:
    explicit Set(Points points, std::int32_t scheme = 0)
        : xyz(std::move(points)),
          t_(nullptr, nullptr, nullptr),
          star_(t_.allocator()),
          weights_(t_.allocator()) {
        t_.settings().scheme = scheme;
        const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
        t_.insert(xyz.size() / 3, axis, 3);
    }
    // False outside the hull and at a vertex.
    bool find_star(const double* q) {
        const Locator where = {t_.mesh(), t_.calls(), t_.location_tree()};
        TetId hint = no_tetrahedron;
        const TetId t = where.locate(q, hint);
        if (t == no_tetrahedron) return false;
        for (int k = 0; k < 3; ++k) q_[k] = scaled(q[k], t_.mesh().scale);
        for (const VertexId v : t_.mesh().tetrahedra[t].v)
            if (std::equal(q_, q_ + 3, t_.mesh().point(v))) return false;
        star_.find(t_.mesh(), t_.calls(), q_, t);
        return true;
    }
    const PlaceStar& star() const { return star_; }
    void find(Natural natural) { weights_.find(t_.mesh(), star_, q_, natural); }
    bool find_in(Stage stage, Natural natural, int bits = 512) {
        return weights_.find_in(stage, t_.mesh(), star_, q_, natural, bits);
    }
    Weights weights() const {
        Weights by_point;
        for (PlaceStar::Number k = 0; k < star_.size(); ++k)
            if (weights_.weights()[k] != 0)
                by_point[t_.mesh().vertices[star_.vertex(k)].index] = weights_.weights()[k];
        return by_point;
    }

    const Points xyz;

  private:
    Triangulation t_;
    PlaceStar star_;
    NaturalWeights weights_;
    double q_[3] = {};
};

// How far the place of the weights is from q, of the distance of the farthest neighbour; and that
// they are no more than weights.
double place_error(const Set& set, const Weights& weights, const double* q) {
    double sum = 0, off[3] = {}, farthest = 0;
    for (const auto& [point, w] : weights) {
        EXPECT_GT(w, 0);
        sum += w;
        for (std::size_t k = 0; k < 3; ++k) {
            const double d = set.xyz[3 * point + k] - q[k];
            off[k] += w * d;
            farthest = std::max(farthest, std::fabs(d));
        }
    }
    EXPECT_NEAR(sum, 1, 2e-15);
    return std::max({std::fabs(off[0]), std::fabs(off[1]), std::fabs(off[2])}) / farthest;
}

using exact_cells::cross;
using exact_cells::operator+;
using exact_cells::dot;
using exact_cells::Rational;

double area_of(const std::vector<exact_cells::V>& polygon) {
    exact_cells::V twice = {0, 0, 0};
    for (std::size_t i = 0; i < polygon.size(); ++i)
        twice = twice + cross(polygon[i], polygon[(i + 1) % polygon.size()]);
    return std::sqrt(static_cast<double>(dot(twice, twice))) / 2;
}

// The weights of q among points, within planes.
Weights exact_weights(Points xyz, const double* q, Natural natural, const Points& planes = {}) {
    const std::size_t n = xyz.size() / 3;
    const Rational far = 1000000;
    Points with_place = xyz;
    with_place.insert(with_place.end(), q, q + 3);
    Weights weights;
    double sum = 0;
    for (std::uint32_t i = 0; i < n; ++i) {
        double w = 0;
        if (natural == Natural::sibson) {
            // What is nearest to i among the points, and nearer to q.
            auto all = exact_cells::half_spaces(xyz, i, planes);
            all.push_back(exact_cells::half_spaces(with_place, i, planes)[n - 1]);
            for (auto& x : all.back().normal) x = -x;
            all.back().offset = -all.back().offset;
            w = static_cast<double>(exact_cells::cell(all, far).volume);
        } else {
            const auto all = exact_cells::half_spaces(with_place, n, planes);
            w = area_of(exact_cells::face(all, i, far)) /
                std::sqrt(static_cast<double>(dot(all[i].normal, all[i].normal)));
        }
        if (w == 0) continue;
        weights[i] = w;
        sum += w;
    }
    for (auto& [point, w] : weights) w /= sum;
    return weights;
}

void expect_near(const Weights& actual, const Weights& expected, double error) {
    for (const auto& [point, w] : expected)
        EXPECT_NEAR(actual.count(point) ? actual.at(point) : 0, w, error) << "of point " << point;
    for (const auto& [point, w] : actual)
        EXPECT_TRUE(expected.count(point) || w < error) << point << " has " << w;
}

// The largest difference of a weight.
double distance(const Weights& a, const Weights& b) {
    double most = 0;
    for (const auto* const of : {&a, &b})
        for (const auto& [point, w] : *of) {
            const double in_a = a.count(point) ? a.at(point) : 0,
                         in_b = b.count(point) ? b.at(point) : 0;
            most = std::max(most, std::fabs(in_a - in_b));
        }
    return most;
}

// Below `end`.
double integer(std::mt19937& random, unsigned end) {
    return static_cast<double>(random() % end);
}

// At different places.
Points random_integers(std::mt19937& random, std::size_t n, unsigned end, double height = 1) {
    std::set<std::array<double, 3>> places;
    for (std::size_t i = 0; i < n; ++i)
        places.insert({integer(random, end), integer(random, end), height * integer(random, end)});
    Points xyz;
    for (const auto& p : places) xyz.insert(xyz.end(), p.begin(), p.end());
    return xyz;
}

// Few different coordinates make many points on one sphere, few different places, and queries
// in facets and edges inside.
TEST(NaturalWeights, AreThoseOfCellsCutOutInRationals) {
    std::mt19937 random(3);
    int places = 0;
    for (const unsigned end : {3u, 5u, 100u})
        for (int repeat = 0; repeat < (is_small() ? 1 : 6); ++repeat) {
            Set set(random_integers(random, 14, end));
            for (int k = 0; k < (is_small() ? 6 : 24); ++k) {
                double q[3];
                for (double& x : q) x = 0.25 * integer(random, 4 * end);
                if (!set.find_star(q) || set.star().is_on_hull()) continue;
                ++places;
                for (const Natural natural : {Natural::sibson, Natural::laplace}) {
                    const Weights expected = exact_weights(set.xyz, q, natural);
                    set.find(natural);
                    expect_near(set.weights(), expected, 1e-13);
                    if (set.find_in(Stage::corrected, natural))
                        expect_near(set.weights(), expected, 1e-13);
                    ASSERT_TRUE(set.find_in(Stage::twofold, natural));
                    expect_near(set.weights(), expected, 1e-15);
                    ASSERT_TRUE(set.find_in(Stage::long_numbers, natural, 2048));
                    expect_near(set.weights(), expected, 1e-15);
                }
            }
        }
    EXPECT_GT(places, is_small() ? 3 : 60);
}

// The same set with another point in every plane z = 0, and one far from it.
TEST(NaturalWeights, InAPlaneOfTheHullAreThoseOfThatPlane) {
    std::mt19937 random(4);
    int places = 0;
    for (int repeat = 0; repeat < (is_small() ? 2 : 20); ++repeat) {
        const Points flat = random_integers(random, 10, repeat % 2 ? 4 : 50, 0);
        Points all = flat;
        for (int i = 0; i < 6; ++i)
            for (int k = 0; k < 3; ++k) all.push_back(1 + integer(random, 20));
        Set set(all);
        for (int k = 0; k < 10; ++k) {
            const double q[3] = {0.5 * integer(random, 100), 0.5 * integer(random, 100), 0};
            if (!set.find_star(q)) continue;
            ASSERT_TRUE(set.star().is_on_hull());
            if (set.star().is_on_ridge()) continue;
            ++places;
            for (const Natural natural : {Natural::sibson, Natural::laplace}) {
                const Weights expected = exact_weights(flat, q, natural, {0, 0, 1, 1, 0, 0, -1, 1});
                for (const Stage stage : {Stage::twofold, Stage::long_numbers}) {
                    ASSERT_TRUE(set.find_in(stage, natural));
                    expect_near(set.weights(), expected, 1e-14);
                }
            }
        }
    }
    EXPECT_GT(places, is_small() ? 1 : 15);
}

TEST(NaturalWeights, KnowTheRidgesOfTheHull) {
    // A cube of eight, whose faces are in two triangles each.
    Points cube;
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < 3; ++k) cube.push_back(i >> k & 1);
    Set set(cube);
    const double ridge[3] = {0.25, 0, 0}, face[3] = {0.5, 0.5, 0}, corner[3] = {0, 1, 0},
                 inside[3] = {0.5, 0.5, 0.5};
    ASSERT_TRUE(set.find_star(ridge));
    EXPECT_TRUE(set.star().is_on_ridge());
    EXPECT_FALSE(set.find_star(corner));
    for (const Natural natural : {Natural::sibson, Natural::laplace}) {
        ASSERT_TRUE(set.find_star(face));
        EXPECT_FALSE(set.star().is_on_ridge());
        set.find(natural);
        EXPECT_EQ(set.weights(), (Weights{{0, .25}, {1, .25}, {2, .25}, {3, .25}}));
        ASSERT_TRUE(set.find_star(inside));
        EXPECT_FALSE(set.star().is_on_hull());
        set.find(natural);
        for (const auto& [point, w] : set.weights()) EXPECT_NEAR(w, .125, 1e-14) << point;
    }
}

TEST(NaturalWeights, HaveTheSameBitsInWhateverOrder) {
    const Points xyz = uniform(300, 1), places = uniform(200, 2);
    Set set(xyz), other(xyz, MGDT_ORDER_LEXICOGRAPHIC);
    int in_doubles = 0;
    for (std::size_t i = 0; i < 200; ++i) {
        const double* const q = places.data() + 3 * i;
        const bool is_inside = set.find_star(q);
        ASSERT_EQ(other.find_star(q), is_inside);
        if (!is_inside) continue;
        for (const Natural natural : {Natural::sibson, Natural::laplace}) {
            in_doubles += set.find_in(Stage::doubles, natural);
            set.find(natural);
            other.find(natural);
            EXPECT_EQ(set.weights(), other.weights());
            EXPECT_LT(place_error(set, set.weights(), q), 1e-14);
        }
    }
    EXPECT_GT(in_doubles, 200);  // so these are seen
}

// In all stages, in space and in planes of the hull, where the order of the parts might be seen.
TEST(NaturalWeights, HaveTheSameBitsInAllStages) {
    Points xyz = uniform(120, 3), places = uniform(100, 4);
    for (std::size_t i = 0; i < xyz.size(); i += 9) xyz[i + 2] = 0;
    for (std::size_t i = 0; i < places.size(); i += 6) places[i + 2] = 0;
    Set set(xyz), other(xyz, MGDT_ORDER_LEXICOGRAPHIC);
    int on_hull = 0;
    for (std::size_t i = 0; i < 100; ++i) {
        const double* const q = places.data() + 3 * i;
        if (!set.find_star(q) || set.star().is_on_ridge()) continue;
        ASSERT_TRUE(other.find_star(q));
        on_hull += set.star().is_on_hull();
        for (const Natural natural : {Natural::sibson, Natural::laplace})
            for (const Stage stage : {Stage::corrected, Stage::twofold, Stage::long_numbers}) {
                EXPECT_EQ(set.find_in(stage, natural, 256), other.find_in(stage, natural, 256));
                EXPECT_EQ(set.weights(), other.weights());
            }
    }
    EXPECT_GT(on_hull, 10);
}

// Points in a plane but for their rounding: the circumspheres at that part of the hull are as large
// as the planes are flat, and places may be in tetrahedra of the height of a rounding.
TEST(NaturalWeights, AtAHullThatIsNearlyFlat) {
    Points xyz;
    const auto place = [](double a, double b, double c, double* q) {
        q[0] = .6 * a - .8 * b;
        q[1] = .8 * a + .6 * b;
        q[2] = c / 3;
    };
    const int side = is_small() ? 4 : 7;
    for (int a = 0; a < side; ++a)
        for (int b = 0; b < side; ++b)
            for (int c = 0; c < side; ++c) {
                double p[3];
                place(a, b, c, p);
                xyz.insert(xyz.end(), p, p + 3);
            }
    Set set(xyz);
    std::mt19937 random(5);
    const auto end = static_cast<unsigned>(10 * side - 10);
    int on_hull = 0;
    double most_of_sure = 0, most_of_others = 0, most_of_corrected = 0;
    for (int k = 0; k < (is_small() ? 30 : 400); ++k) {
        double q[3];
        place(k % 2 ? 0 : side - 1, 0.1 * integer(random, end), 0.1 * integer(random, end), q);
        if (!set.find_star(q)) continue;
        on_hull += set.star().is_on_hull();
        if (set.star().is_on_ridge()) continue;
        for (const Natural natural : {Natural::sibson, Natural::laplace}) {
            set.find(natural);
            EXPECT_LT(place_error(set, set.weights(), q), 1e-14);
            if (set.star().is_on_hull()) continue;
            const Weights known = set.weights();
            double& most = set.find_in(Stage::doubles, natural) ? most_of_sure : most_of_others;
            most = std::max(most, distance(known, set.weights()));
            if (set.find_in(Stage::corrected, natural))
                most_of_corrected = std::max(most_of_corrected, distance(known, set.weights()));
        }
    }
    EXPECT_GT(on_hull, 0);
    EXPECT_LT(most_of_sure, natural_weight_error);
    EXPECT_LT(most_of_corrected, natural_weight_error);
    EXPECT_GT(most_of_others, natural_weight_error);
}

// A place inside a hollow body has all points as its neighbours, and takes its part of each cell
// from circumcentres that are all but one.
TEST(NaturalWeights, InHollowBodiesAreFoundInDoubles) {
    const std::size_t n = is_small() ? 60 : 600;
    std::mt19937_64 random(6);
    std::normal_distribution<double> normal;
    Points round;
    for (std::size_t i = 0; i < n; ++i) {
        const double x[3] = {normal(random), normal(random), normal(random)},
                     size = std::hypot(std::hypot(x[0], x[1]), x[2]);
        for (const double c : x) round.push_back(c / size);
    }
    Points spiral;
    for (std::size_t i = 0; i < n; ++i) {
        const double z = 2 * (static_cast<double>(i) + 0.5) / static_cast<double>(n) - 1,
                     r = std::sqrt(1 - z * z), turn = 0.1 * static_cast<double>(i);
        spiral.insert(spiral.end(), {r * std::cos(turn), r * std::sin(turn), z});
    }
    for (const Points& xyz : {round, spiral}) {
        Set set(xyz);
        int places = 0, in_doubles = 0;
        for (int k = 0; k < 20; ++k) {
            double q[3];
            for (double& x : q) x = 0.2 * normal(random);
            if (!set.find_star(q)) continue;
            for (const Natural natural : {Natural::sibson, Natural::laplace}) {
                ++places;
                EXPECT_GT(set.star().size(), n / 2);
                if (!set.find_in(Stage::doubles, natural) &&
                    !set.find_in(Stage::corrected, natural))
                    continue;
                ++in_doubles;
                const Weights found = set.weights();
                ASSERT_TRUE(set.find_in(Stage::twofold, natural));
                EXPECT_LT(distance(found, set.weights()), 1e-12);
            }
        }
        EXPECT_GT(in_doubles, 0.9 * places);
        EXPECT_GT(places, 30);
    }
}

TEST(NaturalWeights, OfCoordinatesOfAnySize) {
    for (const double unit : {0x1p-1030, 0x1p-500, 1.0, 0x1p500, 0x1p1020}) {
        Points xyz = {0, 0, 0, 8, 0, 0, 0, 8, 0, 0, 0, 8, 9, 9, 9, 3, 2, 1};
        for (double& x : xyz) x *= unit;
        Set set(xyz);
        const double q[3] = {3 * unit, 3 * unit, 2 * unit};
        ASSERT_TRUE(set.find_star(q));
        for (const Natural natural : {Natural::sibson, Natural::laplace}) {
            set.find(natural);
            EXPECT_LT(place_error(set, set.weights(), q), 1e-14);
        }
    }
    // A neighbour that is 2^-900 away, of others that are 1 away.
    Points xyz = {0, 0, 0, 8, 0, 0, 0, 8, 0, 0, 0, 8, -8, -8, -8};
    Set set(xyz);
    const double q[3] = {0x1p-900, 0x1p-901, 0x1p-902};
    ASSERT_TRUE(set.find_star(q));
    for (const Natural natural : {Natural::sibson, Natural::laplace}) {
        set.find(natural);
        EXPECT_NEAR(set.weights().at(0), 1, 1e-15);
    }
}

// Shapes that take hundreds of digits: thin slabs and needles in any direction, and exponents that
// are far apart.
TEST(NaturalWeights, OfExtremeShapes) {
    if (is_small()) GTEST_SKIP() << "the rationals have thousands of bits";
    std::mt19937_64 random(7);
    const auto any = [&] { return static_cast<double>(random() >> 11) * 0x1p-53 - 0.5; };
    int places = 0;
    for (int run = 0; run < 9; ++run) {
        Points xyz;
        const double thin = std::ldexp(1, -50 - 20 * run);
        for (int i = 0; i < 7; ++i) {
            const double a = any(), b = any(), c = any();
            switch (run % 3) {
                case 0:
                    xyz.insert(xyz.end(), {a, b, a / 3 - b / 7 + c * thin});
                    break;
                case 1:
                    xyz.insert(xyz.end(), {a, a / 3 + b * thin, a / 7 + c * thin});
                    break;
                default:
                    for (const double x : {a, b, c})
                        xyz.push_back(std::ldexp(x, static_cast<int>(random() % 300) - 150));
            }
        }
        Set set(xyz);
        for (int k = 0; k < 20; ++k) {
            double q[3] = {}, share[7], all = 0;
            for (double& s : share) all += s = 0.5 + any();
            for (std::size_t i = 0; i < 7; ++i)
                for (std::size_t axis = 0; axis < 3; ++axis)
                    q[axis] += share[i] / all * xyz[3 * i + axis];
            if (!set.find_star(q) || set.star().is_on_hull()) continue;
            ++places;
            std::vector<Rational> exact;
            Rational sum = 0;
            for (std::size_t i = 0; i < 7; ++i) {
                auto of_i = exact_cells::half_spaces(xyz, i, {});
                Points with_place = xyz;
                with_place.insert(with_place.end(), q, q + 3);
                of_i.push_back(exact_cells::half_spaces(with_place, i, {}).back());
                for (auto& x : of_i.back().normal) x = -x;
                of_i.back().offset = -of_i.back().offset;
                exact.push_back(
                    exact_cells::cell(of_i, Rational(boost::multiprecision::cpp_int(1) << 2500))
                        .volume);
                sum += exact.back();
            }
            set.find(Natural::sibson);
            const Weights found = set.weights();
            for (std::uint32_t i = 0; i < 7; ++i)
                EXPECT_NEAR(found.count(i) ? found.at(i) : 0, static_cast<double>(exact[i] / sum),
                            natural_weight_error)
                    << run;
            break;
        }
    }
    EXPECT_GT(places, 3);
}

// Many neighbours: the centre of a sphere of points.
TEST(NaturalWeights, OfAHub) {
    std::mt19937 random(6);
    std::normal_distribution<double> normal;
    Points xyz;
    for (int i = 0; i < (is_small() ? 100 : 3000); ++i) {
        double p[3], square = 0;
        for (double& x : p) {
            x = normal(random);
            square += x * x;
        }
        for (const double x : p) xyz.push_back(x / std::sqrt(square));
    }
    Set set(xyz);
    const double q[3] = {.01, .02, .03};
    ASSERT_TRUE(set.find_star(q));
    EXPECT_GT(set.star().size(), is_small() ? 50u : 2000u);
    for (const Natural natural : {Natural::sibson, Natural::laplace}) {
        set.find(natural);
        EXPECT_LT(place_error(set, set.weights(), q), 1e-14);
    }
}

}  // namespace
}  // namespace mgdt
