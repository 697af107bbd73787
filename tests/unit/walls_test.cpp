// SPDX-License-Identifier: MIT
// The kernel in a mesh with walls: cavities end at them, and stars fill cavities as an insertion
// does.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <set>
#include <vector>

#include "core/triangulation.hpp"
#include "kernel/circumsphere.hpp"
#include "kernel/thread_state.hpp"

namespace mgdt {
namespace {

constexpr const char* names[] = {"baseline", "avx2", "avx512", "neon"};

class Random {
  public:
    explicit Random(std::uint64_t seed) : state_(seed) {}
    double next() {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state_ >> 40) * 0x1p-24;
    }
    // A point in the unit cube, or one of a coarse lattice in it, where cospherical points abound.
    std::array<double, 3> point(bool is_on_lattice) {
        std::array<double, 3> x;
        for (double& c : x) c = is_on_lattice ? static_cast<int>(9 * next()) * 0.125 : next();
        return x;
    }

  private:
    std::uint64_t state_;
};

std::vector<double> random_points(std::size_t n, bool are_on_lattice) {
    Random random(11);
    std::vector<double> xyz;
    for (std::size_t i = 0; i < n; ++i)
        for (const double c : random.point(are_on_lattice)) xyz.push_back(c);
    return xyz;
}

// Points on two skew lines through the unit cube, between which cavities have many more tetrahedra
// than stars.
std::vector<double> skew_lines(int n) {
    std::vector<double> xyz;
    for (int i = 0; i < n; ++i) {
        const double place = (i + 0.5) / n;
        xyz.insert(xyz.end(), {place, 0.5, 0.1, 0.5, place, 0.9});
    }
    return xyz;
}

struct Triangulated {
    Triangulated(const Kernel& kernel, const std::vector<double>& xyz)
        : t(nullptr, nullptr, nullptr) {
        t.set_kernel(kernel);
        const double* const axis[3] = {xyz.data(), xyz.data() + 1, xyz.data() + 2};
        t.insert(xyz.size() / 3, axis, 3);
    }
    Mesh& mesh() { return const_cast<Mesh&>(t.mesh()); }
    // A tetrahedron in conflict with q, or no_tetrahedron if q is a vertex.
    TetId in_conflict(const double* q) {
        TetId found = no_tetrahedron;
        for (TetId id = 0; id < mesh().tetrahedra.size(); ++id) {
            const Tetrahedron& tet = mesh().tetrahedra[id];
            if (tet.is_dead()) continue;
            if (vertex_at(mesh(), tet, q) != infinite_vertex) return no_tetrahedron;
            if (found == no_tetrahedron && !tet.is_ghost() && is_conflict_exact(mesh(), tet, q))
                found = id;
        }
        return found;
    }
    Triangulation t;
};

// Calls test(kernel, is_on_lattice) for each kernel of this processor and both kinds of points.
template <class Test>
void for_each_kernel(const Test& test) {
    for (const char* name : names)
        for (const bool is_on_lattice : {false, true}) {
            const Kernel* const kernel = find_kernel(name);
            if (kernel == nullptr) continue;
            SCOPED_TRACE(name);
            test(*kernel, is_on_lattice);
        }
}

TEST(Walls, EndCavities) {
    for_each_kernel([](const Kernel& kernel, bool is_on_lattice) {
        Triangulated made(kernel, random_points(300, is_on_lattice));
        const Mesh& mesh = made.mesh();
        Random random(12);
        std::vector<std::uint8_t> walls(mesh.tetrahedra.size(), 0);
        for (TetId id = 0; id < mesh.tetrahedra.size(); ++id)
            for (unsigned i = 0; i < 4 && !mesh.tetrahedra[id].is_dead(); ++i) {
                if (random.next() > 0.15) continue;
                const FacetCode beyond = mesh.tetrahedra[id].n[i];
                walls[id] = static_cast<std::uint8_t>(walls[id] | 1u << i);
                std::uint8_t& other = walls[tetrahedron_of(beyond)];
                other = static_cast<std::uint8_t>(other | 1u << face_of(beyond));
            }
        Workspace workspace(made.t.allocator());
        MarkTable marks(made.t.allocator());
        std::size_t shorter = 0;
        for (int i = 0; i < 60; ++i) {
            const std::array<double, 3> q = random.point(is_on_lattice && i % 2 == 0);
            const TetId start = made.in_conflict(q.data());
            if (start == no_tetrahedron) continue;
            std::set<TetId> expected = {start};
            std::multiset<FacetCode> boundary;
            std::vector<TetId> next = {start};
            while (!next.empty()) {
                const TetId id = next.back();
                next.pop_back();
                for (unsigned k = 0; k < 4; ++k) {
                    const FacetCode beyond = mesh.tetrahedra[id].n[k];
                    const TetId other = tetrahedron_of(beyond);
                    if ((walls[id] >> k & 1) != 0 ||
                        !is_conflict_exact(mesh, mesh.tetrahedra[other], q.data()))
                        boundary.insert(beyond);
                    else if (expected.insert(other).second)
                        next.push_back(other);
                }
            }
            Mesh& changed = made.mesh();
            ASSERT_TRUE(
                made.t.calls().dig_walled(changed, workspace, walls.data(), q.data(), start));
            std::set<TetId> members;
            for (std::size_t k = 0; k < workspace.cavity_size; ++k)
                members.insert(tetrahedron_of(workspace.cavity.data[k]));
            EXPECT_EQ(members.size(), workspace.cavity_size);
            EXPECT_EQ(members, expected);
            EXPECT_EQ(std::multiset<FacetCode>(workspace.boundary.data,
                                               workspace.boundary.data + workspace.boundary_size),
                      boundary);
            std::set<TetId> marked;
            for (TetId id = 0; id < mesh.tetrahedra.size(); ++id)
                if (mesh.tetrahedra[id].is_in_cavity()) marked.insert(id);
            EXPECT_EQ(marked, members);
            workspace.restore_cavity(changed.tetrahedra, workspace.cavity_size);
            made.t.calls().find_cavity(mesh, workspace, marks, q.data(), start);
            shorter += workspace.cavity_size > members.size();
        }
        EXPECT_GT(shorter, 20u);
    });
}

using Corners = std::array<VertexId, 4>;

std::set<Corners> live_tetrahedra(const Mesh& mesh) {
    std::set<Corners> all;
    for (TetId t = 0; t < mesh.tetrahedra.size(); ++t) {
        const Tetrahedron& tet = mesh.tetrahedra[t];
        if (tet.is_dead()) continue;
        Corners v = {tet.v[0], tet.v[1], tet.v[2], tet.v[3]};
        std::sort(v.begin(), v.end());
        all.insert(v);
    }
    return all;
}

// A cavity that would have a closed tetrahedron is given up, and one that ends there is not.
TEST(Walls, ClosedTetrahedraStay) {
    for_each_kernel([](const Kernel& kernel, bool is_on_lattice) {
        Triangulated made(kernel, random_points(300, is_on_lattice));
        Mesh& mesh = made.mesh();
        const std::vector<std::uint8_t> walls(mesh.tetrahedra.size(), 0);
        std::set<TetId> closed;
        for (TetId id = 0; id < mesh.tetrahedra.size(); ++id) {
            if (mesh.tetrahedra[id].is_dead() || id % 40 != 0) continue;
            mesh.tetrahedra.sphere(id).close();
            closed.insert(id);
        }
        Workspace workspace(made.t.allocator());
        Random random(12);
        std::size_t given_up = 0, ended = 0;
        for (int i = 0; i < 200; ++i) {
            const std::array<double, 3> q = random.point(is_on_lattice && i % 2 == 0);
            const TetId start = made.in_conflict(q.data());
            if (start == no_tetrahedron || closed.count(start) != 0) continue;
            bool is_free = true;
            for (const TetId id : closed)
                is_free = is_free && !is_conflict_exact(mesh, mesh.tetrahedra[id], q.data());
            const bool is_dug =
                made.t.calls().dig_walled(mesh, workspace, walls.data(), q.data(), start);
            EXPECT_EQ(is_dug, is_free);
            if (is_dug) {
                for (std::size_t k = 0; k < workspace.boundary_size; ++k)
                    ended += closed.count(tetrahedron_of(workspace.boundary.data[k]));
                workspace.restore_cavity(mesh.tetrahedra, workspace.cavity_size);
            }
            given_up += !is_dug;
            for (TetId id = 0; id < mesh.tetrahedra.size(); ++id)
                EXPECT_FALSE(mesh.tetrahedra[id].is_in_cavity());
        }
        EXPECT_GT(given_up, 20u);
        EXPECT_GT(ended, 20u);
    });
}

// Without walls, a cavity that is dug first and filled later gives what an insertion gives.
TEST(Walls, FilledCavitiesAreThoseOfInsertions) {
    for_each_kernel([](const Kernel& kernel, bool is_on_lattice) {
        const std::vector<double> xyz = is_on_lattice ? random_points(300, true) : skew_lines(40);
        Triangulated inserted(kernel, xyz), planned(kernel, xyz);
        Mesh &one = inserted.mesh(), &other = planned.mesh();
        Workspace w(inserted.t.allocator()), own(planned.t.allocator());
        Random random(12);
        std::size_t freed_slots = 0, taken_slots = 0;
        for (int i = 0; i < 40; ++i) {
            const std::array<double, 3> q = random.point(is_on_lattice && i % 2 == 0);
            const TetId start = inserted.in_conflict(q.data()),
                        begin = planned.in_conflict(q.data());
            if (start == no_tetrahedron) continue;
            const auto add = [&](Mesh& mesh) {
                const auto v = static_cast<VertexId>(mesh.vertices.size());
                mesh.vertices.push_back({{q[0], q[1], q[2]}, v - 1, 0});
                mesh.vertex_hint.push_back(no_tetrahedron);
                return v;
            };
            inserted.t.calls().insert(one, w, add(one), start);

            const std::vector<std::uint8_t> walls(other.tetrahedra.size(), 0);
            ASSERT_TRUE(planned.t.calls().dig_walled(other, own, walls.data(), q.data(), begin));
            const std::size_t removed = own.cavity_size, created = own.boundary_size;
            if (removed > own.star_removed || created > own.star_created)
                own.grow_star(removed, created);
            const std::vector<FacetCode> boundary(own.boundary.data, own.boundary.data + created);
            std::vector<TetId> stack;
            for (std::size_t k = removed; k < created; ++k) {
                stack.push_back(static_cast<TetId>(other.tetrahedra.size()));
                other.tetrahedra.resize(other.tetrahedra.size() + 1);
            }
            const std::size_t taken = stack.size(), freed = removed - std::min(removed, created);
            stack.resize(taken + removed);
            TetId* end = stack.data() + taken;
            planned.t.calls().fill_walled(other, own, add(other), &end);
            EXPECT_EQ(end - stack.data(), static_cast<std::ptrdiff_t>(freed));
            for (const TetId* t = stack.data(); t != end; ++t)
                EXPECT_TRUE(other.tetrahedra[*t].is_dead());
            taken_slots += taken;
            freed_slots += freed;
            ASSERT_EQ(own.slot_count, created);
            for (std::size_t k = 0; k < created; ++k)
                EXPECT_EQ(other.tetrahedra[tetrahedron_of(own.slots.data[k])].n[0], boundary[k]);
            EXPECT_EQ(live_tetrahedra(one), live_tetrahedra(other));
        }
        EXPECT_GT(is_on_lattice ? taken_slots : freed_slots, 100u);
    });
}

}  // namespace
}  // namespace mgdt
