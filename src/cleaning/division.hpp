// SPDX-License-Identifier: MIT
// Triangles and segments are divided at the points that are in them.
#pragma once

#include "cleaning/incidences.hpp"
#include "cleaning/patches.hpp"

namespace mgdt {

// Divides triangles and segments, so that the points in their edges, and those inside of triangles,
// become corners. A part with two equal corners is left out. A point that is in an edge between two
// parts is left to the next call. Marks the patches and, in `is_changed`, the caller's facets whose
// triangles are divided.
void divide_at(const Incidences& incidences, SurfacePieces& pieces, Buffer<Patch>& patches,
               Buffer<std::uint8_t>& is_changed, Allocator& allocator);

}  // namespace mgdt
