// SPDX-License-Identifier: MIT
// Triangles that fill a polygon.
#pragma once

#include <cstdint>

#include "platform/memory.hpp"

namespace mgdt {

// Divides a polygon into triangles whose corners are corners of the polygon, and appends three
// numbers for each triangle. `corners` are numbers of points. The points may be near a plane rather
// than in it. Seen along the coordinate axis nearest to its normal, the polygon has to be simple,
// or to touch itself at corners and edges without crossing itself, like a border that is connected
// to a hole by an edge in both directions. Returns false for any other polygon, and appends nothing
// then. The time is quadratic in the number of corners, or cubic for unusual polygons.
bool triangulate_polygon(const double* points, const std::uint32_t* corners, std::size_t size,
                         Buffer<std::uint32_t>& triangles);

}  // namespace mgdt
