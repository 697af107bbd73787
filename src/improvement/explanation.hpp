// SPDX-License-Identifier: MIT
// Why tetrahedra have stayed below a goal.
#pragma once

#include "improvement/flexible_mesh.hpp"

namespace mgdt {

enum class Reason : std::uint8_t {
    none,           // the tetrahedron reaches the goal
    input_angle,    // two of its faces are parts of facets, with an angle that is too small
    thin_face,      // it is at a corner of a face of a facet that has too small an angle itself
    fixed_corners,  // none of its corners may move
    other
};

// The reason for each slot of a mesh. Where several apply, it is the first one.
void explain(const FlexibleMesh& mesh, double goal, Buffer<Reason>& reasons);

}  // namespace mgdt
