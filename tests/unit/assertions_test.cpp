// SPDX-License-Identifier: MIT
// Each assertion of the library fires where what it asserts is broken. Of builds that have them.
#include "kernel/assertions.hpp"

#include <gtest/gtest.h>

#include "kernel/access.hpp"
#include "surgery.hpp"

namespace mgdt {
namespace {

// A vertex in the middle of others, and its star as the kernel leaves it in a workspace.
class Assertions : public testing::Test {
  protected:
    void SetUp() override {
        testing::FLAGS_gtest_death_test_style = "threadsafe";
        surgery::Random random(41);
        surgery::insert(t_, surgery::uniform_points(60, random));
        surgery::insert(t_, {0.5, 0.5, 0.5});
        w_.grow_star(200, 200);
        for (TetId t = 0; t < mesh_.tetrahedra.size(); ++t)
            if (mesh_.tetrahedra[t].v[0] == newest) w_.slots.data[w_.slot_count++] = first_facet(t);
        ASSERT_GT(w_.slot_count, 4u);
        assert_star_is_sound(mesh_, w_, newest);
    }
    Tetrahedron& first() { return mesh_.tetrahedra[tetrahedron_of(w_.slots.data[0])]; }

    static constexpr VertexId newest = 61;
    Triangulation t_{nullptr, nullptr, nullptr};
    Mesh& mesh_ = const_cast<Mesh&>(t_.mesh());
    Workspace w_{t_.allocator()};
};
using AssertionsDeathTest = Assertions;

TEST_F(AssertionsDeathTest, NewestVertexFirst) {
    std::swap(first().v[0], first().v[1]);
    EXPECT_DEATH(assert_star_is_sound(mesh_, w_, newest), "the newest vertex is not first");
}

TEST_F(AssertionsDeathTest, MutualAdjacency) {
    std::swap(first().n[1], first().n[2]);
    EXPECT_DEATH(assert_star_is_sound(mesh_, w_, newest), "does not return the adjacency");
}

TEST_F(AssertionsDeathTest, Orientation) {
    std::swap(first().v[2], first().v[3]);
    std::swap(first().n[2], first().n[3]);
    for (unsigned face = 2; face < 4; ++face) {
        const FacetCode code = first().n[face];
        mesh_.tetrahedra[tetrahedron_of(code)].n[face_of(code)] =
            facet_code(tetrahedron_of(w_.slots.data[0]), face);
    }
    EXPECT_DEATH(assert_star_is_sound(mesh_, w_, newest), "is not positively oriented");
}

TEST_F(AssertionsDeathTest, PlaceOfTheVertexAtInfinity) {
    first().v[1] = infinite_vertex;
    EXPECT_DEATH(assert_star_is_sound(mesh_, w_, newest), "the vertex at infinity is second");
}

// Owns nothing.
struct Stranger {
    bool owns(const Tetrahedron&) const { return false; }
};

TEST_F(AssertionsDeathTest, Cavity) {
    w_.grow_cavity(0, 0, 4);
    w_.cavity.data[0] = first_facet(0);
    w_.cavity_size = 1;
    assert_cavity_is_sound(SerialAccess<ComputedSpheres>{mesh_}, mesh_, w_);
    EXPECT_DEATH(assert_cavity_is_sound(Stranger(), mesh_, w_), "is not owned");
    mesh_.tetrahedra[0].kill();
    EXPECT_DEATH(assert_cavity_is_sound(SerialAccess<ComputedSpheres>{mesh_}, mesh_, w_),
                 "is dead");
}

TEST_F(AssertionsDeathTest, FreeSlots) {
    mesh_.reserve_slots(0, 2);
    const TetId t = tetrahedron_of(w_.slots.data[0]);
    const Tetrahedron kept = mesh_.tetrahedra[t];
    mesh_.free_slot(t);
    mesh_.tetrahedra[t] = kept;
    FacetCode slots[32];
    EXPECT_DEATH(mesh_.take_slots(slots, 1), "a free slot is not dead");
    mesh_.free_slots.set_capacity(0);
    EXPECT_DEATH(mesh_.free_slot(t), "there is no room among the free slots");
}

}  // namespace
}  // namespace mgdt
