// SPDX-License-Identifier: MIT
// The shapes of all tetrahedra of a mesh, in a few numbers.
#pragma once

#include "parallel/team.hpp"
#include "platform/stage_progress.hpp"
#include "solid/solid_mesh.hpp"

namespace mgdt {

// Angles are in degrees. An angle that is a multiple of 5 degrees but for rounding counts as that
// multiple.
struct ShapeSummary {
    static constexpr int angle_bins = 18, bounds = 6;
    static constexpr int bound_degrees[bounds] = {5, 10, 15, 20, 25, 30};

    double least_angle = 0, largest_angle = 0;  // of all dihedral angles
    double mean_volume_length = 0;              // TetrahedronMeasure::volume_length
    // Dihedral angles from 10 i degrees on, below 10 (i + 1) degrees; there are six for each
    // tetrahedron.
    std::uint64_t angles[angle_bins] = {};
    // Tetrahedra with an angle below each of the bounds.
    std::uint64_t tetrahedra_below[bounds] = {};
};

// The result does not depend on the number of threads.
ShapeSummary summarize_shapes(const SolidMesh& mesh, Team& team, Allocator& allocator,
                              StageProgress& progress);

}  // namespace mgdt
