// SPDX-License-Identifier: MIT
// The largest and smallest coordinates and mixtures of them, the most degenerate sets, more points
// than there is memory for, and counts at the ends of their types.
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <string>

#include "../property/handle.hpp"
#include "degenerate_sets.hpp"

namespace faults {
namespace {

using property::create;
using property::Handle;

std::int64_t count(const Points& xyz) {
    return static_cast<std::int64_t>(xyz.size() / 3);
}

mgdt_status insert(const Handle& t, const Points& xyz) {
    return mgdt_insert_points(t.get(), count(xyz), xyz.data());
}

// The canonical tetrahedra as places in `order`, of points given in that order.
property::Keys tetrahedra_of(const Handle& t, const std::vector<std::size_t>& order,
                             const std::vector<std::int64_t>& names) {
    std::vector<std::int64_t> all = property::tetrahedra(t.get());
    for (std::int64_t& v : all) v = names[order[static_cast<std::size_t>(v)]];
    return property::keys(all);
}

struct Extreme {
    const char* name;
    Points (*points)(std::size_t n);
    std::size_t n, n_small;
    int dimension;
};

const Extreme extremes[] = {
    {"AnyDoubles", any_doubles, 300, 60, 3},
    {"SpreadOf600", [](std::size_t n) { return exponent_spread(n, 600, false); }, 300, 60, 3},
    {"SpreadOf2000", [](std::size_t n) { return exponent_spread(n, 2000, false); }, 300, 60, 3},
    {"PowersOfTwo", [](std::size_t n) { return exponent_spread(n, 600, true); }, 300, 60, 3},
    {"EndsOfRange", ends_of_range, 300, 60, 3},
    {"SubnormalsAndUnits", subnormals_and_units, 600, 100, 3},
    {"TwoClusters1e300Apart", [](std::size_t n) { return two_clusters(n, 1e300); }, 400, 60, 3},
    {"TwoClusters1e15Apart", [](std::size_t n) { return two_clusters(n, 1e15); }, 2000, 200, 3},
    {"Cospherical", [](std::size_t n) { return integer_sphere(n, 231); }, 4000, 200, 3},
    {"Layers", layers, 3000, 200, 3},
    {"Helix", helix, 3000, 200, 3},
    {"MomentCurve", moment_curve, 300, 60, 3},
    {"AllEqual", [](std::size_t n) { return Points(3 * n, 0.1); }, 100000, 1000, 0},
    {"AllZeros",
     [](std::size_t n) {
         Points xyz(3 * n, 0.0);
         for (std::size_t i = 0; i < xyz.size(); i += 2) xyz[i] = -0.0;
         return xyz;
     },
     1000, 100, 0},
};

class Extremes : public testing::TestWithParam<Extreme> {};

// Valid, and the same in whatever order and batches the points come.
TEST_P(Extremes, AreTriangulated) {
    const Extreme& e = GetParam();
    const Points xyz = e.points(is_small() ? e.n_small : e.n);
    const Handle one = create();
    ASSERT_EQ(insert(one, xyz), MGDT_OK) << property::error_of(one.get());
    EXPECT_EQ(mgdt_dimension(one.get()), e.dimension);
    EXPECT_EQ(mgdt_check(one.get(), MGDT_CHECK_CANONICAL), MGDT_OK)
        << property::error_of(one.get());
    const std::vector<std::int64_t> names = property::point_map(one.get());
    for (const std::int64_t v : names) ASSERT_GE(v, 0);
    std::vector<std::size_t> order(names.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const property::Keys expected = tetrahedra_of(one, order, names);
    EXPECT_EQ(expected.empty(), e.dimension < 3);

    Random random(9);
    std::shuffle(order.begin(), order.end(), random);
    Points shuffled;
    for (const std::size_t i : order)
        shuffled.insert(shuffled.end(), xyz.begin() + static_cast<std::ptrdiff_t>(3 * i),
                        xyz.begin() + static_cast<std::ptrdiff_t>(3 * i + 3));
    const Handle batches = create();
    ASSERT_EQ(mgdt_set_threads(batches.get(), 2), MGDT_OK);
    ASSERT_EQ(property::insert(batches.get(), shuffled, property::equal_batches(order.size(), 5)),
              MGDT_OK)
        << property::error_of(batches.get());
    EXPECT_EQ(mgdt_check(batches.get(), MGDT_CHECK_CANONICAL), MGDT_OK)
        << property::error_of(batches.get());
    EXPECT_EQ(tetrahedra_of(batches, order, names), expected);

    // Each point is where it is: located in a tetrahedron that has it, its nearest vertex itself.
    for (std::size_t i = 0; i < names.size(); i += 1 + names.size() / 40) {
        std::int64_t found = -2;
        ASSERT_EQ(mgdt_nearest_vertex(one.get(), &xyz[3 * i], &found), MGDT_OK);
        EXPECT_EQ(found, names[i]);
        ASSERT_EQ(mgdt_locate(one.get(), &xyz[3 * i], &found), MGDT_OK);
        EXPECT_EQ(found >= 0, e.dimension == 3);
    }
}

INSTANTIATE_TEST_SUITE_P(Sets, Extremes, testing::ValuesIn(extremes),
                         [](const auto& info) { return info.param.name; });

// A set whose triangulation is quadratic, with room for a linear one.
TEST(MemoryLimit, OfTheMomentCurve) {
    const Points xyz = moment_curve(is_small() ? 600 : 3000);
    const Handle t = create();
    ASSERT_EQ(mgdt_set_memory_limit(t.get(), 4 << 20), MGDT_OK);
    ASSERT_EQ(insert(t, xyz), MGDT_ERR_OUT_OF_MEMORY);
    double held = 0;
    ASSERT_EQ(mgdt_get_stat(t.get(), MGDT_STAT_PEAK_MEMORY_BYTES, &held), MGDT_OK);
    EXPECT_LE(held, 4 << 20);
    const std::int64_t in = mgdt_vertex_count(t.get());
    EXPECT_GT(in, 50);
    EXPECT_LT(in, count(xyz));
    ASSERT_EQ(mgdt_set_memory_limit(t.get(), 0), MGDT_OK);
    EXPECT_EQ(mgdt_check(t.get(), MGDT_CHECK_CANONICAL), MGDT_OK) << property::error_of(t.get());
    // All of a shorter curve, after it: the handle works on.
    ASSERT_EQ(mgdt_clear(t.get()), MGDT_OK);
    ASSERT_EQ(insert(t, moment_curve(300)), MGDT_OK);
    // Every two points that do not follow one another share an edge with others: quadratic.
    EXPECT_GT(mgdt_tetrahedron_count(t.get()), 300 * 300 / 3);
    EXPECT_EQ(mgdt_check(t.get(), MGDT_CHECK_CANONICAL), MGDT_OK);
}

// ------------------------------------------------------------------------- more than memory holds

std::size_t address_space_now() {
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

// Runs `body` in a process that may take `room` bytes more than it has; whether it returned true.
template <class Body>
bool with_room(std::size_t room, Body body) {
    const pid_t child = fork();
    if (child == 0) {
        const rlim_t limit = address_space_now() + room;
        const rlimit limits = {limit, limit};
        const bool good = setrlimit(RLIMIT_AS, &limits) == 0 && body();
        std::fflush(stdout);
        std::fflush(stderr);
        _exit(good ? 0 : 1);
    }
    int status = -1;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

// What a process without memory can still say of a handle.
bool is_refused(const Handle& t, mgdt_status status, std::int64_t points) {
    bool good = status == MGDT_ERR_OUT_OF_MEMORY;
    good = good && (mgdt_point_count(t.get()) == 0 || mgdt_point_count(t.get()) == points);
    good = good && mgdt_check(t.get(), MGDT_CHECK_CANONICAL) == MGDT_OK;
    good = good && mgdt_clear(t.get()) == MGDT_OK;
    good = good && insert(t, moment_curve(50)) == MGDT_OK;
    good = good && mgdt_check(t.get(), MGDT_CHECK_CANONICAL) == MGDT_OK;
    if (!good)
        std::fprintf(stderr, "status %d, %lld points: %s\n", static_cast<int>(status),
                     static_cast<long long>(mgdt_point_count(t.get())),
                     property::error_of(t.get()).c_str());
    return good;
}

constexpr std::size_t hundred_million = 100000000;

// A hundred million times one point, by a stride of 0: no memory of the caller's.
TEST(ShortOfMemory, OnePointAHundredMillionTimes) {
    const std::size_t n = is_small() ? hundred_million / 20 : hundred_million;
    const double p[3] = {1, 2, 3};
    EXPECT_TRUE(with_room(n * 4, [&] {
        const Handle t = create();
        const mgdt_status status =
            mgdt_insert_points_strided(t.get(), static_cast<std::int64_t>(n), p, p + 1, p + 2, 0);
        return is_refused(t, status, static_cast<std::int64_t>(n));
    }));
}

// Points that span space, nearly all of them zeros that take no memory.
TEST(ShortOfMemory, AHundredMillionPoints) {
    const std::size_t n = is_small() ? hundred_million / 20 : hundred_million;
    void* const p = mmap(nullptr, 3 * n * sizeof(double), PROT_READ | PROT_WRITE,
                         MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    ASSERT_NE(p, MAP_FAILED);
    double* const xyz = static_cast<double*>(p);
    for (std::size_t k = 0; k < 3; ++k) xyz[3 * (n / 2 + k) + k] = 1;
    for (const std::size_t room : {n * 2, n * 6, n * 20})
        EXPECT_TRUE(with_room(room, [&] {
            const Handle t = create();
            const mgdt_status status =
                mgdt_insert_points(t.get(), static_cast<std::int64_t>(n), xyz);
            return is_refused(t, status, static_cast<std::int64_t>(n));
        })) << room;
    munmap(p, 3 * n * sizeof(double));
}

TEST(ShortOfMemory, Reserve) {
    for (const std::int64_t n :
         {std::int64_t{100000000}, std::int64_t{1} << 31, (std::int64_t{1} << 32) - 2})
        EXPECT_TRUE(with_room(std::size_t{1} << 28, [&] {
            const Handle t = create();
            return is_refused(t, mgdt_reserve(t.get(), n), 0);
        })) << n;
}

// ----------------------------------------------------------------------------- ends of the types

constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();

TEST(Counts, AtTheEndsOfTheirTypes) {
    const Handle t = create();
    const double xyz[15] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
    ASSERT_EQ(mgdt_insert_points(t.get(), 5, xyz), MGDT_OK);
    std::int64_t found[5] = {-7, -7, -7, -7, -7};
    std::int32_t found32[5] = {-7, -7, -7, -7, -7};
    for (const std::int64_t n :
         {std::int64_t{-1}, -(std::int64_t{1} << 31), -(std::int64_t{1} << 32), least + 1, least}) {
        EXPECT_EQ(mgdt_insert_points(t.get(), n, xyz), MGDT_ERR_INVALID_ARGUMENT);
        EXPECT_EQ(mgdt_insert_points_strided(t.get(), n, xyz, xyz, xyz, 3),
                  MGDT_ERR_INVALID_ARGUMENT);
        EXPECT_EQ(mgdt_reserve(t.get(), n), MGDT_ERR_INVALID_ARGUMENT);
        EXPECT_EQ(mgdt_set_memory_limit(t.get(), n), MGDT_ERR_INVALID_ARGUMENT);
        EXPECT_EQ(mgdt_locate_points(t.get(), n, xyz, found, nullptr), MGDT_ERR_INVALID_ARGUMENT);
        EXPECT_EQ(mgdt_locate_points_i32(t.get(), n, xyz, found32, nullptr),
                  MGDT_ERR_INVALID_ARGUMENT);
    }
    // Five points are in: the last number of points is 2^32 - 2.
    for (const std::int64_t n :
         {(std::int64_t{1} << 32) - 6, (std::int64_t{1} << 32) - 1, std::int64_t{1} << 32,
          (std::int64_t{1} << 32) + 1, most / 24, most / 24 + 1, most / 8, most / 3, most}) {
        EXPECT_EQ(mgdt_insert_points(t.get(), n, xyz), MGDT_ERR_TOO_LARGE) << n;
        EXPECT_EQ(mgdt_insert_points_strided(t.get(), n, xyz, xyz, xyz, 0), MGDT_ERR_TOO_LARGE);
        EXPECT_EQ(mgdt_insert_points_strided(t.get(), n, xyz, xyz, xyz, most), MGDT_ERR_TOO_LARGE);
    }
    for (const std::int64_t n :
         {(std::int64_t{1} << 32) - 1, std::int64_t{1} << 32, most / 64, most})
        EXPECT_EQ(mgdt_reserve(t.get(), n), MGDT_ERR_TOO_LARGE) << n;
    // No memory holds the results of so many.
    for (const std::int64_t n : {most / 32 + 1, most / 24 + 1, most / 8, most / 4 + 1, most}) {
        EXPECT_EQ(mgdt_locate_points(t.get(), n, xyz, found, nullptr), MGDT_ERR_INVALID_ARGUMENT);
        EXPECT_EQ(mgdt_locate_points_i32(t.get(), n, xyz, found32, nullptr),
                  MGDT_ERR_INVALID_ARGUMENT);
    }
    for (const std::int64_t n : found) EXPECT_EQ(n, -7);
    for (const std::int32_t n : found32) EXPECT_EQ(n, -7);
    EXPECT_EQ(mgdt_point_count(t.get()), 5);
    EXPECT_EQ(mgdt_check(t.get(), MGDT_CHECK_CANONICAL), MGDT_OK);
}

// Strides that would take the last point where no address is; one point has no second.
TEST(Counts, Strides) {
    const Handle t = create();
    const double xyz[3] = {1, 2, 3};
    for (const std::int64_t stride : {most, least, least + 1, most / 8 + 1, -(most / 8) - 1}) {
        EXPECT_EQ(mgdt_insert_points_strided(t.get(), 2, xyz, xyz + 1, xyz + 2, stride),
                  MGDT_ERR_INVALID_ARGUMENT);
        EXPECT_NE(property::error_of(t.get()).find("stride"), std::string::npos);
        EXPECT_EQ(mgdt_insert_points_strided(t.get(), 1, xyz, xyz + 1, xyz + 2, stride), MGDT_OK);
        EXPECT_EQ(mgdt_insert_points_strided(t.get(), 0, xyz, xyz + 1, xyz + 2, stride), MGDT_OK);
    }
    for (const std::int64_t stride : {most / 8, -(most / 8)})
        EXPECT_EQ(mgdt_insert_points_strided(t.get(), 3, xyz, xyz + 1, xyz + 2, stride),
                  MGDT_ERR_INVALID_ARGUMENT);
    EXPECT_EQ(mgdt_point_count(t.get()), 5);
    EXPECT_EQ(mgdt_vertex_count(t.get()), 1);
}

}  // namespace
}  // namespace faults
