// SPDX-License-Identifier: MIT
// Corners of location that the public tests seldom come to: trees that grow too deep or out of
// memory, and points that the scale of the triangulation cannot hold.
#include <cstdlib>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "../support/aligned.h"
#include "predicates/predicates.hpp"
#include "query/locate.hpp"
#include "surgery.hpp"

namespace mgdt {
namespace {

using namespace surgery;

// Vertices on a diagonal, which a tree takes in one below the other.
void fill_diagonal(Mesh& mesh, std::size_t n) {
    mesh.clear();
    for (std::size_t v = 1; v <= n; ++v) {
        const double x = static_cast<double>(v);
        mesh.vertices.push_back(Vertex{{x, x, x}, static_cast<std::uint32_t>(v - 1), 0});
    }
}

TEST(LocationTree, ServesWhenTooDeep) {
    Allocator allocator;
    Mesh mesh(allocator);
    fill_diagonal(mesh, 20000);
    LocationTree tree(allocator, mesh, 20);
    tree.add(mesh, 20, mesh.vertices.size());
    EXPECT_TRUE(tree.is_sound(mesh.vertices.size()));
    EXPECT_FALSE(tree.is_sound(1000));
    const double far[3] = {1e6, 1e6, 1e6}, first[3] = {0, 0, 0};
    // Of every sixteenth vertex four go to each of 128 levels, and nothing beyond.
    EXPECT_GT(tree.near(far), 8000u);
    EXPECT_LT(tree.near(far), 8500u);
    EXPECT_EQ(tree.near(first), 1u);
}

TEST(LocationTree, ServesWhenMemoryIsShort) {
    Allocator allocator;
    Mesh mesh(allocator);
    fill_diagonal(mesh, 1000);
    LocationTree tree(allocator, mesh, 20);
    allocator.set_limit(allocator.bytes());
    tree.add(mesh, 20, mesh.vertices.size());
    allocator.set_limit(0);
    EXPECT_TRUE(tree.is_sound(mesh.vertices.size()));
    const double far[3] = {1e6, 1e6, 1e6};
    // One leaf has room for six more.
    EXPECT_EQ(tree.near(far), 112u);
}

// Takes vertices in one at a time, as calls for single points do.
void add_each(LocationTree& tree, const Mesh& mesh, std::size_t begin) {
    for (std::size_t v = begin; v < mesh.vertices.size(); ++v) tree.add(mesh, v, v + 1);
}

// Of vertices that came alone every fourth is found at its own place; where floats cannot tell it
// from its neighbours, one of its leaf is.
TEST(LocationTree, TakesInVerticesThatComeAlone) {
    struct {
        double low, size;
        std::size_t found;
    } const cubes[] = {{0, 1, 735}, {1e9, 1, 120}, {0, 1e200, 120}};
    Random random(5);
    std::uniform_real_distribution<double> any(0, 1);
    for (const auto& cube : cubes) {
        Allocator allocator;
        Mesh mesh(allocator);
        fill_diagonal(mesh, 20);
        while (mesh.vertices.size() < 3000) {
            Vertex v = {{0, 0, 0}, 0, 0};
            for (double& x : v.x) x = cube.low + cube.size * any(random);
            mesh.vertices.push_back(v);
        }
        LocationTree tree(allocator, mesh, 20);
        add_each(tree, mesh, 20);
        EXPECT_TRUE(tree.is_sound(mesh.vertices.size()));
        std::size_t found = 0;
        for (VertexId v = 20; v < mesh.vertices.size(); v += 4) {
            const VertexId near = tree.near(mesh.point(v));
            ASSERT_NE(near, infinite_vertex);
            found += near == v;
        }
        EXPECT_GT(found, cube.found);
    }
}

// Points that advance along a rod, one in a call, find places in the tree down to its depth only:
// it is made again before too many have none.
TEST(LocationTree, IsMadeAgainWhereVerticesAdvance) {
    std::vector<double> rod;
    for (int i = 0; i < 12000; ++i) rod.insert(rod.end(), {i + 0.0, 0.1 * (i % 7), 0.1 * (i % 5)});
    Patient p = triangulate({rod.begin(), rod.begin() + 3 * 600});
    ASSERT_NE(p.t->location_tree(), nullptr);
    for (std::size_t i = 3 * 600; i < rod.size(); i += 3)
        insert(*p.t, {rod[i], rod[i + 1], rod[i + 2]});
    for (const double x : {300.0, 3000.0, 9000.0, 11999.0}) {
        const double q[3] = {x, 0.3, 0.2};
        EXPECT_NEAR(p.t->mesh().point(p.t->location_tree()->near(q))[0], x, 12000 / 8 + 100);
    }
}

// Blocks of one allocator, so that they can be spoiled.
struct Blocks {
    static void* take(std::size_t bytes, std::size_t align, void* user) {
        auto& blocks = static_cast<Blocks*>(user)->all;
        blocks.emplace_back(allocate_aligned(bytes, align), bytes);
        return blocks.back().first;
    }
    static void give_back(void* p, std::size_t, std::size_t, void*) { free_aligned(p); }
    std::vector<std::pair<void*, std::size_t>> all;
};

// A tree in spoiled memory is told from a sound one before it is descended: a vertex that is not
// there, a leaf without any, a place that only seems to be used, an axis beyond the third, a child
// that is no node or leaf, or is one twice.
TEST(LocationTree, IsUnsoundWhenSpoiled) {
    if (sizeof(void*) < 8) GTEST_SKIP() << "nodes have other places here";
    Allocator mesh_allocator;
    Mesh mesh(mesh_allocator);
    fill_diagonal(mesh, 1000);
    const auto vertices = static_cast<std::uint32_t>(mesh.vertices.size());
    Blocks blocks;
    Allocator allocator(Blocks::take, Blocks::give_back, &blocks);
    const LocationTree tree(allocator, mesh, vertices);
    // What it is made from, which is gone, its nodes and its leaves.
    ASSERT_EQ(blocks.all.size(), 3u);
    ASSERT_TRUE(tree.is_sound(vertices));
    auto* const nodes = static_cast<std::uint32_t*>(blocks.all[1].first);
    auto* const leaves = static_cast<std::uint32_t*>(blocks.all[2].first);
    const auto expect_unsound = [&](std::uint32_t& word, std::uint32_t value) {
        const std::uint32_t before = std::exchange(word, value);
        EXPECT_FALSE(tree.is_sound(vertices)) << before << ' ' << value;
        word = before;
        ASSERT_TRUE(tree.is_sound(vertices));
    };
    // 63 samples, halved four times. Of each node, in words: the split (two), axis, two children.
    constexpr std::uint32_t node_count = 15, leaf_count = 16;
    constexpr std::size_t node = 6, axis = 2;
    for (std::size_t i = 0; i < node_count; ++i) {
        expect_unsound(nodes[node * i + axis], 3);
        for (const std::size_t child : {std::size_t{3}, std::size_t{4}}) {
            std::uint32_t& there = nodes[node * i + child];
            for (const std::uint32_t value :
                 {2 * node_count, 2 * leaf_count + 1, 0xFFFFFFFFu, there ^ 2, 0u, 1u})
                if (value != there) expect_unsound(there, value);
        }
    }
    // Of each leaf: eight x, eight y, eight z, eight vertices, of which three or four are used.
    constexpr std::size_t leaf = 32, most = 8, first_vertex = 24;
    for (std::size_t i = 0; i < leaf_count; ++i) {
        std::uint32_t* const words = leaves + leaf * i;
        expect_unsound(words[first_vertex], 0);
        expect_unsound(words[first_vertex], vertices);
        for (std::size_t k = first_vertex + most / 2; k < leaf; ++k) {
            expect_unsound(words[k], vertices);
            expect_unsound(words[k - first_vertex], 0);
        }
    }
}

Locator locator(const Triangulation& t) {
    return {t.mesh(), t.calls(), t.location_tree()};
}

// A point that is exact in the caller's coordinates alone.
TEST(Location, OfPointsThatCannotBeScaled) {
    for (const double size : {0x1p1000, 0x1p-1000}) {
        const Patient p = triangulate(
            {-size, -size, -size, size, -size, -size, 0, size, -size, 0, 0, size, 0, 0, -size});
        ASSERT_NE(p.t->mesh().scale, 0);
        const double beyond = size > 1 ? std::numeric_limits<double>::max() : 0x1p1000;
        const double least = std::numeric_limits<double>::denorm_min();
        const bool large = size > 1;
        // Near 0, inside; far away, outside. Of the two, one is what the scale cannot hold.
        const double inside[3] = {large ? 3 * least : size / 8, large ? least : 0,
                                  large ? least : -size / 8};
        const double outside[3] = {beyond, beyond / 2, beyond};
        for (const TetId start : {no_tetrahedron, TetId{0}}) {
            TetId hint = start;
            const TetId found = locator(*p.t).locate(inside, hint);
            ASSERT_NE(found, no_tetrahedron);
            EXPECT_FALSE(p.t->mesh().tetrahedra[found].is_ghost());
            EXPECT_EQ(found, hint);
            hint = start;
            EXPECT_EQ(locator(*p.t).locate(outside, hint), no_tetrahedron);
            EXPECT_NE(hint, no_tetrahedron);
        }
        const VertexId nearest = locator(*p.t).nearest_vertex(outside, p.t->allocator());
        EXPECT_EQ(p.t->mesh().vertices[nearest].index, 3u);
        // Several on their way at a time.
        const double* const both[2] = {inside, outside};
        std::vector<TetId> found(2);
        locator(*p.t).locate_sequence(
            2, true, [&](std::size_t k) { return both[k]; },
            [&](std::size_t k, TetId t, TetId near) {
                found[k] = t;
                EXPECT_NE(near, no_tetrahedron);
            });
        EXPECT_NE(found[0], no_tetrahedron);
        EXPECT_EQ(found[1], no_tetrahedron);
    }
}

// Among points whose squared distances are about the least double, and round to anything: multiples
// of 2^-537 between two spheres, compared before they are made so small.
TEST(Location, NearestWhereSquaresUnderflow) {
    Random random(8);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int round = 0; round < 20; ++round) {
        std::vector<double> xyz = {-1, -1, -1, 2, -1, -1, -1, 2, -1, -1, -1, 2}, multiples(12, 4);
        while (xyz.size() < 3 * 44) {
            const double m[3] = {any(random), any(random), any(random)};
            const double square = m[0] * m[0] + m[1] * m[1] + m[2] * m[2];
            if (square < 0.7 || square > 1) continue;
            for (const double x : m) {
                multiples.push_back(static_cast<float>(x));
                xyz.push_back(multiples.back() * 0x1p-537);
            }
        }
        // The scale is that of most coordinates: these are farther away, and of ordinary size.
        for (int i = 0; i < 3 * 50; ++i) xyz.push_back(4 + any(random));
        const Patient p = triangulate(xyz);
        ASSERT_EQ(p.t->mesh().scale, 0);
        const double q[3] = {0, 0, 0};
        std::uint32_t expected = 4;
        for (std::uint32_t i = 5; i < 44; ++i)
            if (compare_distance(q, &multiples[3 * i], &multiples[3 * expected]) < 0) expected = i;
        const VertexId nearest = locator(*p.t).nearest_vertex(q, p.t->allocator());
        EXPECT_EQ(p.t->mesh().vertices[nearest].index, expected);
    }
}

// Barycentric coordinates where no volume is a double.
TEST(Location, WeightsInTheFlattest) {
    const double least = std::numeric_limits<double>::denorm_min();
    for (const double size : {1e-200, least}) {
        const double length = size == least ? least : 1;
        const Patient p = triangulate({0, 0, 0, length, 0, 0, 0, size, 0, 0, 0, size});
        ASSERT_EQ(p.t->mesh().finite_count(), 1u);
        const double q[3] = {length, 0, 0};
        TetId hint = no_tetrahedron;
        const TetId found = locator(*p.t).locate(q, hint);
        ASSERT_NE(found, no_tetrahedron);
        double w[4], sum = 0;
        locator(*p.t).weights(found, q, w);
        for (int i = 0; i < 4; ++i) {
            sum += w[i];
            if (size != least) {
                const VertexId v = p.t->mesh().tetrahedra[found].v[i];
                EXPECT_EQ(w[i], p.t->mesh().vertices[v].index == 1 ? 1 : 0);
            }
        }
        EXPECT_EQ(sum, 1);
        if (size == least) continue;
        const double middle[3] = {0.25, 0.25 * size, 0.25 * size};
        locator(*p.t).weights(found, middle, w);
        for (const double x : w) EXPECT_EQ(x, 0.25);
    }
}

// Of a place that is exact in the caller's coordinates alone.
TEST(Location, WeightsWhereThereIsNoScale) {
    const double size = 0x1p1000, least = std::numeric_limits<double>::denorm_min();
    const Patient p = triangulate({0, 0, 0, size, 0, 0, 0, size, 0, 0, 0, size});
    ASSERT_NE(p.t->mesh().scale, 0);
    const double q[3] = {size / 2, 3 * least, size / 4};
    TetId hint = no_tetrahedron;
    const TetId found = locator(*p.t).locate(q, hint);
    ASSERT_NE(found, no_tetrahedron);
    double w[4];
    locator(*p.t).weights(found, q, w);
    const double expected[4] = {0.25, 0.5, 0, 0.25};
    for (int i = 0; i < 4; ++i) {
        const VertexId v = p.t->mesh().tetrahedra[found].v[i];
        EXPECT_EQ(w[i], expected[p.t->mesh().vertices[v].index]);
    }
}

TEST(Location, WithoutTetrahedra) {
    const Patient p = triangulate({0, 0, 0, 1, 0, 0, 2, 0, 0});
    const double q[3] = {1.1, 0, 0};
    const double* const one = q;
    TetId hint = no_tetrahedron;
    EXPECT_EQ(locator(*p.t).locate(q, hint), no_tetrahedron);
    std::vector<TetId> found(3, 0);
    locator(*p.t).locate_sequence(
        3, true, [&](std::size_t) { return one; },
        [&](std::size_t k, TetId t, TetId) { found[k] = t; });
    EXPECT_EQ(found, std::vector<TetId>(3, no_tetrahedron));
    EXPECT_EQ(p.t->mesh().vertices[locator(*p.t).nearest_vertex(q, p.t->allocator())].index, 1u);
}

}  // namespace
}  // namespace mgdt
