// SPDX-License-Identifier: MIT
// Cells of a periodic box beside a list of ranges.
#include "periodic/image_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "../support/small.h"

namespace {

using namespace mgdt;

struct Range {
    double low[3] = {}, high[3] = {};
};

class ImageCellsTest : public testing::TestWithParam<std::array<int, 2>> {
  protected:
    void SetUp() override { cells.make(dimensions, points); }

    double at_random(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    }
    // Of images some boxes away, most of them narrow, a few wider than the box. Some end at faces
    // of boxes or at sides of cells, and some are a single place.
    Range random_range() {
        Range range;
        const double widest = random() % 8 == 0 ? 1.3 : 0.1;
        for (unsigned k = 0; k < dimensions; ++k) {
            range.low[k] = at_random(-3, 3);
            if (random() % 4 == 0) range.low[k] = std::floor(range.low[k]);
            if (random() % 4 == 0) range.low[k] = std::floor(range.low[k] / side) * side;
            range.high[k] = range.low[k] + (random() % 4 == 0 ? 0 : at_random(0, widest));
        }
        return range;
    }
    // Whether an image of a point is in a range that is wider by `more`.
    bool has_image(const Range& range, const double (&s)[3], double more) const {
        for (unsigned k = 0; k < dimensions; ++k) {
            const double next = s[k] + std::ceil(range.low[k] - more - s[k]);
            if (next > range.high[k] + more) return false;
        }
        return true;
    }
    // Points of the box, some on its faces or at sides of cells, and moved over them by rounding.
    template <class Visit>
    void each_point(const Visit& visit) {
        for (int i = 0; i < (is_small() ? 200 : 4000); ++i) {
            double s[3] = {};
            for (unsigned k = 0; k < dimensions; ++k) {
                const double faces[] = {0, 1, -1e-16, 1 - 1e-16, -1.0 / 300, 301.0 / 300};
                s[k] = random() % 4 == 0 ? faces[random() % 6] : at_random(0, 1);
                if (random() % 8 == 0) s[k] = std::floor(s[k] / side) * side;
            }
            visit(s);
        }
    }

    // Whether the cells are marked of so many places in a wider range that each cell has one.
    bool places_are_marked(const Range& range, double more) const {
        int count[3] = {1, 1, 1};
        for (unsigned k = 0; k < dimensions; ++k)
            count[k] =
                2 + static_cast<int>(1.5 / side * std::min(1.0, range.high[k] - range.low[k]));
        for (int a = 0; a < count[0]; ++a)
            for (int b = 0; b < count[1]; ++b)
                for (int c = 0; c < count[2]; ++c) {
                    const int at[3] = {a, b, c};
                    double s[3] = {};
                    for (unsigned k = 0; k < dimensions; ++k) {
                        const double width = range.high[k] - range.low[k] + 2 * more;
                        s[k] = range.low[k] - more + width * at[k] / (count[k] - 1);
                        s[k] -= std::floor(s[k]);
                    }
                    if (!cells.has(s)) return false;
                }
        return true;
    }

    const unsigned dimensions = static_cast<unsigned>(GetParam()[0]);
    const std::size_t points = static_cast<std::size_t>(GetParam()[1]);
    // Of a cell: a fourth of a cell for each point, and 64 at most along a vector.
    const double side =
        1 /
        std::min(64.0, std::max(1.0, std::floor(std::cbrt(0.25 * static_cast<double>(points)))));
    std::mt19937 random{static_cast<unsigned>(GetParam()[0] + 3 * GetParam()[1])};
    Allocator allocator;
    ImageCells cells{allocator};
};

TEST_P(ImageCellsTest, HaveThePointsOfRanges) {
    std::vector<Range> ranges;
    for (int round = 0; round < 4; ++round) {
        for (int i = 0; i < 3; ++i) {
            ranges.push_back(random_range());
            cells.add(ranges.back().low, ranges.back().high);
        }
        cells.mark();
        for (const Range& range : ranges) EXPECT_TRUE(cells.has_all(range.low, range.high));
        each_point([&](const double(&s)[3]) {
            const auto is_near = [&](double more) {
                return std::any_of(ranges.begin(), ranges.end(),
                                   [&](const Range& r) { return has_image(r, s, more); });
            };
            const bool has = cells.has(s);
            EXPECT_TRUE(has || !is_near(0)) << s[0] << ' ' << s[1] << ' ' << s[2];
            EXPECT_TRUE(!has || is_near(1.26 * side)) << s[0] << ' ' << s[1] << ' ' << s[2];
        });
    }
}

TEST_P(ImageCellsTest, TellWhichRangesTheyHave) {
    const Range first = random_range();
    EXPECT_FALSE(cells.has_all(first.low, first.high));
    Range half;
    for (unsigned k = 0; k < dimensions; ++k) half.high[k] = 0.5;
    cells.add(half.low, half.high);
    for (int i = 0; i < 6; ++i) {
        const Range range = random_range();
        cells.add(range.low, range.high);
    }
    cells.mark();
    int had = 0;
    for (int i = 0; i < (is_small() ? 100 : 1000); ++i) {
        const Range range = random_range();
        const bool has_all = cells.has_all(range.low, range.high);
        had += has_all ? 1 : 0;
        EXPECT_TRUE(!has_all || places_are_marked(range, 0));
        // At a side of a cell, rounding may say no.
        EXPECT_TRUE(has_all || !places_are_marked(range, 1e-9));
    }
    EXPECT_GT(had, 0);
}

TEST_P(ImageCellsTest, BeginAnew) {
    const Range range = random_range();
    cells.add(range.low, range.high);
    cells.mark();
    EXPECT_TRUE(cells.has_all(range.low, range.high));
    cells.make(dimensions, points);
    EXPECT_FALSE(cells.has_all(range.low, range.high));
    each_point([&](const double(&s)[3]) { EXPECT_FALSE(cells.has(s)); });
}

INSTANTIATE_TEST_SUITE_P(Boxes, ImageCellsTest,
                         testing::Values(std::array<int, 2>{1, 1}, std::array<int, 2>{1, 5000},
                                         std::array<int, 2>{2, 30}, std::array<int, 2>{2, 20000},
                                         std::array<int, 2>{3, 4}, std::array<int, 2>{3, 900},
                                         std::array<int, 2>{3, 20000}));

INSTANTIATE_TEST_SUITE_P(ManyPoints, ImageCellsTest,
                         testing::Values(std::array<int, 2>{1, 2000000},
                                         std::array<int, 2>{2, 1100000}));

}  // namespace
