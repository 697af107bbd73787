// SPDX-License-Identifier: MIT
// What a point costs as sets grow: tetrahedra visited, removed and created, and exact decisions.
// Little of it may grow with the number of points, on any kind of set. Where the triangulation
// itself grows faster than the points (a helix), it is counted against that. These counts are the
// same on every machine; --long adds sets of a million points, and seconds.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "../property/handle.hpp"
#include "cli/point_sets/distributions.hpp"
#include "degenerate_sets.hpp"

namespace faults {
namespace {

bool is_long = false;

struct Cost {
    double visited, removed, created, exact, seconds;
    std::int64_t tetrahedra;
};

Points generated(const char* kind, std::size_t n) {
    return mgdt::cli::generate(kind, n, mgdt::cli::GenerateOptions());
}

struct Kind {
    const char* name;
    Points (*points)(std::size_t n);
    double visited;  // tetrahedra a point
    double exact;    // decisions a point that the filter may leave open
    double growth;   // of each count, from one size to the next
};

constexpr std::size_t million = 1000000;
const Kind kinds[] = {
    {"uniform", [](std::size_t n) { return generated("uniform", n); }, 3, 0.01, 1.5},
    {"lattice", [](std::size_t n) { return generated("lattice", n); }, 4, 80, 1.5},
    {"sphere", [](std::size_t n) { return generated("sphere", n); }, 4, 1, 1.5},
    // Too close to one sphere for the 21 bits of those that are kept.
    {"coarse",
     [](std::size_t n) {
         Points xyz = generated("uniform", n);
         for (std::size_t i = 0; i < xyz.size(); i += 3) {
             double* const p = &xyz[i];
             const double length = std::hypot(p[0] - 0.5, p[1] - 0.5, p[2] - 0.5);
             for (int k = 0; k < 3; ++k)
                 p[k] = static_cast<double>(static_cast<float>((p[k] - 0.5) / length));
         }
         return xyz;
     },
     4, 25, 1.5},
    {"slab",
     [](std::size_t n) {
         Points xyz = generated("uniform", n);
         for (std::size_t i = 2; i < xyz.size(); i += 3) xyz[i] *= 1e-6;
         return xyz;
     },
     4, 12, 1.5},
    {"cospherical",
     [](std::size_t n) {
         return integer_sphere(n, n <= 4000 ? 231 : n <= 77000 ? 4389 : 100947);
     },
     // Every decision is a tie, and stars grow slowly with the set. Walks go over the hull.
     12, 300, 2},
    {"repeats", [](std::size_t n) { return generated("lattice-repeats", n); }, 4, 80, 1.5},
    {"layers", layers, 4, 80, 1.5},
    // Its triangulation is quadratic.
    {"helix",
     [](std::size_t n) {
         return helix(static_cast<std::size_t>(4 * std::sqrt(static_cast<double>(n))));
     },
     12, 80, 1.5},
    {"anisotropic", [](std::size_t n) { return generated("anisotropic", n); }, 4, 80, 1.5},
};

Cost cost_of(const Points& xyz) {
    const property::Handle handle = property::create();
    mgdt_triangulation* const t = handle.get();
    EXPECT_EQ(mgdt_insert_points(t, static_cast<std::int64_t>(xyz.size() / 3), xyz.data()),
              MGDT_OK);
    EXPECT_EQ(mgdt_check(t, is_long ? MGDT_CHECK_GEOMETRIC : MGDT_CHECK_CANONICAL), MGDT_OK)
        << property::error_of(t);
    const auto stat = [&](std::int32_t key) {
        double value = -1;
        EXPECT_EQ(mgdt_get_stat(t, key, &value), MGDT_OK);
        return value;
    };
    // A random set has some seven tetrahedra a point.
    const double n = std::max(static_cast<double>(xyz.size() / 3),
                              static_cast<double>(mgdt_tetrahedron_count(t)) / 7);
    return {stat(MGDT_STAT_WALK_STEPS) / n,
            stat(MGDT_STAT_TETRAHEDRA_REMOVED) / n,
            stat(MGDT_STAT_TETRAHEDRA_CREATED) / n,
            stat(MGDT_STAT_EXACT_CALLS) / n,
            stat(MGDT_STAT_ORDER_SECONDS) + stat(MGDT_STAT_INSERT_SECONDS),
            mgdt_tetrahedron_count(t)};
}

std::vector<std::size_t> sizes() {
    if (is_long) return {10000, 100000, million};
    if (is_small()) return {500, 1000};
    return {2000, 16000};
}

class CostOfAPoint : public testing::TestWithParam<Kind> {};

TEST_P(CostOfAPoint, DoesNotGrow) {
    const Kind& kind = GetParam();
    std::vector<Cost> costs;
    for (const std::size_t n : sizes()) {
        const Points xyz = kind.points(n);
        const Cost c = cost_of(xyz);
        std::printf(
            "%-12s %8zu points, %8lld tetrahedra: visited %6.1f removed %6.1f created %6.1f "
            "exact %6.2f, %6.2f us a point\n",
            kind.name, xyz.size() / 3, static_cast<long long>(c.tetrahedra), c.visited, c.removed,
            c.created, c.exact, 3e6 * c.seconds / static_cast<double>(xyz.size()));
        EXPECT_LE(c.visited, kind.visited);
        EXPECT_LE(c.exact, kind.exact);
        costs.push_back(c);
    }
    // Half as much again is what the share of points near the hull explains.
    for (std::size_t k = 1; k < costs.size(); ++k) {
        EXPECT_LE(costs[k].visited, kind.growth * costs[k - 1].visited + 1);
        EXPECT_LE(costs[k].removed, kind.growth * costs[k - 1].removed + 1);
        EXPECT_LE(costs[k].created, kind.growth * costs[k - 1].created + 1);
        EXPECT_LE(costs[k].exact, kind.growth * costs[k - 1].exact + 1);
        if (is_long) {
            // Ten times the points, and twice as slow where they leave the caches.
            EXPECT_LE(costs[k].seconds, 20 * kind.growth * costs[k - 1].seconds);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, CostOfAPoint, testing::ValuesIn(kinds),
                         [](const auto& info) { return info.param.name; });

// A million points of a lattice within three times the time of random ones; what a million on one
// sphere take is told.
TEST(Time, OfDegenerateSets) {
    if (!is_long) return;
    const double usual = cost_of(kinds[0].points(million)).seconds;
    const double lattice = cost_of(kinds[1].points(million)).seconds;
    const double cospherical = cost_of(kinds[3].points(million)).seconds;
    std::printf("times the time of uniform points: lattice %.2f, cospherical %.2f\n",
                lattice / usual, cospherical / usual);
    EXPECT_LE(lattice, 3 * usual);
}

}  // namespace
}  // namespace faults

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    faults::is_long = argc > 1 && std::string(argv[1]) == "--long";
    return RUN_ALL_TESTS();
}
