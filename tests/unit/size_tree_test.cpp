// SPDX-License-Identifier: MIT
// The octree of sizes: what it gives between the places where sizes are sampled.
#include "refinement/size_tree.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "improvable_meshes.hpp"
#include "one_thread.hpp"
#include "platform/random.hpp"
#include "predicates/vector.hpp"
#include "refinement/walled_mesh.hpp"
#include "unwatched.hpp"

namespace mgdt {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double distance(const double* x, const double* y) {
    const Vector<double> d = difference<double>(x, y);
    return std::sqrt(dot(d, d));
}

// A box in the form in which it is refined, where its longest side is at most 2.
struct Box {
    Box(int nx, int ny, int nz) : tree(memory), seeds(memory) {
        MeshedDomain domain;
        give(domain, gridded_box(nx, ny, nz, 0, 2));
        domain.build();
        LinkedMesh linked(domain.mesh(), one_thread(), memory);
        walled.emplace(linked, one_thread(), memory);
        scale = linked.scale();
        high[0] = nx * scale;
        high[1] = ny * scale;
        high[2] = nz * scale;
    }

    template <class Size>
    void build(const Size& size_at, double gradation, std::size_t most_cells = 1000000) {
        sampled = 0;
        const auto sample = [&](std::size_t n, const double* places, double* sizes) {
            sampled += n;
            for (std::size_t i = 0; i < n; ++i) sizes[i] = size_at(places + 3 * i);
        };
        tree.build(walled->mesh, sample, gradation, seeds, most_cells, Unwatched());
    }
    // Calls test(x) for random places in the box.
    template <class Test>
    void at_places(const Test& test) const {
        Random random(7);
        for (int i = 0; i < 5000; ++i) {
            double x[3];
            for (int k = 0; k < 3; ++k)
                x[k] = high[k] * static_cast<double>(random.next() >> 11) * 0x1p-53;
            test(x);
        }
    }

    Allocator memory;
    std::optional<WalledMesh> walled;
    SizeTree tree;
    Buffer<SizeTree::Seed> seeds;
    double scale, high[3];
    std::size_t sampled = 0;
};

TEST(SizeTree, IsExactForALinearSize) {
    Box box(2, 2, 2);
    const auto size_at = [](const double* x) { return 0.5 + 0.1 * x[0] - 0.05 * x[1]; };
    box.build(size_at, 0.3);
    box.at_places([&](const double* x) { EXPECT_NEAR(box.tree.at(x), size_at(x), 1e-12); });
    EXPECT_LT(box.tree.cell_count(), 5000u);
}

TEST(SizeTree, FollowsADistance) {
    Box box(2, 2, 2);
    const double centre[3] = {0.3 * box.high[0], 0.4 * box.high[1], 0.6 * box.high[2]};
    for (const double slope : {0.1, 0.3, 0.9}) {
        const auto size_at = [&](const double* x) { return 1e-4 + slope * distance(x, centre); };
        box.build(size_at, 1);
        box.at_places([&](const double* x) {
            EXPECT_LT(box.tree.at(x), 1.3 * size_at(x));
            EXPECT_GT(box.tree.at(x), 0.7 * size_at(x));
        });
        EXPECT_LT(box.tree.at(centre), 2.5 * 1e-4);
    }
}

// A size that jumps grows with the distance instead.
TEST(SizeTree, LimitsSizesThatJump) {
    Box box(2, 2, 2);
    const double centre[3] = {0.5 * box.high[0], 0.5 * box.high[1], 0.5 * box.high[2]};
    constexpr double radius = 0.2, inside = 0.01;
    for (const double outside : {0.5, infinity}) {
        box.build([&](const double* x) { return distance(x, centre) < radius ? inside : outside; },
                  0.3);
        box.at_places([&](const double* x) {
            const double away = std::max(distance(x, centre) - radius, 0.0);
            const double limit = std::min(inside + 0.3 * away, outside);
            EXPECT_LT(box.tree.at(x), 1.25 * limit + 0.3 * inside);
            EXPECT_GT(box.tree.at(x), 0.75 * limit);
        });
    }
}

TEST(SizeTree, FindsSmallSizesAtSeeds) {
    Box box(2, 2, 2);
    const double centre[3] = {0.31 * box.high[0], 0.42 * box.high[1], 0.53 * box.high[2]};
    constexpr double near = 0.002;
    const auto size_at = [&](const double* x) { return distance(x, centre) < near ? 1e-3 : 1.0; };
    box.build(size_at, 0.3);
    EXPECT_GT(box.tree.at(centre), 0.1);
    box.seeds.push_back({{centre[0], centre[1], centre[2]}, 1e-3});
    box.seeds.push_back({{100, 100, 100}, 1e-3});
    box.build(size_at, 0.3);
    EXPECT_LT(box.tree.at(centre), 2.5e-3);
    EXPECT_TRUE(box.seeds.empty());
}

TEST(SizeTree, HasNoSizeWhereThereIsNone) {
    Box box(3, 2, 1);
    box.build([](const double*) { return infinity; }, 0.3);
    box.at_places([&](const double* x) { EXPECT_EQ(box.tree.at(x), infinity); });
}

// Cells that the mesh does not touch are neither sampled nor divided.
TEST(SizeTree, LeavesOutWhatIsNotInTheMesh) {
    Box plate(20, 20, 1);
    const double size = 0.02;
    plate.build([&](const double*) { return size; }, 0.3);
    plate.at_places([&](const double* x) { EXPECT_NEAR(plate.tree.at(x), size, 1e-15); });
    const double cells = plate.high[0] * plate.high[1] * plate.high[2] / (size * size * size);
    EXPECT_LT(static_cast<double>(plate.sampled), 4 * cells + 5000);
    const double far[3] = {0.5 * plate.high[0], 0.5 * plate.high[1], plate.high[0]};
    EXPECT_EQ(plate.tree.at(far), infinity);
}

TEST(SizeTree, StopsAtTheMostCells) {
    Box box(2, 2, 2);
    for (const double size : {1e-5, 1e-300}) {
        box.build([&](const double*) { return size; }, 0.3, 20000);
        EXPECT_LT(box.tree.cell_count(), 20010u);
        EXPECT_GT(box.tree.wanted_points(), 1e9);
        box.at_places([&](const double* x) { EXPECT_EQ(box.tree.at(x), size); });
    }
}

}  // namespace
}  // namespace mgdt
