// SPDX-License-Identifier: MIT
// What a point costs as sets grow: tetrahedra visited, removed and created, and exact decisions.
// None of it may grow with the number of points, on any kind of set. These counts are the same on
// every machine; --long adds sets of a million points, and seconds.
#include <cstdio>
#include <map>
#include <string>

#include "../property/handle.hpp"
#include "cli/distributions.hpp"
#include "degenerate_sets.hpp"

namespace faults {
namespace {

bool is_long = false;

struct Cost {
    double visited, removed, created, exact, seconds;
    std::int64_t vertices;
};

Points generated(const char* kind, std::size_t n) {
    return mgdt::cli::generate(kind, n, mgdt::cli::GenerateOptions());
}

struct Kind {
    const char* name;
    Points (*points)(std::size_t n);
    std::size_t most;  // with more points the set is another kind of set, or too slow
    double exact;      // decisions a point that the filter may leave open
};

constexpr std::size_t million = 1000000;
const Kind kinds[] = {
    {"uniform", [](std::size_t n) { return generated("uniform", n); }, million, 0.01},
    {"lattice", [](std::size_t n) { return generated("lattice", n); }, million, 80},
    {"sphere", [](std::size_t n) { return generated("sphere", n); }, million, 80},
    {"cospherical",
     [](std::size_t n) {
         return integer_sphere(n, n <= 4000 ? 231 : n <= 77000 ? 4389 : 100947);
     },
     million, 80},
    {"repeats", [](std::size_t n) { return generated("lattice-repeats", n); }, million, 80},
    {"layers", layers, million, 80},
    {"helix", helix, million, 80},
    {"anisotropic", [](std::size_t n) { return generated("anisotropic", n); }, million, 80},
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
    const double n = static_cast<double>(xyz.size() / 3);
    return {stat(MGDT_STAT_WALK_STEPS) / n,
            stat(MGDT_STAT_TETRAHEDRA_REMOVED) / n,
            stat(MGDT_STAT_TETRAHEDRA_CREATED) / n,
            stat(MGDT_STAT_EXACT_CALLS) / n,
            stat(MGDT_STAT_ORDER_SECONDS) + stat(MGDT_STAT_INSERT_SECONDS),
            mgdt_vertex_count(t)};
}

std::vector<std::size_t> sizes() {
    if (is_long) return {10000, 100000, million};
    if (property::small()) return {500, 1000};
    return {2000, 16000};
}

class CostOfAPoint : public testing::TestWithParam<Kind> {};

TEST_P(CostOfAPoint, DoesNotGrow) {
    const Kind& kind = GetParam();
    std::vector<Cost> costs;
    for (const std::size_t n : sizes()) {
        const Cost c = cost_of(kind.points(std::min(n, kind.most)));
        std::printf(
            "%-12s %8zu points, %8lld vertices: visited %6.1f removed %6.1f created %6.1f "
            "exact %6.2f, %6.2f us a point\n",
            kind.name, n, static_cast<long long>(c.vertices), c.visited, c.removed, c.created,
            c.exact, 1e6 * c.seconds / static_cast<double>(n));
        EXPECT_LE(c.exact, kind.exact);
        costs.push_back(c);
    }
    // Half as much again is what the share of points near the hull explains.
    for (std::size_t k = 1; k < costs.size(); ++k) {
        EXPECT_LE(costs[k].visited, 1.5 * costs[k - 1].visited + 1);
        EXPECT_LE(costs[k].removed, 1.5 * costs[k - 1].removed + 1);
        EXPECT_LE(costs[k].created, 1.5 * costs[k - 1].created + 1);
        EXPECT_LE(costs[k].exact, 1.5 * costs[k - 1].exact + 1);
        if (is_long) {
            EXPECT_LE(costs[k].seconds, 20 * costs[k - 1].seconds);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, CostOfAPoint, testing::ValuesIn(kinds),
                         [](const auto& info) { return info.param.name; });

// A million points of a lattice, or on one sphere, within three times the time of random ones.
TEST(Time, OfDegenerateSets) {
    if (!is_long) return;
    const double usual = cost_of(kinds[0].points(million)).seconds;
    for (const std::size_t kind : {std::size_t{1}, std::size_t{3}}) {
        const double seconds = cost_of(kinds[kind].points(million)).seconds;
        std::printf("%s: %.2f times the time of uniform points\n", kinds[kind].name,
                    seconds / usual);
        EXPECT_LE(seconds, 3 * usual) << kinds[kind].name;
    }
}

}  // namespace
}  // namespace faults

int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    faults::is_long = argc > 1 && std::string(argv[1]) == "--long";
    return RUN_ALL_TESTS();
}
