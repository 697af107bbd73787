// SPDX-License-Identifier: MIT
// The library against the brute-force oracle, on thousands of tiny sets that are mostly
// degenerate: everything that can be exported is compared or recomputed.
#include "oracle.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <random>
#include <set>
#include <sstream>

#include "handle.hpp"

namespace {

using property::Handle;
using Random = std::mt19937_64;
using Index = std::int64_t;

std::size_t below(Random& random, std::size_t n) {
    return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
}

std::string text(const std::vector<double>& xyz) {
    std::ostringstream out;
    out.precision(17);
    for (std::size_t i = 0; i < xyz.size(); i += 3)
        out << "\n" << xyz[i] << " " << xyz[i + 1] << " " << xyz[i + 2];
    return out.str();
}

// Whether the library's orientation claims hold, in the oracle's arithmetic.
class Geometry {
  public:
    explicit Geometry(const std::vector<double>& xyz) : points_(oracle::exact_points(xyz)) {}
    int orientation(Index a, Index b, Index c, Index d) const {
        return oracle::orientation(at(a), at(b), at(c), at(d));
    }

  private:
    const oracle::Point<oracle::BigInteger>& at(Index i) const {
        return points_[static_cast<std::size_t>(i)];
    }
    std::vector<oracle::Point<oracle::BigInteger>> points_;
};

std::array<Index, 3> facet(const std::vector<Index>& tetrahedra, std::size_t t, std::size_t i) {
    std::array<Index, 3> f{};
    for (std::size_t k = 0, m = 0; k < 4; ++k)
        if (k != i) f[m++] = tetrahedra[4 * t + k];
    std::sort(f.begin(), f.end());
    return f;
}

// Orientation, neighbours, hull and edges, from the exported tetrahedra.
void verify_exports(const mgdt_triangulation* t, const std::vector<double>& xyz) {
    const Geometry geometry(xyz);
    const std::vector<Index> tetrahedra = property::tetrahedra(t),
                             neighbors = property::neighbors(t), hull = property::hull_facets(t),
                             edges = property::edges(t);
    std::map<std::array<Index, 3>, std::vector<std::size_t>> owners;
    std::set<std::array<Index, 2>> expected_edges;
    for (std::size_t m = 0; m < tetrahedra.size() / 4; ++m) {
        const Index* v = &tetrahedra[4 * m];
        ASSERT_GT(geometry.orientation(v[0], v[1], v[2], v[3]), 0) << "tetrahedron " << m;
        for (std::size_t i = 0; i < 4; ++i) {
            owners[facet(tetrahedra, m, i)].push_back(m);
            for (std::size_t j = 0; j < 4; ++j)
                if (v[i] < v[j]) expected_edges.insert({v[i], v[j]});
        }
    }
    std::set<std::array<Index, 3>> expected_hull;
    for (const auto& [f, owner] : owners) {
        ASSERT_LE(owner.size(), 2u);
        if (owner.size() == 1) expected_hull.insert(f);
    }
    for (std::size_t m = 0; m < tetrahedra.size() / 4; ++m)
        for (std::size_t i = 0; i < 4; ++i) {
            const auto& owner = owners[facet(tetrahedra, m, i)];
            const Index expected =
                owner.size() == 1 ? -1 : static_cast<Index>(owner[0] == m ? owner[1] : owner[0]);
            ASSERT_EQ(neighbors[4 * m + i], expected) << "tetrahedron " << m << " facet " << i;
        }

    std::set<std::array<Index, 3>> found_hull;
    for (std::size_t h = 0; h < hull.size(); h += 3) {
        std::array<Index, 3> f = {hull[h], hull[h + 1], hull[h + 2]};
        for (std::size_t q = 0; q < xyz.size() / 3; ++q)  // convex, and seen from outside
            ASSERT_LE(geometry.orientation(f[0], f[1], f[2], static_cast<Index>(q)), 0)
                << "hull facet " << h / 3 << " and point " << q;
        std::sort(f.begin(), f.end());
        ASSERT_TRUE(found_hull.insert(f).second) << "hull facet " << h / 3 << " comes twice";
    }
    ASSERT_EQ(found_hull, expected_hull);

    std::set<std::array<Index, 2>> found_edges;
    for (std::size_t e = 0; e < edges.size(); e += 2)
        ASSERT_TRUE(found_edges.insert({edges[e], edges[e + 1]}).second) << "an edge comes twice";
    ASSERT_EQ(found_edges, expected_edges);
}

void verify(const mgdt_triangulation* t, const std::vector<double>& xyz,
            const oracle::Triangulation& expected) {
    ASSERT_EQ(mgdt_check(t, MGDT_CHECK_CANONICAL), MGDT_OK) << property::error_of(t);
    ASSERT_EQ(mgdt_dimension(t), expected.dimension);
    ASSERT_EQ(mgdt_point_count(t), static_cast<Index>(xyz.size() / 3));
    const std::vector<Index> map = property::point_map(t);
    Index vertices = 0;
    for (std::size_t i = 0; i < map.size(); ++i) {
        ASSERT_EQ(map[i], static_cast<Index>(expected.representative[i])) << "point " << i;
        vertices += expected.representative[i] == i;
    }
    ASSERT_EQ(mgdt_vertex_count(t), vertices);

    property::Keys keys;
    for (oracle::Quadruple v : expected.tetrahedra) {
        std::sort(v.begin(), v.end());
        keys.push_back({static_cast<std::uint32_t>(v[0]), static_cast<std::uint32_t>(v[1]),
                        static_cast<std::uint32_t>(v[2]), static_cast<std::uint32_t>(v[3])});
    }
    std::sort(keys.begin(), keys.end());
    ASSERT_EQ(mgdt_tetrahedron_count(t), static_cast<Index>(keys.size()));
    ASSERT_EQ(property::keys(property::tetrahedra(t)), keys);
    verify_exports(t, xyz);
}

// Every scheme, each with a split in random batches of its own (some empty) and a random seed.
void compare(const std::vector<double>& xyz, Random& random) {
    SCOPED_TRACE("points:" + text(xyz));
    const oracle::Triangulation expected = oracle::triangulate(xyz);
    const std::size_t n = xyz.size() / 3;
    for (std::int32_t scheme : property::schemes) {
        std::vector<std::size_t> batches = {0};
        for (std::size_t k = below(random, 5); k > 0; --k) batches.push_back(below(random, n + 1));
        std::sort(batches.begin(), batches.end());
        std::string at;
        for (std::size_t b : batches) at += " " + std::to_string(b);
        SCOPED_TRACE(std::string(mgdt_order_scheme_name(scheme)) + ", batches at" + at);
        const Handle t = property::create();
        ASSERT_EQ(mgdt_set_order_scheme(t.get(), scheme), MGDT_OK);
        ASSERT_EQ(mgdt_set_seed(t.get(), random()), MGDT_OK);
        ASSERT_EQ(property::insert(t.get(), xyz, batches), MGDT_OK) << property::error_of(t.get());
        verify(t.get(), xyz, expected);
        if (testing::Test::HasFatalFailure()) return;
    }
}

using Coordinate = std::function<double(Random&)>;

// `count` sets of 1 to `most` points whose coordinates the function draws, a few points repeated.
void compare_sets(std::size_t count, std::size_t most, std::uint64_t seed,
                  const Coordinate& coordinate) {
    if (is_small()) count = count / 20 + 1;
    Random random(seed);
    for (std::size_t k = 0; k < count; ++k) {
        std::vector<double> xyz(3 * (1 + below(random, most)));
        for (double& x : xyz) x = coordinate(random);
        for (std::size_t repeats = below(random, 3); repeats > 0; --repeats) {
            const std::size_t i = 3 * below(random, xyz.size() / 3);
            const std::array<double, 3> p = {xyz[i], xyz[i + 1], xyz[i + 2]};
            xyz.insert(xyz.end(), p.begin(), p.end());
        }
        compare(xyz, random);
        if (testing::Test::HasFatalFailure()) FAIL() << "set " << k << " of seed " << seed;
    }
}

double lattice(Random& random, std::size_t n) {
    return static_cast<double>(below(random, n));
}

// Two values an axis: the corners of a cube, cospherical and repeated.
TEST(Oracle, CubeCorners) {
    compare_sets(300, 12, 1, [](Random& r) { return lattice(r, 2); });
}

TEST(Oracle, ThreeValuesAnAxis) {
    compare_sets(400, 12, 2, [](Random& r) { return lattice(r, 3); });
}

TEST(Oracle, FourValuesAnAxis) {
    compare_sets(400, 14, 3, [](Random& r) { return lattice(r, 4); });
}

TEST(Oracle, CentredLatticeWithMinusZero) {
    compare_sets(300, 12, 4, [](Random& r) {
        const double x = lattice(r, 5) - 2;
        return x == 0 && below(r, 2) ? -0.0 : x;
    });
}

TEST(Oracle, FewPoints) {
    compare_sets(600, 6, 5, [](Random& r) { return lattice(r, 3); });
}

// Lattices that rounding distorts: nearly, not exactly, cospherical and coplanar.
TEST(Oracle, TenthsOfALattice) {
    compare_sets(60, 10, 6, [](Random& r) { return 0.1 * lattice(r, 4); });
}

TEST(Oracle, FarFromTheOrigin) {
    compare_sets(60, 10, 7, [](Random& r) { return 1e15 + 0.125 * lattice(r, 4); });
}

TEST(Oracle, UniformDoubles) {
    compare_sets(60, 12, 8,
                 [](Random& r) { return std::uniform_real_distribution<double>(-1, 1)(r); });
}

TEST(Oracle, LatticeNearTheLargestDouble) {
    compare_sets(60, 10, 9, [](Random& r) { return 0x1p1022 * (lattice(r, 5) - 2); });
}

TEST(Oracle, LatticeOfTheLeastSubnormals) {
    compare_sets(60, 10, 10, [](Random& r) { return 0x1p-1074 * (lattice(r, 5) - 2); });
}

TEST(Oracle, SubnormalDoubles) {
    compare_sets(40, 10, 11, [](Random& r) {
        return std::uniform_real_distribution<double>(-0x1p-1030, 0x1p-1030)(r);
    });
}

// No common scale: 1e300, 1, 1e-300 and zeros in one set.
TEST(Oracle, MixedScales) {
    compare_sets(60, 9, 12, [](Random& r) {
        static constexpr double scale[] = {0, 0, 1e-300, 1, 1e300, 0x1p-1074, 1e-160, 1e160};
        return scale[below(r, 8)] * (lattice(r, 5) - 2);
    });
}

TEST(Oracle, RandomExponents) {
    compare_sets(40, 9, 13, [](Random& r) {
        const double m = std::uniform_real_distribution<double>(-1, 1)(r);
        return std::ldexp(m, static_cast<int>(below(r, 2090)) - 1066);
    });
}

TEST(Oracle, LargestDouble) {
    compare_sets(40, 9, 14, [](Random& r) {
        const double largest = std::numeric_limits<double>::max();
        static const double values[] = {-largest, largest, 0, 1, std::nextafter(largest, 0)};
        return values[below(r, 5)];
    });
}

// A few points in space, the others in the plane z = 1 or on a line in it.
TEST(Oracle, MostlyFlat) {
    Random random(15);
    const std::size_t count = is_small() ? 10 : 300;
    for (std::size_t k = 0; k < count && !HasFatalFailure(); ++k) {
        const bool line = below(random, 2) != 0;
        std::vector<double> xyz;
        for (std::size_t n = 4 + below(random, 8); n > 0; --n) {
            const double x = lattice(random, 4), y = lattice(random, 4);
            xyz.insert(xyz.end(), {x, line ? 2 * x : y, 1});
        }
        for (std::size_t n = below(random, 3); n > 0; --n)
            for (int i = 0; i < 3; ++i) xyz.push_back(lattice(random, 4));
        compare(xyz, random);
    }
}

std::vector<double> read(const std::filesystem::path& path) {
    std::ifstream in(path);
    std::vector<double> xyz;
    for (std::string line; std::getline(in, line);) {
        if (line.rfind('#', 0) == 0) continue;
        std::istringstream words(line);
        for (std::string word; words >> word;) xyz.push_back(std::strtod(word.c_str(), nullptr));
    }
    return xyz;
}

// Sets that once showed a defect; each file says which.
TEST(Oracle, Corpus) {
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(MGDT_TEST_CORPUS)) {
        if (entry.path().extension() != ".xyz") continue;
        SCOPED_TRACE(entry.path().string());
        const std::vector<double> xyz = read(entry.path());
        ASSERT_FALSE(xyz.empty());
        ASSERT_EQ(xyz.size() % 3, 0u);
        Random random(++files);
        for (int repeat = 0; repeat < 10; ++repeat) compare(xyz, random);
    }
    EXPECT_GE(files, 2u);
}

// What the oracle says of sets whose answer is known by hand.
TEST(OracleItself, KnownAnswers) {
    EXPECT_EQ(oracle::triangulate(std::vector<double>{}).dimension, -1);
    EXPECT_EQ(oracle::triangulate({1, 2, 3, 1, 2, 3}).dimension, 0);
    EXPECT_EQ(oracle::triangulate({0, 0, 0, 1, 1, 1, 3, 3, 3}).dimension, 1);
    EXPECT_EQ(oracle::triangulate({0, 0, 0, 1, 0, 1, 3, 1, 3, 5, 5, 5}).dimension, 2);
    const auto one = oracle::triangulate({0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 0, 1});
    ASSERT_EQ(one.tetrahedra.size(), 1u);
    EXPECT_EQ(one.tetrahedra[0], (oracle::Quadruple{0, 1, 3, 2}));
    // Raising (1, 1), the largest, takes it above the plane of the square's other three lifted
    // corners, so the lower hull has the edge 1-2.
    const auto pyramid = oracle::triangulate({0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, 0.5, 0.5, 1});
    ASSERT_EQ(pyramid.tetrahedra.size(), 2u);
    for (oracle::Quadruple v : pyramid.tetrahedra) {
        EXPECT_EQ(std::count(v.begin(), v.end(), 1u), 1);
        EXPECT_EQ(std::count(v.begin(), v.end(), 2u), 1);
    }
}

// The oracle's tetrahedra fill the convex hull: their volumes add up to the cube's.
TEST(OracleItself, CubeIsFilled) {
    const std::vector<double> cube = {0, 0, 0, 2, 0, 0, 0, 2, 0, 2, 2, 0, 0, 0, 2,
                                      2, 0, 2, 0, 2, 2, 2, 2, 2, 1, 1, 1, 1, 1, 0};
    const auto points = oracle::small_points(cube);
    std::int64_t sum = 0;
    for (const oracle::Quadruple& v : oracle::triangulate(cube).tetrahedra)
        sum += oracle::volume(points[v[0]], points[v[1]], points[v[2]], points[v[3]]);
    EXPECT_EQ(sum, 6 * 8);
}

}  // namespace
