// SPDX-License-Identifier: MIT
// A body-centred cubic lattice.
#pragma once

#include <cmath>
#include <cstdint>

#include "platform/random.hpp"

namespace mgdt {

// The corners and centres of cubes. Its Delaunay triangulation has equal tetrahedra, whose dihedral
// angles are 60 and 90 degrees.
struct CubicLattice {
    double step = 0;  // the edge of a cube, or 0 for no lattice
    double origin[3] = {0, 0, 0};

    // By how much points are moved at random, in steps: cospherical points would take exact tests.
    static constexpr double jitter = 0x1p-12;
    // Finds the lattice point nearest to x.
    void snap(const double* x, double (&to)[3]) const noexcept {
        double corner[3], centre[3], to_corner = 0, to_centre = 0;
        for (int k = 0; k < 3; ++k) {
            const double place = (x[k] - origin[k]) / step;
            corner[k] = std::floor(place + 0.5);
            centre[k] = std::floor(place) + 0.5;
            to_corner += (place - corner[k]) * (place - corner[k]);
            to_centre += (place - centre[k]) * (place - centre[k]);
        }
        const double(&place)[3] = to_corner <= to_centre ? corner : centre;
        std::uint64_t key = 0;
        for (const double x : place)
            key = 0x100001B3u * key + static_cast<std::uint64_t>(static_cast<std::int64_t>(2 * x));
        Random random(key);
        for (int k = 0; k < 3; ++k)
            to[k] =
                origin[k] +
                (place[k] + jitter * (static_cast<double>(random.next() >> 11) * 0x1p-53 - 0.5)) *
                    step;
    }
};

}  // namespace mgdt
