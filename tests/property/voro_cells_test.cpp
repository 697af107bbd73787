// SPDX-License-Identifier: MIT
// Voronoi cells of points in a box beside Voro++: volumes, areas of faces and neighbours, which
// have the same numbers, walls included.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>
#include <voro++/voro++.hh>

#include "../support/small.h"
#include "cli/point_sets/distributions.hpp"
#include "mgdt/mgdt.hpp"

namespace {

// The walls in Voro++'s order: the least x, the largest x, the least y, ...
const std::vector<std::array<double, 4>> unit_box = {{-1, 0, 0, 0}, {1, 0, 0, 1},  {0, -1, 0, 0},
                                                     {0, 1, 0, 1},  {0, 0, -1, 0}, {0, 0, 1, 1}};

struct Cell {
    double volume = 0;
    std::map<std::int64_t, double> areas;  // of the face to each neighbour
};

std::vector<Cell> cells_of_voro(const std::vector<double>& xyz) {
    const int blocks =
        std::max(1, static_cast<int>(std::cbrt(static_cast<double>(xyz.size()) / 15)));
    voro::container container(0, 1, 0, 1, 0, 1, blocks, blocks, blocks, false, false, false, 8);
    for (std::size_t i = 0; i < xyz.size(); i += 3)
        container.put(static_cast<int>(i / 3), xyz[i], xyz[i + 1], xyz[i + 2]);
    std::vector<Cell> cells(xyz.size() / 3);
    voro::c_loop_all loop(container);
    voro::voronoicell_neighbor cell;
    if (!loop.start()) return cells;
    do {
        if (!container.compute_cell(cell, loop)) continue;
        Cell& found = cells[static_cast<std::size_t>(loop.pid())];
        found.volume = cell.volume();
        std::vector<int> neighbors;
        std::vector<double> areas;
        cell.neighbors(neighbors);
        cell.face_areas(areas);
        for (std::size_t f = 0; f < areas.size(); ++f) found.areas[neighbors[f]] = areas[f];
    } while (loop.inc());
    return cells;
}

std::vector<Cell> cells_of_mgdt(const std::vector<double>& xyz) {
    mgdt::Triangulation t;
    t.insert(xyz);
    const mgdt::Voronoi v(t, unit_box);
    const auto areas = v.doubles(mgdt::VoronoiDoubles::face_areas),
               volumes = v.doubles(mgdt::VoronoiDoubles::cell_volumes);
    const auto sides = v.array(mgdt::VoronoiArray::face_sides);
    std::vector<Cell> cells(volumes.size());
    for (std::size_t i = 0; i < cells.size(); ++i) cells[i].volume = volumes[i];
    for (std::size_t f = 0; f < areas.size(); ++f) {
        const std::int64_t a = sides[2 * f], b = sides[2 * f + 1];
        cells[static_cast<std::size_t>(a)].areas[b] = areas[f];
        if (b >= 0) cells[static_cast<std::size_t>(b)].areas[a] = areas[f];
    }
    return cells;
}

TEST(CellsOfVoro, AreTheSame) {
    for (const std::uint64_t seed : {1u, 2u, 3u}) {
        mgdt::cli::GenerateOptions options;
        options.seed = seed;
        const std::vector<double> xyz =
            mgdt::cli::generate("uniform", is_small() ? 200 : 5000, options);
        const std::vector<Cell> expected = cells_of_voro(xyz), found = cells_of_mgdt(xyz);
        ASSERT_EQ(found.size(), expected.size());
        // Voro++ leaves faces out that are below its tolerance, and has rounded ones.
        const double small = 1e-9;
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_NEAR(found[i].volume, expected[i].volume, 1e-12);
            for (const auto& [neighbor, area] : found[i].areas) {
                const auto same = expected[i].areas.find(neighbor);
                const double of_voro = same == expected[i].areas.end() ? 0 : same->second;
                EXPECT_NEAR(area, of_voro, small) << i << " and " << neighbor;
            }
            for (const auto& [neighbor, area] : expected[i].areas)
                EXPECT_TRUE(area < small || found[i].areas.count(neighbor) == 1);
        }
    }
}

}  // namespace
