// SPDX-License-Identifier: MIT
// Triangles and segments are divided at the points that are in them.
#pragma once

#include "cleaning/incidences.hpp"
#include "cleaning/projection.hpp"

namespace mgdt {

// Divides triangles and segments, so that the points in their edges, and those inside of triangles,
// become corners. A part with two equal corners is left out. A point that is in an edge between two
// parts is left to the next call. The parts are new triangles. Marks the caller's facets whose
// triangles are divided in `is_changed`. Patches have to be found anew.
void divide_at(const Incidences& incidences, const Nearness& near, SurfacePieces& pieces,
               Buffer<std::uint8_t>& is_changed, Allocator& allocator);

}  // namespace mgdt
