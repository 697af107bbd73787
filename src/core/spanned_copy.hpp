// SPDX-License-Identifier: MIT
// A triangulation that spans space, with the vertices of one that does not.
#pragma once

#include "core/triangulation.hpp"

namespace mgdt {

// How many points a copy has besides.
inline constexpr std::size_t far_points = 4;

// Inserts the vertices of `flat` into the empty triangulation `copy`, with their indices, and four
// points around them with the indices from `points` on. These are farther than three times `reach`,
// in units of the caller, from all vertices. So the Voronoi cells are those of the vertices alone
// within `reach` of them: no ball with a vertex on its sphere, and its centre there, has a far
// point inside. Throws as Triangulation::insert(), and Error if the far points are beyond the
// doubles.
void copy_spanned(const Triangulation& flat, double reach, std::size_t points, Triangulation& copy);

}  // namespace mgdt
