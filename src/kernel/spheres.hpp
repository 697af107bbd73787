// SPDX-License-Identifier: MIT
// The circumspheres of a star: for each facet (a, b, c) of local numbers, w and e of its new
// tetrahedron, as set_sphere() of circumsphere.hpp computes them; for a ghost, where b or c is the
// vertex at infinity, its normal, as set_normal() does. `infinite` is the number of that vertex, or
// no_index. Each island has
//
//   set_spheres_small(w, vertices, q, count, infinite, spheres, link)   of a small star; calls
//       link(i, t) for the tetrahedron t of each facet i, since the processor has time for that
//       while it computes spheres
//   set_spheres(w, vertices, q, count, infinite, spheres)               of any
#pragma once

#include "kernel/island.hpp"
#include MGDT_IN_ISLAND(spheres.hpp)
