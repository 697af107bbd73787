// SPDX-License-Identifier: MIT
// The circumspheres of a star: w and e of the new tetrahedron of each facet (a, b, c) of local
// numbers. set_sphere() of circumsphere.hpp defines w and e of a finite tetrahedron; set_normal()
// defines w and e of a ghost, where b or c is the vertex at infinity. `infinite` is the number of
// the vertex at infinity, or no_index. Each island has
//
//   set_spheres_small(w, vertices, q, count, infinite, spheres, link)
//       for a small star; also calls link(i, t) for the tetrahedron t of each facet i, since the
//       processor has time for that while it computes spheres
//   set_spheres(w, vertices, q, count, infinite, spheres)
//       for a star of any size
#pragma once

#include "kernel/island.hpp"
#include MGDT_IN_ISLAND(spheres.hpp)
