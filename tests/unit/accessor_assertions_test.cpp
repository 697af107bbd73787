// SPDX-License-Identifier: MIT
// The assertions in the accessors of arrays, the mesh, the cavity, the star, numbers, zones and
// points: each fires where an accessor is used wrongly. Of builds that have assertions.
#include <gtest/gtest.h>

#include <algorithm>

#include "core/equal_points.hpp"
#include "core/zones.hpp"
#include "kernel/access.hpp"
#include "kernel/cavity.hpp"
#include "kernel/star.hpp"
#include "kernel/star_records.hpp"
#include "mesh/facet_turns.hpp"
#include "mesh/numbers.hpp"
#include "mesh/star_traversal.hpp"
#include "query/numbering.hpp"
#include "surgery.hpp"

namespace mgdt {
namespace {

// Each death runs in a process of its own, whatever threads there are here.
struct Accessors : testing::Test {
    void SetUp() override { testing::FLAGS_gtest_death_test_style = "threadsafe"; }
    Allocator allocator;
};
using ArrayDeathTest = Accessors;
using RecordDeathTest = Accessors;
using NumbersDeathTest = Accessors;
using EdgesDeathTest = Accessors;
using PointsDeathTest = Accessors;

TEST_F(ArrayDeathTest, Elements) {
    Buffer<int> array(allocator);
    array.set_capacity(8);
    array.resize(2, 7);
    const Buffer<int>& constant = array;
    EXPECT_DEATH(array[2] = 1, "beyond the array");
    EXPECT_DEATH((void)constant[2], "beyond the array");
    EXPECT_DEATH(array.resize_within_capacity(array.capacity() + 1), "beyond the capacity");
    EXPECT_DEATH(array.prefault(0, array.capacity() + 1), "pages beyond the array");
    array.clear();
    EXPECT_DEATH(array.back() = 1, "no last element");
    EXPECT_DEATH((void)constant.back(), "no last element");
    EXPECT_DEATH(array.pop_back(), "no last element");
    Allocator another;
    EXPECT_DEATH(array = Buffer<int>(another), "belongs to another allocator");
}

TEST_F(RecordDeathTest, Codes) {
    const volatile TetId beyond = max_tetrahedra;
    EXPECT_DEATH((void)facet_code(beyond, 0), "without a facet code");
    const volatile unsigned fifth = 4;
    EXPECT_DEATH((void)facet_code(0, fifth), "four faces");
    EXPECT_DEATH((void)first_facet(beyond), "without a facet code");
}

TEST_F(RecordDeathTest, Tetrahedra) {
    Tetrahedron finite = {{4, 3, 2, 1}, {0, 0, 0, 0}};
    EXPECT_DEATH((void)finite.infinite_slot(), "no vertex at infinity");
    KeptSphere sphere = {{0, 0, 0}, 0};
    sphere.close();
    EXPECT_DEATH(sphere.close(), "closed already");
    unsigned position[4];
    finite.v[3] = 4;
    EXPECT_DEATH((void)positions_by_number(finite.v, position), "are the same");
}

TEST_F(RecordDeathTest, Slots) {
    TetrahedronStore store(allocator);
    store.resize(4);
    const TetrahedronStore& constant = store;
    const std::size_t beyond = store.capacity();
    EXPECT_DEATH((void)store[beyond].v[0], "no such slot");
    EXPECT_DEATH((void)constant[beyond].v[0], "no such slot");
    EXPECT_DEATH((void)store.sphere(beyond).e, "no such slot");
    EXPECT_DEATH((void)constant.sphere(beyond).e, "no such slot");
    EXPECT_DEATH((void)store.view<false>(), "of the other kind");
    EXPECT_DEATH((void)constant.view<false>(), "of the other kind");
    EXPECT_DEATH((void)store.view<true>().record(5), "code of face 0");
    EXPECT_DEATH(store.resize_within_capacity(beyond + 1), "beyond the capacity");
    EXPECT_DEATH(store.reserve(std::size_t{max_tetrahedra} + 1), "more slots");
}

TEST_F(RecordDeathTest, Facets) {
    VertexId facet[3] = {3, 5, 3};
    EXPECT_DEATH(turn_to(facet, 3), "three vertices");
    EXPECT_DEATH(turn_to_least(facet), "are the same");
}

TEST_F(NumbersDeathTest, Names) {
    Numbers numbers(allocator);
    numbers.number(70);
    EXPECT_DEATH((void)numbers.number(no_index), "a name that nothing has");
    EXPECT_DEATH((void)numbers.name(1), "no name has this number");
}

TEST_F(NumbersDeathTest, Table) {
    NumberTable table(allocator);
    const auto is_same = [](std::uint32_t) { return false; };
    EXPECT_DEATH((void)table.find(0, is_same), "without entries");
    EXPECT_DEATH((void)table.lookup(), "without entries");
    table.reserve(8);
    for (std::uint32_t i = 0; i < table.capacity(); ++i) (void)table.number(i, is_same);
    EXPECT_DEATH((void)table.number(1000, is_same), "no room for one more");
}

TEST_F(EdgesDeathTest, Matrix) {
    FacetCode codes[1024] = {};
    const EdgeMatrix<5> matrix(codes);
    EdgeMatrix<5> written(codes);
    EXPECT_DEATH(written.put(32, 0, 0), "the matrix is too small");
    EXPECT_DEATH(written.put(7, 7, 0), "to itself");
    EXPECT_DEATH((void)matrix.get(0, 32), "the matrix is too small");
}

TEST_F(EdgesDeathTest, Table) {
    Workspace w(allocator);
    w.grow_star(400, 800);
    w.boundary_size = 8;
    EdgeTable table(w);
    table.put(1, 2, 40);
    EXPECT_DEATH(table.put(1, 2, 44), "in the same direction");
    EXPECT_DEATH((void)table.get(2, 1), "no facet has this edge");
}

TEST_F(EdgesDeathTest, Star) {
    Workspace w(allocator);
    const SmallCorners corners{&w.small};
    EXPECT_DEATH(corners.put(64, 0, 1, 2), "more facets than a small star");
    Tetrahedron t = {};
    const EdgeMatrix<5> edges(w.small.edges);
    EXPECT_DEATH(link_inside(edges, 1, 2, 1, t), "are the same");
    w.boundary_size = 4;
    const std::uint32_t numbers[4] = {1, 2, 3, 4};
    EXPECT_DEATH((void)ghosts_of_star(w, 0, numbers, numbers), "without a slot");
    const Vertex vertices[2] = {};
    EXPECT_DEATH(set_coordinates(w, vertices, 1, 1), "more vertices than there is room");
}

TEST_F(EdgesDeathTest, Workspace) {
    Workspace w(allocator);
    EXPECT_DEATH(w.grow_cavity(3, 0, 2), "fewer members are needed");
    EXPECT_DEATH(w.ids.reserve(10, 3), "more elements are kept");
    TetrahedronStore store(allocator);
    EXPECT_DEATH(w.restore_cavity(store, 1), "more members than there is room");
}

// A triangulation, and the cavity of a point in it.
class InMesh : public Accessors {
  protected:
    using Access = SerialAccess<KeptSpheres>;

    void SetUp() override {
        Accessors::SetUp();
        surgery::Random random(41);
        surgery::insert(t_, surgery::uniform_points(60, random));
        w_.grow_cavity(0, 0, 64);
        w_.grow_star(200, 200);
    }
    CavityFront<Access> front() { return {Access{mesh_}, mesh_, w_}; }
    // Any tetrahedron and its neighbours, as one cavity.
    void dig() {
        const TetId t = mesh_.live_from(0);
        w_.cavity.data[0] = first_facet(t);
        w_.cavity_size = 1;
        for (unsigned i = 0; i < 4; ++i) {
            w_.first_corners[i] = mesh_.tetrahedra[t].v[i];
            w_.boundary.data[i] = mesh_.tetrahedra[t].n[i];
        }
        w_.boundary_size = 4;
    }

    Triangulation t_{nullptr, nullptr, nullptr};
    Mesh& mesh_ = const_cast<Mesh&>(t_.mesh());
    Workspace w_{t_.allocator()};
};
using MeshDeathTest = InMesh;
using CavityDeathTest = InMesh;
using ZonesDeathTest = InMesh;

TEST_F(MeshDeathTest, Counts) {
    const std::size_t ghosts = mesh_.ghost_count;
    mesh_.ghost_count = mesh_.live_count() + 1;
    EXPECT_DEATH((void)mesh_.finite_count(), "more ghosts than tetrahedra");
    mesh_.ghost_count = ghosts;
    mesh_.free_slots.resize(mesh_.tetrahedra.size(), 0);
    EXPECT_DEATH((void)mesh_.live_from(0), "all tetrahedra are dead");
    mesh_.free_slots.push_back(0);
    EXPECT_DEATH((void)mesh_.live_count(), "more slots are free");
}

TEST_F(MeshDeathTest, Stars) {
    const TetId t = mesh_.live_from(0);
    Buffer<TetId> star(allocator);
    star.push_back(t);
    const VertexId v = mesh_.tetrahedra[t].v[0];
    EXPECT_DEATH(traverse_star(mesh_, 61, star, [](FacetCode) {}), "lacks the vertex");
    mesh_.tetrahedra[t].kill();
    EXPECT_DEATH(traverse_star(mesh_, v, star, [](FacetCode) {}), "is dead");
}

TEST_F(MeshDeathTest, Numbering) {
    Team team;
    const Numbering by_slot(allocator, mesh_, false, team),
        by_bits(allocator, mesh_, false, team, 0);
    ASSERT_TRUE(by_slot.is_by_slot());
    const auto beyond = static_cast<TetId>(64 * by_slot.stretches());
    EXPECT_DEATH((void)by_slot.number(beyond), "no such slot");
    if (!by_bits.is_by_slot()) {
        EXPECT_DEATH((void)by_bits.by_slot(), "found by bits");
    }
    EXPECT_DEATH(by_slot.for_each_run(0, by_slot.stretches() + 1, [](TetId, TetId, std::size_t) {}),
                 "beyond the last");
    const auto ghosts = [&] {
        std::vector<bool> seen(mesh_.tetrahedra.size(), false);
        return ghosts_of(mesh_, allocator, [&](TetId t) {
            const bool is_new = !seen[t];
            seen[t] = true;
            return is_new;
        });
    };
    ASSERT_EQ(ghosts().size(), mesh_.ghost_count);
    --mesh_.ghost_count;
    EXPECT_DEATH((void)ghosts(), "more ghosts than were counted");
    mesh_.ghost_count += 2;
    EXPECT_DEATH((void)ghosts(), "fewer ghosts than were counted");
}

TEST_F(CavityDeathTest, Front) {
    const TetId t = mesh_.live_from(0);
    EXPECT_DEATH(front().begin(w_, {t, 16}), "four faces");
    const FacetCode* const n = mesh_.tetrahedra[t].n;
    auto cavity = front();
    EXPECT_DEATH(cavity.sort_out(cavity.tetrahedra.four(n), n, 1, 2), "was not tested");
    EXPECT_DEATH(cavity.sort_out_apart(n, 1, 2), "was not tested");
    cavity.end = cavity.limit + 1;
    EXPECT_DEATH(cavity.take(cavity.tetrahedra.four(n), n, 1), "no room for four more");
    cavity = front();
    ++cavity.next;
    EXPECT_DEATH((void)cavity.members(w_), "more members were passed");
    EXPECT_DEATH(front().give_up(mesh_, w_, 0), "without members");
    mesh_.tetrahedra[t].kill();
    EXPECT_DEATH(front().begin(w_, {t, 0}), "begins at a dead");
}

TEST_F(CavityDeathTest, LocalNumbers) {
    const auto all = mesh_.tetrahedra.view<true>();
    dig();
    const auto missing = [&](VertexId v) {
        return std::find(w_.first_corners, w_.first_corners + 4, v) == w_.first_corners + 4;
    };
    VertexId other = 1;
    while (!missing(other)) ++other;
    {
        DirectNumbers numbers(w_);
        ASSERT_TRUE(numbers.add_cavity(w_, all));
        EXPECT_DEATH((void)numbers.lookup()(other), "without a number");
    }
    {
        ProbedNumbers numbers(w_);
        numbers.add_cavity(w_, all);
        EXPECT_EQ(numbers.count(), 4u);
        EXPECT_DEATH((void)numbers.lookup()(other), "without a number");
        w_.probed_size = 4;
        EXPECT_DEATH(ProbedNumbers(w_).add_cavity(w_, all), "more than half full");
    }
    const TetId t = tetrahedron_of(w_.cavity.data[0]);
    mesh_.tetrahedra[t].kill();
    EXPECT_DEATH((void)corner(all, first_facet(t)), "a member of the cavity is dead");
}

TEST_F(CavityDeathTest, Replacement) {
    dig();
    mesh_.reserve_slots(8, 8);
    EXPECT_DEATH(
        {
            w_.star_created = 3;
            choose_slots(Access{mesh_}, w_);
        },
        "no room for the star");
    EXPECT_DEATH(
        {
            DirectNumbers none(w_);
            replace_cavity(Access{mesh_}, mesh_, w_, 60, none);
        },
        "span space");
    EXPECT_DEATH(
        {
            // A facet whose other side is a slot of the star.
            w_.slots.data[0] = first_facet_of(w_.boundary.data[0]);
            link_outside(
                mesh_.tetrahedra.view<true>(), w_, 60, [](VertexId v) { return v % 16; },
                EdgeMatrix<5>(w_.small.edges), SmallCorners{&w_.small});
        },
        "inside the cavity");
}

TEST_F(ZonesDeathTest, Zones) {
    Team team;
    Schedule schedule(allocator, allocator);
    schedule.rounds.push_back(0);
    Zones zones(team, allocator, schedule, 90);
    EXPECT_DEATH((void)zones.of(1), "space is not divided");
    const Zones::Round round = {60, 90, 0};
    zones.divide(2, round, mesh_);
    EXPECT_DEATH((void)zones.first(round, 3), "no such zone");
    EXPECT_DEATH((void)zones.is_at_border(59), "an earlier round");
    zones.close(mesh_);
    zones.open(mesh_);
    EXPECT_DEATH(zones.open(mesh_), "open already");
}

TEST_F(PointsDeathTest, EqualPoints) {
    Buffer<VertexId> map(allocator);
    for (const VertexId v : {1u, 2u, 1u, infinite_vertex}) map.push_back(v);
    Buffer<std::uint32_t> leaving(allocator);
    leaving.push_back(0);
    EqualPoints points(allocator, 3);
    points.find(map, leaving);
    EXPECT_EQ(points.least_other(map, 1, 0), 2u);
    EXPECT_DEATH((void)points.least_other(map, infinite_vertex, 3), "has no vertex");
    EXPECT_DEATH((void)points.least_other(map, 1, 1), "at another vertex");
    EXPECT_DEATH(points.join(infinite_vertex, 0), "no point at no vertex");
}

}  // namespace
}  // namespace mgdt
