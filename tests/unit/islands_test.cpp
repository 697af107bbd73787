// SPDX-License-Identifier: MIT
// Powers, spheres and words of each island against those of the scalar one: bit for bit where they
// move words, within the proved bounds where they compute, on random, extreme, subnormal and
// near-tie operands. Marks and ties have files of their own. With --benchmark: what each routine
// takes.
#include "islands.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <functional>

#include "kernel/circumsphere.hpp"
#include "mesh/mesh.hpp"
#include "point_families.hpp"
#include "predicates/predicates.hpp"

namespace islands {

// GoogleTest would print its bytes.
void PrintTo(const Island& island, std::ostream* out) {
    *out << island.name;
}

std::vector<Island> all() {
    std::vector<Island> islands = {scalar()};
#if defined(HAVE_ISLAND_avx2)
    islands.push_back(avx2());
    islands.push_back(avx512());
#elif defined(HAVE_ISLAND_neon)
    islands.push_back(neon());
#endif
#if defined(HAVE_ISLAND_avx2) || defined(HAVE_ISLAND_neon)
    for (std::size_t i = 1; i < islands.size(); ++i) islands[i].decided_modulo = decided_modulo;
#endif
    return islands;
}

namespace {

using namespace mgdt;
using families::Random;

// Points and tetrahedra of them, the first of which is the query's place.
struct Scene {
    explicit Scene(Allocator& allocator) : mesh(allocator) { mesh.clear(); }

    VertexId add(const double* x) {
        Vertex v = {};
        std::copy(x, x + 3, v.x);
        v.index = 0xFFFFFFFFu;  // as a double not a number
        v.moved_to = 0xFFFFFFFFu;
        mesh.has_extremes = mesh.has_extremes || !in_normal_range(x);
        mesh.vertices.push_back(v);
        return static_cast<VertexId>(mesh.vertices.size() - 1);
    }
    // A tetrahedron, or a ghost if one vertex is infinite; with its sphere.
    void add(VertexId a, VertexId b, VertexId c, VertexId d) {
        const std::size_t t = mesh.tetrahedra.size();
        mesh.tetrahedra.resize(t + 1);
        mesh.tetrahedra[t] = {{a, b, c, d}, {}};
        mesh.tetrahedra.sphere(t) = rounded(circumsphere(mesh.tetrahedra[t], mesh.vertices.data()));
    }
    Mesh mesh;
};

// Coordinates of many kinds: whether the filters are proved for them, or not.
double coordinate(Random& random, int kind) {
    switch (kind) {
        case 0:
            return random.uniform(-1, 1);
        case 1:
            return random.integer(-3, 3);
        case 2:
            return random.with_exponent(-140, 140);
        case 3:
            return random.with_exponent(-1074, -1010);
        case 4:
            return random.with_exponent(-500, 500);
        default:
            return 1 + random.integer(-4, 4) * 0x1p-50;
    }
}
constexpr int kinds = 6;
bool is_normal(int kind) {
    return kind != 3 && kind != 4;
}

bool make_four(Scene& scene, Random& random, int kind, double* q) {
    for (int k = 0; k < 3; ++k) q[k] = coordinate(random, kind);
    for (unsigned t = 0; t < 4; ++t) {
        VertexId v[4];
        for (VertexId& id : v) {
            double x[3];
            for (double& c : x) c = coordinate(random, kind);
            id = scene.add(x);
        }
        const auto at = [&](unsigned i) { return scene.mesh.point(v[i]); };
        const int o = orientation(at(0), at(1), at(2), at(3));
        if (o == 0) return false;
        if (o < 0) std::swap(v[2], v[3]);
        const int ghost = random.integer(0, 3);
        if (ghost >= 2) v[ghost] = infinite_vertex;
        scene.add(v[0], v[1], v[2], v[3]);
    }
    return true;
}

class Islands : public testing::TestWithParam<Island> {
  protected:
    void SetUp() override {
        if (!GetParam().runs()) GTEST_SKIP() << "not on this processor";
    }
    const Island island_ = GetParam(), scalar_ = scalar();
};

// What one island gives is true to itself, and two give the same number within both their bounds.
void compare(const Powers& got, const Powers& expected, const Asked& asked) {
    EXPECT_EQ(got.ghosts, expected.ghosts);
    unsigned least = 4;
    double bound = asked.bound;
    for (unsigned k = 0; k < 4; ++k) {
        const double value = got.value[k], error = got.error[k];
        const bool is_decided = std::fabs(value) > error, is_ghost = got.ghosts >> k & 1;
        EXPECT_EQ((got.decided >> k & 1) != 0, is_decided);
        if (is_decided) {
            EXPECT_EQ((got.negative >> k & 1) != 0, value < 0);
        }
        const double floor = is_ghost ? 0 : asked.value + asked.error;
        EXPECT_EQ((got.above >> k & 1) != 0, value - floor > error);
        if (!is_ghost && value < bound) {
            bound = value;
            least = k;
        }
        if (std::isfinite(error) && std::isfinite(expected.error[k])) {
            EXPECT_LE(std::fabs(value - expected.value[k]), error + expected.error[k]);
            EXPECT_LE(error, 2 * expected.error[k] + 0x1p-1000);
            EXPECT_LE(expected.error[k], 2 * error + 0x1p-1000);
        }
    }
    // Where some power is no number, as of points outside the normal range, there may be no least.
    const bool are_numbers =
        std::none_of(got.value, got.value + 4, [](double x) { return x != x; });
    if (are_numbers || got.least_finite != 4) {
        EXPECT_EQ(got.least_finite, least);
    }
}

TEST_P(Islands, Powers) {
    Random random(31);
    int decided = 0, asked_of = 0;
    for (int i = 0; i < reference::cases(6000); ++i) {
        Allocator allocator;
        Scene scene(allocator);
        double q[3];
        if (!make_four(scene, random, i % kinds, q)) continue;
        alignas(16) FacetCode codes[4];
        for (unsigned k = 0; k < 4; ++k)
            codes[k] = facet_code((k + static_cast<unsigned>(i)) % 4,
                                  static_cast<unsigned>(random.integer(0, 3)));
        const Asked asked = {random.uniform(-1, 1), random.uniform(), random.uniform(-1, 1)};
        const auto look = [&](auto routine, Powers& got, Powers& expected) {
            (island_.*routine)(scene.mesh, codes, q, asked, got);
            (scalar_.*routine)(scene.mesh, codes, q, asked, expected);
            compare(got, expected, asked);
            compare(expected, expected, asked);
        };
        Powers got, expected;
        look(&Island::powers, got, expected);
        // A power that is decided has the sign of the exact one.
        for (unsigned k = 0; k < 4; ++k) {
            const Tetrahedron& t = scene.mesh.tetrahedra[tetrahedron_of(codes[k])];
            if (t.is_ghost() || !(got.decided >> k & 1)) continue;
            const auto at = [&](unsigned v) { return scene.mesh.point(t.v[v]); };
            EXPECT_EQ(side_of_sphere(at(0), at(1), at(2), at(3), q),
                      got.negative >> k & 1 ? 1 : -1);
            ++decided;
        }
        asked_of += 4;
        scene.mesh.tetrahedra.drop_spheres();
        look(&Island::powers_computed, got, expected);
    }
    EXPECT_GT(decided, asked_of / 8);
}

// Stars of all sizes: facets of random triples of their vertices, some at the hull.
TEST_P(Islands, Spheres) {
    Random random(32);
    int sound = 0, hulls = 0, facets = 0;
    for (int i = 0; i < reference::cases(3000); ++i) {
        const auto count = static_cast<std::uint32_t>(random.integer(4, i % 10 == 0 ? 300 : 32));
        const std::size_t size = 2 * std::size_t{count} - 4;
        const bool at_hull = random.integer(0, 1) != 0;
        Allocator allocator;
        Scene scene(allocator);
        Workspace w(allocator);
        w.grow_star(size, size);
        double x[3];
        const int kind = i % kinds;
        const auto vertex = [&] {
            for (double& c : x) c = coordinate(random, kind);
            return scene.add(x);
        };
        const VertexId q = vertex();
        for (std::uint32_t k = 0; k < count; ++k) w.ids.data[k] = vertex();
        const std::uint32_t infinite = at_hull ? count / 2 : no_index;
        if (at_hull) w.ids.data[infinite] = infinite_vertex;
        w.boundary_size = size;
        for (std::size_t k = 0; k < size; ++k) {
            std::uint32_t v[3];
            for (std::uint32_t& n : v)
                n = static_cast<std::uint32_t>(random.integer(0, static_cast<int>(count) - 1));
            if (v[0] == infinite) v[0] = (v[0] + 1) % count;  // never the first of a facet
            w.a.data[k] = v[0];
            w.b.data[k] = v[1];
            w.c.data[k] = v[2] == infinite && v[1] == infinite ? v[0] : v[2];
            if (size <= 60) {
                w.small.a[k] = static_cast<std::uint8_t>(w.a.data[k]);
                w.small.b[k] = static_cast<std::uint8_t>(w.b.data[k]);
                w.small.c[k] = static_cast<std::uint8_t>(w.c.data[k]);
            }
            w.slots.data[k] = first_facet(static_cast<TetId>(size - 1 - k));
        }
        const bool is_small = size <= 60 && random.integer(0, 3) != 0;
        TetrahedronStore stores[2] = {TetrahedronStore(allocator), TetrahedronStore(allocator)};
        for (unsigned s = 0; s < 2; ++s) {
            stores[s].resize(size);
            std::memset(&stores[s].sphere(0), 0, size * sizeof(TetrahedronAndSphere));
            const Island& island = s == 0 ? island_ : scalar_;
            (is_small ? island.spheres_small : island.spheres)(w, scene.mesh.vertices.data(), q,
                                                               count, infinite, stores[s]);
        }
        // Elsewhere the star takes none of them: distrust_extremes().
        for (std::size_t k = 0; k < size && is_normal(kind); ++k) {
            const TetId t = tetrahedron_of(w.slots.data[k]);
            const Sphere got = stores[0].sphere(t).in_doubles(),
                         expected = stores[1].sphere(t).in_doubles();
            EXPECT_EQ(stores[0][t].n[0], stores[1][t].n[0]);
            if (is_small) {
                EXPECT_EQ(stores[0][t].n[0], k);
            }
            const bool is_ghost = w.b.data[k] == infinite || w.c.data[k] == infinite;
            ASSERT_EQ(got.is_ghost(), is_ghost);
            ASSERT_EQ(expected.is_ghost(), is_ghost);
            ++facets;
            hulls += is_ghost;
            // A determinant near the bound is sound for one alone.
            if (!std::isfinite(got.e) || !std::isfinite(expected.e)) continue;
            ++sound;
            for (unsigned c = 0; c < 3; ++c)
                EXPECT_LE(std::fabs(got.w[c] - expected.w[c]),
                          std::fabs(got.e) + std::fabs(expected.e))
                    << "kind " << kind << ", facet " << k << " of " << size;
        }
    }
    EXPECT_GT(sound, facets / 4);
    EXPECT_GT(hulls, facets / 200);
}

TEST_P(Islands, Append) {
    alignas(16) const std::uint32_t words[4] = {0x80000001u, 7, 0xFFFFFFFFu, 9};
    for (std::uint32_t bits = 0; bits < 16; ++bits) {
        std::uint32_t to[6] = {1, 1, 1, 1, 1, 1};
        std::vector<std::uint32_t> chosen;
        for (unsigned k = 0; k < 4; ++k)
            if (bits >> k & 1) chosen.push_back(words[k]);
        ASSERT_EQ(island_.append(to + 1, words, bits), chosen.size());
        EXPECT_EQ(std::vector<std::uint32_t>(to + 1, to + 1 + chosen.size()), chosen);
        EXPECT_EQ(to[0], 1u);
        EXPECT_EQ(to[5], 1u);
    }
}

TEST_P(Islands, WriteVertices) {
    const Tetrahedron outside = {{11, 0xFFFFFFF2u, 13, 14}, {}};
    for (unsigned face = 0; face < 4; ++face) {
        Tetrahedron got = {}, expected = {};
        const VertexId* const facet =
            island_.write_vertices(outside, facet_code(77, face), 0x7FFFFFFFu, got);
        scalar_.write_vertices(outside, facet_code(77, face), 0x7FFFFFFFu, expected);
        EXPECT_EQ(std::memcmp(got.v, expected.v, sizeof got.v), 0);
        EXPECT_EQ(got.v[0], 0x7FFFFFFFu);
        for (unsigned k = 0; k < 3; ++k) {
            EXPECT_EQ(facet[k], outside.v[outer_face[face][k]]);
            EXPECT_EQ(got.v[k + 1], facet[k]);
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Each, Islands, testing::ValuesIn(all()),
                         [](const auto& info) { return std::string(info.param.name); });

// ------------------------------------------------------------------------------------- --benchmark

// Nanoseconds that one of many calls takes, the least of some rounds.
double time_of(const std::function<void()>& call) {
    using Clock = std::chrono::steady_clock;
    double least = 1e9;
    for (int round = 0; round < 7; ++round) {
        constexpr int calls = 100000;
        const Clock::time_point begin = Clock::now();
        for (int i = 0; i < calls; ++i) call();
        const std::chrono::duration<double, std::nano> elapsed = Clock::now() - begin;
        least = std::min(least, elapsed.count() / calls);
    }
    return least;
}

void benchmark() {
    Random random(33);
    Allocator allocator;
    Scene scene(allocator);
    double q[3];
    while (!make_four(scene, random, 0, q)) {
    }
    alignas(16) const FacetCode codes[4] = {0, 5, 10, 15};
    const std::uint32_t count = 15, size = 26;
    Workspace w(allocator);
    w.grow_star(64, 128);
    for (std::uint32_t k = 0; k < count; ++k) w.ids.data[k] = 1 + k;
    w.boundary_size = size;
    for (std::uint32_t k = 0; k < size; ++k) {
        w.small.a[k] = static_cast<std::uint8_t>(k % count);
        w.small.b[k] = static_cast<std::uint8_t>((k + 1) % count);
        w.small.c[k] = static_cast<std::uint8_t>((k + 3) % count);
        w.slots.data[k] = first_facet(k);
    }
    TetrahedronStore store(allocator);
    store.resize(size);
    MarkTable marks(allocator);
    std::printf("%-18s", "nanoseconds a call");
    const std::vector<Island> islands = all();
    for (const Island& island : islands) std::printf(" %10s", island.name);
    std::puts("");
    const auto row = [&](const char* name, auto call) {
        std::printf("%-18s", name);
        for (const Island& island : islands)
            island.runs() ? std::printf(" %10.1f", time_of([&] { call(island); }))
                          : std::printf(" %10s", "-");
        std::puts("");
    };
    const Vertex* const vertices = scene.mesh.vertices.data();
    Powers out;
    row("four powers", [&](const Island& i) { i.powers(scene.mesh, codes, q, {0, 0, 1}, out); });
    row("a star's spheres",
        [&](const Island& i) { i.spheres_small(w, vertices, 16, count, no_index, store); });
    row("a near tie", [&](const Island& i) {
        i.perturbed_doubles(scene.mesh.tetrahedra[0], vertices, scene.mesh.point(9));
    });
    row("four marks", [&](const Island& i) {
        marks.begin(1);
        i.put_four(marks.view(), codes, 0xF);
    });
    std::uint32_t words[8];
    row("append", [&](const Island& i) { i.append(words, codes, 5); });
    Tetrahedron made;
    row("vertices",
        [&](const Island& i) { i.write_vertices(scene.mesh.tetrahedra[0], 2, 7, made); });
}

}  // namespace
}  // namespace islands

int main(int argc, char** argv) {
    if (argc == 2 && std::strcmp(argv[1], "--benchmark") == 0) {
        islands::benchmark();
        return 0;
    }
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
