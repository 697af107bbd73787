// SPDX-License-Identifier: MIT
// A triangulation that spans space, with the vertices of one that does not.
#pragma once

#include "core/triangulation.hpp"

namespace mgdt {

// How many points a copy has besides.
inline constexpr std::size_t far_points = 4;

// Inserts the vertices of `flat` into the empty triangulation `copy`, with the indices that they
// have. Adds far points around them, with the indices from `points` on. `reach` is at least the
// diameter of a region that contains the vertices, in units of the caller. Within the region, the
// Voronoi cells of the vertices are the same as without the far points (docs/theory.md, "Points
// in one plane"). Throws as Triangulation::insert(), and Error if far points leave the doubles.
void copy_spanned(const Triangulation& flat, double reach, std::size_t points, Triangulation& copy);

}  // namespace mgdt
