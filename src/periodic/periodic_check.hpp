// SPDX-License-Identifier: MIT
// The check of a periodic triangulation, which uses its points and tetrahedra alone.
#pragma once

#include "periodic/periodic.hpp"

namespace mgdt {

// Throws MGDT_ERR_CHECK_FAILED if the tetrahedra, one of each class, are not the Delaunay
// triangulation of the infinite periodic set, with ties broken by the perturbation. docs/theory.md,
// "Periodic boxes", has a proof. If the points of a slab or a wire do not span space, there are no
// tetrahedra, which passes the check.
void check_periodic(const Periodic& periodic, const Buffer<PeriodicTetrahedra::Record>& tetrahedra,
                    StageProgress& progress);
// Checks the tetrahedra of the last build.
void check_periodic(const Periodic& periodic, StageProgress& progress);

}  // namespace mgdt
