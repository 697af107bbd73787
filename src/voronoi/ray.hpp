// SPDX-License-Identifier: MIT
// The direction of an unbounded edge of the Voronoi diagram.
#pragma once

#include "platform/memory.hpp"

namespace mgdt {

// The unit normal of the triangle abc, on the side from which it is counter-clockwise. The error of
// a coordinate is below 2^-50.
void unit_normal(Allocator& allocator, const double* a, const double* b, const double* c,
                 double (&normal)[3]);

}  // namespace mgdt
