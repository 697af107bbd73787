// SPDX-License-Identifier: MIT
// Creates the first tetrahedra of a mesh.
#pragma once

#include "core/state.hpp"

namespace mgdt {

// Makes the tetrahedron of vertices 1 to 4, which span space, and its four ghosts.
void make_first_tetrahedra(State& state);

}  // namespace mgdt
