// SPDX-License-Identifier: MIT
// Triangles that fill a polygon.
#pragma once

#include <cstdint>

#include "platform/memory.hpp"

namespace mgdt {

// Fills the polygon with these corners, numbers of points, with triangles whose corners are its
// own, and appends three numbers for each triangle. The corners may be near a plane instead of on
// one. Seen in the direction of the coordinate axis nearest to its normal, the polygon is simple,
// or touches itself at corners and edges without crossing itself, as one that walks to a hole and
// back. Returns false for any other polygon, with nothing appended. The time is quadratic in the
// number of corners, or cubic for unusual polygons.
bool triangulate_polygon(const double* points, const std::uint32_t* corners, std::size_t size,
                         Buffer<std::uint32_t>& triangles);

}  // namespace mgdt
