// SPDX-License-Identifier: MIT
// A mesh in which every triangle of a boundary is one face and every segment one edge.
#pragma once

#include "boundary/complex.hpp"
#include "domain/constrained_mesh.hpp"
#include "platform/stage_progress.hpp"

namespace mgdt {

// The mesh fills a box around the boundary. Vertices are numbered: first the points of the
// boundary, then those that were added, then the corners of the box. Faces are marked with the
// triangles that they are.
struct KeptBoundary {
    explicit KeptBoundary(Allocator& allocator)
        : points(allocator), mesh(points, allocator), lost_edge{no_index, no_index} {}

    Buffer<double> points;
    ConstrainedMesh mesh;
    // The ends of a segment that is missing, or those of a side of a triangle that is missing; or
    // no_index if nothing is.
    std::uint32_t lost_edge[2];
};

// Makes the mesh of a valid complex, which has a triangle. The result depends on the places of the
// points, not on their order or on the number of threads.
void keep_boundary(const Complex& complex, int threads, Allocator& allocator,
                   StageProgress& progress, KeptBoundary& result);

// Puts those of the added points first that tetrahedra of the domain have, in the order of their
// coordinates. Returns their number.
std::size_t sort_added_points(KeptBoundary& boundary, const Buffer<std::uint32_t>& regions,
                              std::size_t given, Allocator& allocator);

}  // namespace mgdt
