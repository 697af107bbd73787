// SPDX-License-Identifier: MIT
// Meshes with tetrahedra of all shapes, for tests of improvement.
#pragma once

#include <map>
#include <random>
#include <string>
#include <vector>

#include "../support/small.h"
#include "surfaces.hpp"

namespace mgdt {

// A box of a by b by c cubes whose sides are grids of triangles, with points inside: those of a
// lattice, each moved by up to `jitter` of the distance of two. All coordinates of the sides are
// small integers. With `has_wall`, a plane of facets divides the box into two regions.
inline Surface gridded_box(int a, int b, int c, double jitter, unsigned seed,
                           bool has_wall = false) {
    Surface s{"box of " + std::to_string(a) + " by " + std::to_string(b) + " by " +
              std::to_string(c) + (has_wall ? " with a wall" : "")};
    const int size[3] = {a, b, c}, wall = a / 2;
    std::mt19937_64 random(seed);
    std::map<std::vector<int>, std::uint32_t> numbers;
    const auto at = [&](const std::vector<int>& i) { return numbers.at(i); };
    for (int x = 0; x <= a; ++x)
        for (int y = 0; y <= b; ++y)
            for (int z = 0; z <= c; ++z) {
                double p[3] = {1.0 * x, 1.0 * y, 1.0 * z};
                const bool is_inside =
                    x > 0 && x < a && y > 0 && y < b && z > 0 && z < c && !(has_wall && x == wall);
                if (is_inside)
                    for (double& q : p)
                        q += jitter * (static_cast<double>(random() >> 11) * 0x1p-52 - 1);
                numbers[{x, y, z}] = s.point(p[0], p[1], p[2]);
            }
    const auto side = [&](int axis, int level, bool turns, std::int32_t marker) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int i = 0; i < size[u]; ++i)
            for (int j = 0; j < size[v]; ++j) {
                std::uint32_t q[4];
                for (int k = 0; k < 4; ++k) {
                    std::vector<int> corner(3, level);
                    corner[static_cast<std::size_t>(u)] = i + (k == 1 || k == 2 ? 1 : 0);
                    corner[static_cast<std::size_t>(v)] = j + (k >= 2 ? 1 : 0);
                    q[k] = at(corner);
                }
                if (turns) std::swap(q[1], q[3]);
                s.facet({q[0], q[1], q[2]}, marker);
                s.facet({q[0], q[2], q[3]}, marker);
            }
    };
    for (int axis = 0; axis < 3; ++axis) {
        side(axis, 0, true, 2 * axis);
        side(axis, size[axis], false, 2 * axis + 1);
    }
    if (has_wall) side(0, wall, false, 6);
    s.regions = has_wall ? 2 : 1;
    s.volume = a * b * c;
    return s;
}

inline std::vector<Surface> improvable_surfaces() {
    std::vector<Surface> all = {gridded_box(4, 3, 3, 0.3, 1),
                                gridded_box(5, 3, 2, 0.45, 2),
                                gridded_box(4, 4, 3, 0.4, 3, true),
                                cube(),
                                plate(),
                                nested_shells(3, false),
                                tunnel(),
                                dangling(),
                                touching_cubes(),
                                grains(3),
                                torus(12, 6),
                                divided_box(),
                                city(3)};
    all.push_back(gridded_box(4, 4, 3, 0.4, 4, true));
    rotate(all.back(), 0.3, 0.8);
    all.push_back(gridded_box(4, 3, 3, 0.3, 5));
    for (double& x : all.back().points) x = 1e9 + x;
    all.back().name += " at 1e9";
    return all;
}

// A mesh of each surface.
template <class Test>
void for_improvable_meshes(const Test& test) {
    const std::vector<Surface> surfaces = improvable_surfaces();
    for (int i = 0; i < fewer(static_cast<int>(surfaces.size())); ++i) {
        const Surface& s = surfaces[static_cast<std::size_t>(i)];
        SCOPED_TRACE(s.name);
        MeshedDomain domain;
        give(domain, s);
        domain.build();
        test(domain.mesh());
    }
}

}  // namespace mgdt
