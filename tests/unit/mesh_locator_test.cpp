// SPDX-License-Identifier: MIT
// Location in meshes: compared with a test of all tetrahedra.
#include "solid/mesh_locator.hpp"

#include <gtest/gtest.h>

#include <random>

#include "../support/small.h"
#include "improvable_meshes.hpp"
#include "predicates/predicates.hpp"

namespace mgdt {
namespace {

std::uint32_t first_with(const SolidMesh& mesh, const double* place) {
    for (std::uint32_t t = 0; t < mesh.tetrahedron_count(); ++t) {
        const auto corner = [&](std::size_t i) {
            return mesh.points.begin() + 3 * std::size_t{mesh.tetrahedra[4 * std::size_t{t} + i]};
        };
        if (orientation(place, corner(1), corner(2), corner(3)) >= 0 &&
            orientation(corner(0), place, corner(2), corner(3)) >= 0 &&
            orientation(corner(0), corner(1), place, corner(3)) >= 0 &&
            orientation(corner(0), corner(1), corner(2), place) >= 0)
            return t;
    }
    return no_index;
}

TEST(MeshLocator, FindsTheFirstTetrahedron) {
    std::mt19937 random(3);
    int inside = 0, outside = 0;
    for_improvable_meshes([&](const SolidMesh& mesh) {
        Allocator memory;
        StopFlag flag;
        const MeshLocator locator(memory, mesh, flag.request());
        const auto count = static_cast<std::uint32_t>(mesh.points.size() / 3);
        std::uint32_t near = no_index;
        for (int i = 0; i < fewer(300); ++i) {
            // At points, between two and three of them, and elsewhere in their box.
            double place[3];
            const double* const p[3] = {mesh.points.begin() + 3 * (random() % count),
                                        mesh.points.begin() + 3 * (random() % count),
                                        mesh.points.begin() + 3 * (random() % count)};
            for (int k = 0; k < 3; ++k)
                place[k] = i % 4 == 0   ? p[0][k]
                           : i % 4 == 1 ? p[0][k] / 2 + p[1][k] / 2
                           : i % 4 == 2
                               ? p[0][k] / 2 + p[1][k] / 4 + p[2][k] / 4
                               : p[random() % 3][k] + 1e-3 * static_cast<double>(random() % 7);
            const std::uint32_t expected = first_with(mesh, place);
            ASSERT_EQ(locator.locate(place, no_index), expected);
            ASSERT_EQ(locator.locate(place, near), expected);
            for (int trial = 0; trial < 3; ++trial)
                ASSERT_EQ(locator.locate(place, static_cast<std::uint32_t>(
                                                    random() % mesh.tetrahedron_count())),
                          expected);
            near = expected;
            ++(expected == no_index ? outside : inside);
        }
    });
    EXPECT_GT(inside, 0);
    EXPECT_GT(outside, 0);
}

}  // namespace
}  // namespace mgdt
