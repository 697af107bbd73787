// SPDX-License-Identifier: MIT
// Patches: connected triangles in one plane, or near it, whose common edges may be exchanged.
#pragma once

#include "cleaning/nearness.hpp"
#include "cleaning/projection.hpp"
#include "cleaning/surface_pieces.hpp"

namespace mgdt {

// Sets the patch of each triangle, and returns the projections of the patches. A patch grows from
// its largest triangle over edges that exactly two triangles have, with equal markers, and no
// segment. All of its corners are in the plane of that triangle, exactly or nearly, and its
// triangles do not overlap at their edges as they are projected. A flat triangle is alone.
Buffer<Projection> find_patches(SurfacePieces& pieces, const Buffer<std::int32_t>& facet_markers,
                                const Nearness& near, Allocator& allocator);

// For each corner of each triangle, 3 times the triangle beyond the opposite edge plus the corner
// opposite there; no_index unless exactly two triangles have the edge, they are of one patch, and
// no segment has it.
Buffer<std::uint32_t> links_in_patches(const SurfacePieces& pieces, Allocator& allocator);

}  // namespace mgdt
