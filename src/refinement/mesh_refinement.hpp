// SPDX-License-Identifier: MIT
// The refinement of a mesh as a caller asks for it: with options, and a report.
#pragma once

#include "kernel/kernel.hpp"
#include "parallel/team.hpp"
#include "platform/stage_progress.hpp"
#include "refinement/refined_mesh.hpp"
#include "refinement/vertex_sizes.hpp"

namespace mgdt {

struct RefinementOptions {
    // What the options are below.
    static constexpr double bound = 1e300, gradation_bound = 1e6;

    double size = 0;           // of edges everywhere, or 0
    double gradation = 0.3;    // how fast sizes grow with the distance
    double radius_edge = 1.4;  // the most circumradius per shortest edge, or 0 for no bound
    double volume = 0;         // the most volume of a tetrahedron, or 0
    bool sizes_of_surface = false;
    bool divides_walls = false;    // whether points may be inserted in facets and on segments
    std::int32_t most_points = 0;  // the most that are inserted, or 0
};

struct RefinementReport {
    explicit RefinementReport(Allocator& allocator) : refusals(allocator), sizes(allocator) {}

    void clear() noexcept {
        is_made = false;
        refusals.reset();
        sizes.reset();
        inserted = refused = 0;
    }

    bool is_made = false;
    std::size_t inserted = 0;  // points
    std::size_t refused = 0;   // tetrahedra that are left beyond the bounds
    Buffer<Refusal> refusals;  // of each tetrahedron of the mesh
    Buffer<double> sizes;      // that were wanted at each of its points; 0 for none
};

// Inserts points into a mesh until its tetrahedra are within the bounds. If the call is cancelled
// or memory runs out, the mesh and the report stay as they were.
void refine_mesh(SolidMesh& mesh, const RefinementOptions& options, const SizeWishes& wishes,
                 Team& team, Allocator& allocator, StageProgress& progress,
                 RefinementReport& report);

}  // namespace mgdt
