// SPDX-License-Identifier: MIT
// Schemes with cells: grids and trees.
#include "order_sets.hpp"

namespace {

using namespace order_test;

TEST(Grid, DivisionsAreThePapers) {
    // alpha = cbrt(N / (n Rx Ry Rz)), NINT(alpha R): 2 x 4 x 3 cells as in Figure 12.
    const Coordinates xyz = {0, 0, 0, 2, 4, 3};
    const PointSet points = point_set(xyz);
    const Grid grid(points, box_of(points), 192, 8);
    EXPECT_EQ(grid.count()[0], 2u);
    EXPECT_EQ(grid.count()[1], 4u);
    EXPECT_EQ(grid.count()[2], 3u);
    EXPECT_EQ(grid.cells(), 24u);
}

TEST(Grid, FlatAndThinBoxesGetAsManyCells) {
    const double most = std::numeric_limits<double>::max();
    const double sizes[][3] = {
        {1, 1, 0},      {0, 1, 0},    {0, 0, 0},       {1e300, 1, 1e-300},
        {1, 1e-9, 1},   {1e-4, 1, 1}, {most, most, 1}, {5e-324, 1e-323, 5e-324},
        {1, 1e-2, 0.1}, {3, 5, 4}};
    for (const auto& size : sizes) {
        Coordinates xyz(6);
        for (int k = 0; k < 3; ++k)
            xyz[static_cast<std::size_t>(k)] = -size[k],
            xyz[3 + static_cast<std::size_t>(k)] = size[k];
        const PointSet points = point_set(xyz);
        for (const double n : {1e1, 1e4, 1e6, 4e9}) {
            const Grid grid(points, box_of(points), static_cast<std::size_t>(n), 8);
            const double wanted = std::min(n / 8, 0x1p29);
            EXPECT_LE(static_cast<double>(grid.cells()), 4 * wanted);
            if (std::max({size[0], size[1], size[2]}) > 0) {
                EXPECT_GE(static_cast<double>(grid.cells()), wanted / 4);
            }
            EXPECT_EQ(grid.path(points, 0), 0u);
            std::uint32_t cell[3];
            grid.locate(points, 1, cell);
            for (int k = 0; k < 3; ++k) {
                EXPECT_EQ(cell[k], size[k] > 0 ? grid.count()[k] - 1 : 0);
            }
        }
    }
}

void expect_serpentine(const Coordinates& xyz, std::size_t n, const double* from) {
    const PointSet points = point_set(xyz);
    const Grid grid(points, box_of(points), n, 1, from);
    ASSERT_EQ(grid.cells(), points.size);
    std::vector<std::size_t> at(points.size, points.size);
    for (std::size_t i = 0; i < points.size; ++i) {
        const std::uint32_t place = grid.path(points, i);
        ASSERT_LT(place, at.size());
        ASSERT_EQ(at[place], points.size) << "two points in a cell";
        at[place] = i;
    }
    for (std::size_t k = 1; k < at.size(); ++k) {
        std::uint32_t a[3], b[3];
        grid.locate(points, at[k - 1], a);
        grid.locate(points, at[k], b);
        int distance = 0;
        for (int d = 0; d < 3; ++d) distance += std::abs(static_cast<int>(a[d] - b[d]));
        ASSERT_EQ(distance, 1) << "after place " << k - 1;
    }
    if (!from) return;
    std::uint32_t first[3];
    grid.locate(points, at[0], first);
    for (int d = 0; d < 3; ++d) {
        EXPECT_EQ(first[d],
                  from[d] > 0.5 * (points.low[d] + points.high[d]) ? grid.count()[d] - 1 : 0);
    }
}

TEST(Grid, PathIsSerpentineFromTheCornerNextToTheLastPoint) {
    for (const std::size_t side : {2u, 3u, 4u, 5u}) {
        const Coordinates xyz = integer_lattice(side);
        expect_serpentine(xyz, xyz.size() / 3, nullptr);
        for (int corner = 0; corner < 8; ++corner) {
            const double from[3] = {corner & 1 ? 99.0 : -99.0, corner & 2 ? 99.0 : -99.0,
                                    corner & 4 ? 99.0 : -99.0};
            expect_serpentine(xyz, xyz.size() / 3, from);
        }
    }
}

TEST(RegularGrid, GoesFromCellToCellNextToIt) {
    const Coordinates xyz = uniform(20000);
    const PointSet points = point_set(xyz);
    OrderParameters parameters;
    parameters.points_per_cell = 27;  // no cell is empty
    parameters.separation = Separation::none;
    const Result result = schedule(points, MGDT_ORDER_REGULAR_GRID, parameters);
    EXPECT_EQ(result.levels, 1u);
    const Grid grid(points, box_of(points), points.size, 27);
    std::set<std::uint32_t> cells;
    for (std::size_t k = 0; k < points.size; ++k) cells.insert(grid.path(points, k));
    ASSERT_EQ(cells.size(), grid.cells());
    for (std::size_t k = 1; k < points.size; ++k) {
        std::uint32_t a[3], b[3];
        grid.locate(points, result.order[k - 1], a);
        grid.locate(points, result.order[k], b);
        int distance = 0;
        for (int d = 0; d < 3; ++d) distance += std::abs(static_cast<int>(a[d] - b[d]));
        ASSERT_LE(distance, 1);
        ASSERT_TRUE(distance == 1 || result.order[k - 1] < result.order[k]);
    }
}

TEST(KdTree, SandwichesThePapersExample) {
    // 20 points, 2 levels: cell 4, pivot 2, cell 5, pivot 1, cell 6, pivot 3, cell 7 with 5, 4, 4
    // and 4 points (Figure 10). In x they are 0..19 shuffled, in y a permutation of the same.
    Coordinates xyz;
    for (int i = 0; i < 20; ++i) {
        xyz.push_back(i * 7 % 20);
        xyz.push_back(i * 7 % 20 * 3 % 20 * 0.9);
        xyz.push_back(0);
    }
    OrderParameters parameters;
    parameters.points_per_cell = 5;
    const Result result = schedule(xyz, MGDT_ORDER_KD_TREE, parameters);
    EXPECT_EQ(result.levels, 2u);
    const auto x = [&](std::size_t k) { return xyz[3 * std::size_t{result.order[k]}]; };
    const auto y = [&](std::size_t k) { return xyz[3 * std::size_t{result.order[k]} + 1]; };
    EXPECT_EQ(x(10), 10);                                          // pivot 1
    for (std::size_t k = 0; k < 10; ++k) EXPECT_LT(x(k), 10);      // regions 4, 5
    for (std::size_t k = 11; k < 20; ++k) EXPECT_GT(x(k), 10);     // regions 6, 7
    for (std::size_t k = 0; k < 5; ++k) EXPECT_LT(y(k), y(5));     // cell 4, pivot 2
    for (std::size_t k = 6; k < 10; ++k) EXPECT_GT(y(k), y(5));    // cell 5
    for (std::size_t k = 11; k < 15; ++k) EXPECT_LT(y(k), y(15));  // cell 6, pivot 3
    for (std::size_t k = 16; k < 20; ++k) EXPECT_GT(y(k), y(15));  // cell 7
    for (const auto& [begin, end] : {std::pair(0, 5), {6, 10}, {11, 15}, {16, 20}}) {
        EXPECT_TRUE(std::is_sorted(result.order.begin() + begin, result.order.begin() + end));
    }
}

TEST(KdTree, CellsHoldAboutTheNumberAskedFor) {
    EXPECT_EQ(kd_levels(20, 5, false), 2u);
    EXPECT_EQ(kd_levels(20, 10, false), 1u);
    EXPECT_EQ(kd_levels(1000, 10, false), 7u);
    EXPECT_EQ(kd_levels(1999, 1000, true), 0u);
    EXPECT_EQ(kd_levels(4000, 1000, true), 2u);
    EXPECT_EQ(kd_levels(5, 10, false), 0u);

    const Coordinates xyz = noisy_line(5000);
    const PointSet points = point_set(xyz);
    Allocator allocator;
    Team team;
    Buffer<KdPoint> sorted = kd_points(team, points, allocator);
    std::vector<std::size_t> sizes;
    kd_partition(team, sorted, box_of(points), 9, [&] {
        return [&](std::size_t begin, std::size_t end) { sizes.push_back(end - begin); };
    });
    EXPECT_EQ(sizes.size(), 512u);
    EXPECT_EQ(std::accumulate(sizes.begin(), sizes.end(), std::size_t{0}), 5000 - 511u);
    EXPECT_LE(*std::max_element(sizes.begin(), sizes.end()) -
                  *std::min_element(sizes.begin(), sizes.end()),
              1u);
}

TEST(EnhancedKdTree, SandwichesGrids) {
    const Coordinates xyz = uniform(8000);
    const Result enhanced = schedule(xyz, MGDT_ORDER_ENHANCED_KD_TREE);
    OrderParameters parameters;
    parameters.points_per_cell = 1000;
    const Result plain = schedule(xyz, MGDT_ORDER_KD_TREE, parameters);
    EXPECT_EQ(plain.levels, 3u);
    EXPECT_EQ(enhanced.levels, 4u);
    // The pivots are where they are in the plain tree, and so are the sets between them.
    Order pivots;
    std::function<void(std::uint32_t, std::uint32_t, unsigned)> divide =
        [&](std::uint32_t begin, std::uint32_t end, unsigned level) {
            if (level == 0) {
                const auto sorted = [&](const Order& order) {
                    Order part(order.begin() + begin, order.begin() + end);
                    std::sort(part.begin(), part.end());
                    return part;
                };
                EXPECT_EQ(sorted(enhanced.order), sorted(plain.order));
                return;
            }
            const std::uint32_t pivot = begin + (end - begin) / 2;
            pivots.push_back(pivot);
            divide(begin, pivot, level - 1);
            divide(pivot + 1, end, level - 1);
        };
    divide(0, 8000, 3);
    for (const std::uint32_t k : pivots) EXPECT_EQ(enhanced.order[k], plain.order[k]);
    EXPECT_LT(path_length(xyz, enhanced.order), 0.4 * path_length(xyz, plain.order));
}

TEST(EnhancedKdTree, OfOneCellIsARegularGrid) {
    const Coordinates xyz = uniform(1500);
    OrderParameters parameters;
    parameters.separation = Separation::none;
    EXPECT_EQ(schedule(xyz, MGDT_ORDER_ENHANCED_KD_TREE).order,
              schedule(xyz, MGDT_ORDER_REGULAR_GRID, parameters).order);
}

TEST(MultiGrid, WithoutCrowdsIsTheRegularGrid) {
    const Coordinates xyz = uniform(5000);
    OrderParameters parameters;
    parameters.separation = Separation::none;
    const Result multi = schedule(xyz, MGDT_ORDER_MULTI_GRID, parameters);
    EXPECT_TRUE(multi == schedule(xyz, MGDT_ORDER_REGULAR_GRID, parameters));
    parameters.points_per_cell = 2;
    parameters.threshold = 6;  // now there are crowds
    EXPECT_NE(schedule(xyz, MGDT_ORDER_MULTI_GRID, parameters).order,
              schedule(xyz, MGDT_ORDER_REGULAR_GRID, parameters).order);
}

TEST(MultiGrid, RefinesACrowdedCellInPlace) {
    Coordinates xyz = uniform(3000);
    const Coordinates crowd = uniform(1000);
    for (const double x : crowd) xyz.push_back(0.5 + 1e-6 * x);
    OrderParameters parameters;
    parameters.separation = Separation::none;
    const PointSet points = point_set(xyz);
    const Result multi = schedule(points, MGDT_ORDER_MULTI_GRID, parameters);
    const Result single = schedule(points, MGDT_ORDER_REGULAR_GRID, parameters);
    EXPECT_EQ(multi.levels, 3u);  // the crowd is alone in one cell of the second grid
    // The points of each cell of the first grid stand where they stood, in another order where
    // there are more than 200.
    const Grid grid(points, box_of(points), points.size, 8);
    std::size_t refined = 0;
    for (std::size_t begin = 0; begin < points.size;) {
        const std::uint32_t cell = grid.path(points, single.order[begin]);
        std::size_t end = begin;
        while (end < points.size && grid.path(points, single.order[end]) == cell) ++end;
        Order before(single.order.begin() + static_cast<long>(begin),
                     single.order.begin() + static_cast<long>(end));
        Order after(multi.order.begin() + static_cast<long>(begin),
                    multi.order.begin() + static_cast<long>(end));
        if (end - begin > 200) {
            EXPECT_NE(after, before);
            std::sort(after.begin(), after.end());  // the input's order is that of one cell
            ++refined;
        }
        EXPECT_EQ(after, before);
        begin = end;
    }
    EXPECT_GE(refined, 1u);
    // Inside the crowd the order is that of its own regular grid, from some corner on.
    Order inside;
    for (const std::uint32_t i : multi.order) {
        if (i >= 3000) inside.push_back(i - 3000);
    }
    const Order alone = schedule(crowd, MGDT_ORDER_REGULAR_GRID, parameters).order;
    EXPECT_NEAR(path_length(crowd, inside) / path_length(crowd, alone), 1, 0.1);
}

TEST(MultiGrid, StopsWherePointsCannotBeSeparated) {
    OrderParameters parameters;
    parameters.threshold = 1;
    parameters.separation = Separation::passes;
    const Coordinates same =
        generate(5000, [](std::size_t, Random&, double* p) { p[0] = p[1] = p[2] = 0.25; });
    EXPECT_LE(schedule(same, MGDT_ORDER_MULTI_GRID, parameters).levels, 1u);
    // One point in each binade: a grid over any of them splits off but a few.
    const Coordinates exponential = generate(2000, [](std::size_t i, Random&, double* p) {
        p[0] = p[1] = p[2] = std::ldexp(1.0, 1000 - static_cast<int>(i));
    });
    parameters.points_per_cell = 1;
    const Result result = schedule(exponential, MGDT_ORDER_MULTI_GRID, parameters);
    expect_sound(result, 2000);
    EXPECT_LE(result.levels, 64u);
}

TEST(MultiGrid, ByDefaultIsWhatAutoTakes) {
    Coordinates xyz = uniform(3000);
    for (const double x : uniform(1000)) xyz.push_back(0.5 + 1e-9 * x);
    const Result multi = schedule(xyz, MGDT_ORDER_MULTI_GRID);
    EXPECT_TRUE(multi == schedule(xyz, MGDT_ORDER_AUTO));
    EXPECT_GT(multi.rounds.size(), 2u);
    // A threshold leaves crowds as they are; auto does not know it.
    OrderParameters parameters;
    parameters.threshold = 1e9;
    const Result coarse = schedule(xyz, MGDT_ORDER_MULTI_GRID, parameters);
    EXPECT_EQ(coarse.levels, 1u);
    EXPECT_GT(multi.levels, 1u);
    EXPECT_TRUE(multi == schedule(xyz, MGDT_ORDER_AUTO, parameters));
}

TEST(RegularGrid, RoundsFollowItsPath) {
    const Coordinates xyz = uniform(20000);
    const PointSet points = point_set(xyz);
    const Result result = schedule(points, MGDT_ORDER_REGULAR_GRID);
    const Grid grid(points, box_of(points), points.size, 8);
    ASSERT_GT(result.rounds.size(), 2u);
    const std::size_t last = result.rounds.back();
    EXPECT_EQ(points.size - last, points.size - points.size / 12);
    for (std::size_t k = last + 1; k < points.size; ++k)
        ASSERT_LE(grid.path(points, result.order[k - 1]), grid.path(points, result.order[k]));
}

TEST(MultiGrid, SeparationTakesOnePointFromACellAtATime) {
    const Coordinates xyz = uniform(20000);
    const PointSet points = point_set(xyz);
    const Grid grid(points, box_of(points), points.size, 8);
    OrderParameters parameters;
    parameters.separation = Separation::passes;
    const Result result = schedule(points, MGDT_ORDER_MULTI_GRID, parameters);
    ASSERT_EQ(result.levels, 1u);
    EXPECT_TRUE(result == schedule(points, MGDT_ORDER_REGULAR_GRID, parameters));
    std::vector<std::uint32_t> taken(grid.cells(), 0), total(grid.cells(), 0);
    for (std::size_t i = 0; i < points.size; ++i) ++total[grid.path(points, i)];

    std::size_t first_pass_rounds = 0;
    bool first_pass = true;
    for (std::size_t r = 0; r < result.rounds.size(); ++r) {
        const std::size_t begin = result.rounds[r];
        const std::size_t end = r + 1 < result.rounds.size() ? result.rounds[r + 1] : points.size;
        // Once a point is second in its cell, every cell has given its first.
        const std::uint32_t rank = taken[grid.path(points, result.order[begin])];
        if (rank > 0) first_pass = false;
        first_pass_rounds += first_pass;
        if (!first_pass) {
            for (std::size_t c = 0; c < total.size(); ++c) {
                ASSERT_EQ(taken[c], std::min(total[c], rank));
            }
        }
        std::uint32_t before = 0;
        for (std::size_t k = begin; k < end; ++k) {
            const std::uint32_t cell = grid.path(points, result.order[k]);
            ASSERT_TRUE(k == begin || cell > before) << "not once along the path";
            before = cell;
            ASSERT_EQ(taken[cell]++, rank);
            if (rank == 0) {
                ASSERT_EQ(result.hints[k], no_hint);
            } else {
                ASSERT_EQ(grid.path(points, result.order[result.hints[k]]), cell);
            }
        }
    }
    EXPECT_GT(first_pass_rounds, 1u);
    EXPECT_LE(result.rounds[1], 100u);
    const std::uint32_t fullest = *std::max_element(total.begin(), total.end());
    EXPECT_EQ(result.rounds.size(), first_pass_rounds + fullest - 1);
}

TEST(MultiGrid, HintsAreTheNearestOfTheCell) {
    // One cell: every point is in it, so up to the ninth the hint is the nearest of all before.
    const Coordinates xyz = uniform(9);
    OrderParameters parameters;
    parameters.points_per_cell = 100;
    parameters.separation = Separation::passes;
    const Result result = schedule(xyz, MGDT_ORDER_MULTI_GRID, parameters);
    ASSERT_EQ(result.hints[0], no_hint);
    for (std::size_t k = 1; k < 9; ++k) {
        const auto distance = [&](std::size_t j) {
            const double* a = &xyz[3 * std::size_t{result.order[j]}];
            const double* b = &xyz[3 * std::size_t{result.order[k]}];
            return std::fabs(a[0] - b[0]) + std::fabs(a[1] - b[1]) + std::fabs(a[2] - b[2]);
        };
        for (std::size_t j = 0; j < k; ++j) EXPECT_LE(distance(result.hints[k]), distance(j));
    }
}

}  // namespace
