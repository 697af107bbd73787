// SPDX-License-Identifier: MIT
// The sizes of edges that are wanted at the vertices of a mesh.
#pragma once

#include "platform/stage_progress.hpp"
#include "refinement/refined_mesh.hpp"
#include "solid/solid_mesh.hpp"

namespace mgdt {

// The lengths of edges that a caller asks for at points, in tetrahedra and in regions, in the units
// of the caller's coordinates. A length of 0 means that the caller asks for none.
struct SizeWishes {
    explicit SizeWishes(Allocator& allocator)
        : of_points(allocator), of_tetrahedra(allocator), of_regions(allocator) {}

    Buffer<double> of_points;      // empty, or one for each point
    Buffer<double> of_tetrahedra;  // empty, or one for each tetrahedron
    Buffer<double> of_regions;     // empty, or one for each region
};

// Sets the sizes of the vertices of a mesh: at each the least wish, or infinity where there is
// none. `everywhere` is one more wish. With `are_of_surface`, the mean length of the edges of faces
// at a vertex is one, too. `scale` is what the caller's lengths are multiplied by.
void set_sizes(RefinedMesh& mesh, const SolidMesh& solid, const SizeWishes& wishes,
               double everywhere, bool are_of_surface, double scale);

// Lowers sizes until none exceeds that of a neighbour by more than the gradation times their
// distance. What is within `tolerance`, a share, of that stays. Returns whether a size has changed.
bool limit_sizes(RefinedMesh& mesh, double tolerance, StageProgress& progress);

}  // namespace mgdt
