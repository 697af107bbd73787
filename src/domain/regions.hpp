// SPDX-License-Identifier: MIT
// The parts into which facets divide a mesh.
#pragma once

#include "boundary/input.hpp"
#include "domain/constrained_mesh.hpp"
#include "solid/rounding_grid.hpp"

namespace mgdt {

struct Regions {
    static constexpr std::uint32_t outside = 0xFFFFFFFFu;

    explicit Regions(Allocator& allocator)
        : of_tetrahedron(allocator),
          markers(allocator),
          unused_regions(allocator),
          unused_holes(allocator) {}

    Buffer<std::uint32_t> of_tetrahedron;  // its region, or `outside`
    Buffer<std::int32_t> markers;          // of each region
    bool has_inside = false;               // whether facets enclose something, holes included
    // Places of regions that are in no region, and holes that are in nothing that facets enclose.
    Buffer<std::uint32_t> unused_regions, unused_holes;
};

// Finds the regions. Two tetrahedra with a common face are in one region unless the face is a part
// of a facet. Tetrahedra that are connected to the outside of the hull or to a hole are in no
// region. The coordinates of the mesh are in steps of the grid. The marker of a region is that of
// the last of the caller's places inside of it, or 0.
Regions find_regions(const ConstrainedMesh& mesh, const RoundingGrid& grid,
                     const Buffer<DomainInput::Place>& regions,
                     const Buffer<DomainInput::Place>& holes, Allocator& allocator);

}  // namespace mgdt
