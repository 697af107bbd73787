// SPDX-License-Identifier: MIT
//
// Degenerate and hostile sets: coordinates at which a Delaunay code without exact arithmetic,
// tie-breaking or checks of its input goes wrong. Each gives n points unless said otherwise.
#pragma once

#include <cstddef>

#include "cli/point_sets/random_points.hpp"

namespace mgdt::cli::hostile {

// The first n integer points of the smallest cube that has n of them.
Points lattice(Random& random, std::size_t n);
// n of the 6630 integer points of the sphere of radius 1105 about the origin, in random order; all
// of them if n is larger.
Points integer_sphere(Random& random, std::size_t n);
// On the curve (t, t^2, t^3): every two points share an edge, so there are n^2 / 2 of them.
Points moment_curve(Random& random, std::size_t n);
// On two skew lines: about n^2 / 4 tetrahedra.
Points two_lines(Random& random, std::size_t n);
// Uniform, rounded to multiples of 1/1024.
Points rounded(Random& random, std::size_t n);
// Drawn from the 8000 points of a 20^3 lattice, with repeats.
Points lattice_repeats(Random& random, std::size_t n);
// On the plane x + 2 y = 3 z, exactly.
Points coplanar(Random& random, std::size_t n);
// On the line through (0, 0, 0) and (1, 2, 3), exactly.
Points collinear(Random& random, std::size_t n);
// One point, n times.
Points one_point(Random& random, std::size_t n);
// In a box of 1e6 by 1 by 1e-6.
Points anisotropic(Random& random, std::size_t n);
// Uniform; the point in the middle has a NaN.
Points nan(Random& random, std::size_t n);
// Uniform; the point in the middle has an infinity.
Points infinity(Random& random, std::size_t n);

}  // namespace mgdt::cli::hostile
