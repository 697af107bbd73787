// SPDX-License-Identifier: MIT
// Parts of the kernel by themselves, where whole insertions come seldom: stars with more vertices
// than their matrices hold, alone and among others, each kernel by its name, and what a thread
// among others has of its own.
#include "kernel/kernel.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "core/triangulation.hpp"
#include "kernel/adjacency.hpp"
#include "kernel/circumsphere.hpp"
#include "kernel/thread_state.hpp"

namespace mgdt {
namespace {

// The edges of large stars, whose facets are three to a vertex and whose vertices have few or very
// many of them, fill a table half; at random nearly four of ten would meet another one.
TEST(EdgeTables, SpreadEdges) {
    for (const std::uint32_t degree : {6u, 60u, 1000u}) {
        std::set<std::size_t> places;
        constexpr std::size_t edges = 6000, size = 16384;
        for (std::uint32_t k = 0; k < edges; ++k) {
            const std::uint32_t a = k / degree, b = a + 1 + k % degree;
            places.insert(EdgeTable::hash(a, b) & (size - 1));
        }
        EXPECT_GT(places.size(), edges * 3 / 4) << degree;
    }
}

constexpr const char* names[] = {"baseline", "avx2", "avx512", "neon"};

TEST(Kernels, AreFoundByName) {
    unsigned found = 0;
    for (const char* name : names) {
        const Kernel* const kernel = find_kernel(name);
        if (kernel == nullptr) continue;  // not on this processor
        EXPECT_STREQ(kernel->isa, name);
        EXPECT_EQ(find_kernel(kernel->isa), kernel);
        ++found;
    }
    EXPECT_NE(find_kernel("baseline"), nullptr);
    EXPECT_EQ(find_kernel("avx1024"), nullptr);
    EXPECT_EQ(find_kernel(""), nullptr);
    // The best for none: with more than one, not the baseline.
    ASSERT_NE(find_kernel(nullptr), nullptr);
    EXPECT_EQ(find_kernel(nullptr) == find_kernel("baseline"), found == 1);
}

// Nothing: there is none.
void set_environment(const char* name, const std::string& value) {
#if defined(_WIN32)
    _putenv_s(name, value.c_str());
#else
    if (value.empty())
        unsetenv(name);
    else
        setenv(name, value.c_str(), 1);
#endif
}

TEST(Kernels, DefaultIsTheOneThatIsNamed) {
    const char* const set = std::getenv("MGDT_ISA");
    const std::string before = set ? set : "";
    set_environment("MGDT_ISA", "baseline");
    EXPECT_EQ(&default_kernel(), find_kernel("baseline"));
    set_environment("MGDT_ISA", "avx1024");
    EXPECT_EQ(&default_kernel(), find_kernel(nullptr));
    set_environment("MGDT_ISA", "");
    EXPECT_EQ(&default_kernel(), find_kernel(nullptr));
    set_environment("MGDT_ISA", before);
}

using Corners = std::array<VertexId, 4>;

// Vertices of each finite tetrahedron, turned about so that they can be compared.
std::vector<Corners> tetrahedra(const Mesh& mesh) {
    std::vector<Corners> all;
    for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t) {
        const Tetrahedron& tet = mesh.tetrahedra[t];
        if (tet.is_dead() || tet.is_ghost()) continue;
        Corners v = {tet.v[0], tet.v[1], tet.v[2], tet.v[3]};
        std::sort(v.begin(), v.end());
        all.push_back(v);
    }
    std::sort(all.begin(), all.end());
    return all;
}

// Two skew lines of n points each, which make about n^2 tetrahedra, and one more vertex between
// them whose cavity has nearly all of the points.
struct SkewLines {
    SkewLines(int n, const Kernel& kernel, bool compact) : t(nullptr, nullptr, nullptr) {
        std::vector<double> xyz;
        for (int i = 0; i < n; ++i) {
            const double place = 24.0 * i / n;
            xyz.insert(xyz.end(), {place - 11.7, 0, -8, 0, place - 11.3, 8});
        }
        const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
        t.set_kernel(kernel);
        t.set_compact(compact);
        t.insert(xyz.size() / 3, axis, 3);
        q = static_cast<VertexId>(mesh().vertices.size());
        mesh().vertices.push_back({{0.013, 0.017, 0.011}, 2 * static_cast<std::uint32_t>(n), 0});
        mesh().vertex_hint.push_back(no_tetrahedron);
    }
    Mesh& mesh() { return const_cast<Mesh&>(t.mesh()); }

    Triangulation t;
    VertexId q;
};

TEST(Kernels, LargeStarsAloneAndAmongOthers) {
    constexpr int n = 140;
    static_assert(2 * n > Workspace::matrix_vertices, "larger than the matrices");
    std::vector<Corners> expected;
    for (int way = 0; way < 6; ++way) {
        const Kernel* const kernel = find_kernel(names[way / 2]);
        if (kernel == nullptr) continue;
        const bool compact = way % 2 == 1;
        SCOPED_TRACE(std::string(names[way / 2]) + (compact ? ", compact" : ""));

        SkewLines alone(n, *kernel, compact);
        Mesh& mesh = alone.mesh();
        Workspace workspace(alone.t.allocator());
        const Insertion inserted =
            alone.t.calls().insert(mesh, workspace, alone.q, mesh.live_from(0));
        ASSERT_NE(inserted.tetrahedron, no_tetrahedron);
        ASSERT_EQ(inserted.duplicate, infinite_vertex);
        ASSERT_GT(workspace.counters.removed, 4 * Workspace::matrix_vertices);
        ASSERT_GT(workspace.counters.created, 2 * Workspace::matrix_vertices);

        SkewLines together(n, *kernel, compact);
        Mesh& shared = together.mesh();
        Allocator& allocator = together.t.allocator();
        Workspace own(allocator);
        BlockOwners owners(allocator, shared.vertices.size(), nullptr);
        SlotSupply supply(shared, 64);
        supply.open();
        {
            ThreadState thread_state(shared, owners, 1, supply);
            const TetId start = shared.live_from(0);
            for (const VertexId v :
                 {together.q, shared.tetrahedra[start].v[0], shared.tetrahedra[start].v[1]}) {
                if (!thread_state.blocks.mine()(v)) {
                    ASSERT_TRUE(thread_state.blocks.try_own(v));
                }
            }
            const Insertion mine =
                together.t.calls().insert_concurrent(shared, own, thread_state, together.q, start);
            ASSERT_NE(mine.tetrahedron, no_tetrahedron);
            supply.close();
            thread_state.return_slots();
            shared.ghost_count += static_cast<std::size_t>(thread_state.ghosts);
        }
        EXPECT_EQ(own.counters.removed, workspace.counters.removed);
        EXPECT_EQ(own.counters.created, workspace.counters.created);
        const std::vector<Corners> found = tetrahedra(mesh);
        EXPECT_EQ(found.size(), mesh.finite_count());
        EXPECT_EQ(tetrahedra(shared), found);
        EXPECT_EQ(shared.finite_count(), mesh.finite_count());
        if (expected.empty()) expected = found;
        EXPECT_EQ(found, expected);
    }
    EXPECT_FALSE(expected.empty());
}

// Points about the edges of a box, so near them that between two of them and a third the bound of a
// hull facet's normal is more than what rounding it for keeps adds; and skew lines, whose stars
// have many vertices.
std::vector<std::vector<double>> thin_hulls() {
    std::uint64_t state = 7;
    const auto noise = [&] {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state >> 40) * 0x1p-24;
    };
    std::vector<std::vector<double>> sets(2);
    for (int i = 0; i < 600; ++i) {
        double x[3];
        for (double& c : x) c = noise() < 0.5 ? 0x1p-36 * noise() : 1 - 0x1p-36 * noise();
        x[i % 3] = noise();
        sets[0].insert(sets[0].end(), x, x + 3);
    }
    for (int i = 0; i < 140; ++i)
        sets[1].insert(sets[1].end(),
                       {i + noise(), 0x1p-34 * noise(), -80, 0x1p-34 * noise(), i + noise(), 80});
    return sets;
}

TEST(Kernels, NormalsOfGhostsAreWithinTheirBounds) {
    for (const char* name : names) {
        const Kernel* const kernel = find_kernel(name);
        if (kernel == nullptr) continue;
        for (const std::vector<double>& xyz : thin_hulls()) {
            SCOPED_TRACE(name);
            Triangulation t(nullptr, nullptr, nullptr);
            t.set_kernel(*kernel);
            const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
            t.insert(xyz.size() / 3, axis, 3);
            const Mesh& mesh = t.mesh();
            std::size_t thin = 0;
            for (TetId id = 0; id < mesh.tetrahedra.size(); ++id) {
                const Tetrahedron& ghost = mesh.tetrahedra[id];
                if (ghost.is_dead() || !ghost.is_ghost()) continue;
                const int slot = ghost.infinite_slot();
                const double* const base = mesh.point(ghost.v[0]);
                const double* const ends[2] = {mesh.point(ghost.v[slot % 3 + 1]),
                                               mesh.point(ghost.v[(slot + 1) % 3 + 1])};
                long double x[2][3], size[2] = {0, 0};
                for (int k = 0; k < 2; ++k)
                    for (int i = 0; i < 3; ++i) {
                        x[k][i] = static_cast<long double>(ends[k][i]) - base[i];
                        size[k] = std::max(size[k], std::fabs(x[k][i]));
                    }
                const long double unit = unit_roundoff * size[0] * size[1];
                const Sphere s = mesh.tetrahedra.sphere(id).in_doubles();
                long double largest = 0, off = 0;
                for (int i = 0; i < 3; ++i) {
                    const int j = (i + 1) % 3, k = (i + 2) % 3;
                    const long double n = x[0][j] * x[1][k] - x[0][k] * x[1][j];
                    largest = std::max(largest, std::fabs(n));
                    off = std::max(off, std::fabs(n - s.w[i]));
                }
                ASSERT_TRUE(s.is_ghost());
                // In docs/theory.md, "Ghosts": 8 units for the normal, as many for its power.
                ASSERT_LE(off, 8 * unit + 0x1p-21L * largest) << id;
                ASSERT_GE(-s.e, 16 * unit + 0x1p-21L * largest) << id;
                ASSERT_LE(-s.e, 41 * unit + 0x1.001p-21L * largest) << id;
                thin += 16 * unit > 0x1p-21L * largest;
            }
            EXPECT_GT(thin, 20u);
        }
    }
}

// Slots that are free in the mesh are taken before fresh ones, no slot twice, and what is left goes
// back.
TEST(ThreadState, TakesFreeSlotsFirst) {
    Allocator allocator;
    Mesh mesh(allocator);
    constexpr std::size_t used = 100, freed = 50, capacity = 300;
    mesh.tetrahedra.reserve(capacity);
    mesh.tetrahedra.resize(used);
    for (TetId t = 0; t < used; ++t) mesh.tetrahedra[t] = Tetrahedron{};
    mesh.reserve_slots(0, freed);
    for (TetId t = 0; t < freed; ++t) mesh.free_slot(2 * t);
    BlockOwners owners(allocator, 1, nullptr);
    SlotSupply supply(mesh, 64);
    supply.open();
    std::set<TetId> taken;
    {
        ThreadState thread_state(mesh, owners, 1, supply);
        const auto take = [&](std::size_t count) {
            std::vector<FacetCode> slots(count + 16);
            thread_state.reserve_slots(count, 0);
            thread_state.take_slots(slots.data(), count);
            for (std::size_t i = 0; i < count; ++i) taken.insert(slots[i] >> 2);
        };
        take(10);
        EXPECT_EQ(taken.size(), 10u);
        for (const TetId t : taken) EXPECT_TRUE(t < used && t % 2 == 0) << t;
        EXPECT_EQ(mesh.free_slots.size(), 0u);
        thread_state.reserve_slots(0, 5000);  // many to be listed, none to be taken
        take(60);
        EXPECT_EQ(taken.size(), 70u);
        EXPECT_LT(*taken.rbegin(), capacity);
        for (const TetId t : taken) EXPECT_TRUE(t >= used || t % 2 == 0) << t;
        take(100);
        EXPECT_EQ(taken.size(), 170u);
        EXPECT_THROW(thread_state.reserve_slots(capacity, 0), SlotSupply::NoSlots);
        supply.close();
        thread_state.return_slots();
    }
    EXPECT_EQ(mesh.live_count(), used - freed + taken.size());
    for (const TetId t : mesh.free_slots) EXPECT_EQ(taken.count(t), 0u) << t;
}

}  // namespace
}  // namespace mgdt
