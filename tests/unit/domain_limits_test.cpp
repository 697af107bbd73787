// SPDX-License-Identifier: MIT
// Surfaces that need very many points on their segments, or more than doubles have: each build
// ends.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "../support/small.h"
#include "surfaces.hpp"

namespace mgdt {
namespace {

// Builds with one and two threads, checks the mesh, and returns the status.
mgdt_status status_of(const Surface& s) {
    mgdt_status status[2];
    std::size_t points[2];
    for (int k = 0; k < 2; ++k) {
        MeshedDomain domain;
        give(domain, s);
        domain.settings().takes_open_surfaces = true;
        domain.settings().threads = k + 1;
        const Error error = error_of([&] { domain.build(); });
        status[k] = error.status;
        points[k] = domain.mesh().points.size();
        if (error.status == MGDT_OK) domain.check();
        EXPECT_TRUE(error.status == MGDT_OK || error.status == MGDT_ERR_RESOLUTION)
            << s.name << ": " << error.message;
    }
    EXPECT_EQ(status[0], status[1]) << s.name;
    EXPECT_EQ(points[0], points[1]) << s.name;
    return status[0];
}

// Triangles with an edge of 0.001 and a corner 2,000 away, in layers of a flat box.
TEST(DomainLimits, NeedlesInAFlatBox) {
    for (unsigned seed = 1; seed < (is_small() ? 2 : 4); ++seed) {
        for (const int needles : {5, 10}) {
            if (is_small() && needles == 10) break;
            std::mt19937 random(seed);
            std::uniform_real_distribution<double> coordinate(-950, 950);
            Surface s("needles");
            add_box(s, {-1000, -1000, -1}, {1000, 1000, 1});
            for (int i = 0; i < needles; ++i) {
                const double x = coordinate(random), y = coordinate(random),
                             z = -0.72 + 1.44 * i / needles;
                const std::uint32_t a = s.point(x, y, z);
                s.point(x + 0.001, y, z);
                s.point(-x, -y, z);
                s.facet({a, a + 1, a + 2});
            }
            EXPECT_EQ(status_of(s), MGDT_OK) << needles << " needles, seed " << seed;
        }
    }
}

// Adds a lattice of triangles over the unit square at heights, and returns its first point.
std::uint32_t add_sheet(Surface& s, unsigned side, const std::vector<double>& heights, double up,
                        bool is_turned) {
    const auto first = static_cast<std::uint32_t>(s.points.size() / 3);
    for (unsigned i = 0; i <= side; ++i)
        for (unsigned j = 0; j <= side; ++j)
            s.point(double(i) / side, double(j) / side, heights[i * (side + 1) + j] + up);
    for (unsigned i = 0; i < side; ++i)
        for (unsigned j = 0; j < side; ++j) {
            const std::uint32_t a = first + i * (side + 1) + j, b = a + side + 1;
            if ((i + j + is_turned) % 2 == 0) {
                s.facet({a, b, b + 1});
                s.facet({a, b + 1, a + 1});
            } else {
                s.facet({a, b, a + 1});
                s.facet({b, b + 1, a + 1});
            }
        }
    return first;
}

// Two sheets with the same border and the same random heights, one above the other.
TEST(DomainLimits, CrumpledSheets) {
    for (const double thickness : {1e-3, 1e-7, 1e-12})
        for (const unsigned side : {3u, 5u}) {
            if (is_small() && side == 5) break;
            std::mt19937 random(side);
            std::uniform_real_distribution<double> height(-0.3, 0.3);
            std::vector<double> heights((side + 1) * (side + 1));
            for (double& h : heights) h = height(random);
            Surface s("crumpled sheet");
            const std::uint32_t low = add_sheet(s, side, heights, 0, false),
                                high = add_sheet(s, side, heights, thickness, false);
            std::vector<std::uint32_t> border;
            for (unsigned i = 0; i < side; ++i) border.push_back(i * (side + 1));
            for (unsigned j = 0; j < side; ++j) border.push_back(side * (side + 1) + j);
            for (unsigned i = side; i > 0; --i) border.push_back(i * (side + 1) + side);
            for (unsigned j = side; j > 0; --j) border.push_back(j);
            for (std::size_t k = 0; k < border.size(); ++k) {
                const std::uint32_t a = border[k], b = border[(k + 1) % border.size()];
                s.facet({low + a, low + b, high + b});
                s.facet({low + a, high + b, high + a});
            }
            const mgdt_status status = status_of(s);
            if (thickness > 1e-6) {
                EXPECT_EQ(status, MGDT_OK) << side;
            }
        }
}

// Two flat sheets with different diagonals.
TEST(DomainLimits, PlatesThatNearlyTouch) {
    for (const double gap : {1e-6, 1e-9, 1e-12}) {
        Surface s("plates");
        add_box(s, {-1, -1, -1}, {2, 2, 2});
        const std::vector<double> flat(25, 0.0);
        add_sheet(s, 4, flat, 0, false);
        add_sheet(s, 4, flat, gap, true);
        const mgdt_status status = status_of(s);
        if (gap > 1e-11) {
            EXPECT_EQ(status, MGDT_OK) << gap;
        }
    }
}

}  // namespace
}  // namespace mgdt
