// SPDX-License-Identifier: MIT
// The sizes of edges that are wanted at the vertices of a mesh.
#pragma once

#include "platform/stage_progress.hpp"
#include "refinement/refined_mesh.hpp"
#include "refinement/size_sampler.hpp"
#include "solid/solid_mesh.hpp"

namespace mgdt {

// The lengths of edges that a caller asks for at points, in tetrahedra and in regions, in the units
// of the caller's coordinates. A length of 0 means that the caller asks for none.
struct SizeWishes {
    explicit SizeWishes(Allocator& allocator)
        : of_points(allocator),
          of_tetrahedra(allocator),
          of_regions(allocator),
          varying(allocator) {}

    Buffer<double> of_points;      // empty, or one for each point
    Buffer<double> of_tetrahedra;  // empty, or one for each tetrahedron
    Buffer<double> of_regions;     // empty, or one for each region
    VaryingSizes varying;
};

// Sets the sizes of the vertices of a mesh, and its sizes at places, which need no vertices: at
// each vertex the least wish, or infinity where there is none. `everywhere` is one more wish. With
// `are_of_surface`, the mean length of the edges of faces at a vertex is one, too. `scale` is what
// the caller's lengths are multiplied by. Sizes that vary in space are added later.
void set_sizes(RefinedMesh& mesh, const SolidMesh& solid, const SizeWishes& wishes,
               double everywhere, bool are_of_surface, double scale, StageProgress& progress);

// Adds sizes that vary in space: first those at the vertices alone, and then a tree for the rest,
// of at most about `most_cells` cells.
void add_sizes_at_vertices(RefinedMesh& mesh, SizeSampler& sampler, StageProgress& progress);
void add_varying_sizes(RefinedMesh& mesh, SizeSampler& sampler, std::size_t most_cells,
                       StageProgress& progress);

// Lowers sizes until none exceeds that of a neighbour by more than the gradation times their
// distance. What is within `tolerance`, a share, of that stays. Returns whether a size has changed.
bool limit_sizes(const RefinedMesh& mesh, Buffer<double>& sizes, double tolerance,
                 StageProgress& progress);

}  // namespace mgdt
