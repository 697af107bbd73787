// SPDX-License-Identifier: MIT
// Volume, shape and size of the tetrahedra of a mesh, with the coordinates that the caller reads.
#pragma once

#include "parallel/team.hpp"
#include "platform/stage_progress.hpp"
#include "query/tetrahedron_measures.hpp"
#include "solid/solid_mesh.hpp"

namespace mgdt {

// Writes a measure of each tetrahedron.
void measure_tetrahedra(const SolidMesh& mesh, TetrahedronMeasure measure, Team& team,
                        Allocator& allocator, StageProgress& progress, double* x);

}  // namespace mgdt
