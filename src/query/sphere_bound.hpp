// SPDX-License-Identifier: MIT
// Whether a stored sphere is within its error bound, for the check.
#pragma once

#include "mesh/tetrahedron.hpp"

namespace mgdt {

// Whether the stored sphere of a tetrahedron, or the normal of a ghost, differs from the exact one
// by no more than its error bound, so that the filter may decide with it. If the filters are not
// proved for a vertex, the bound must be infinite. See docs/theory.md, "What the check proves".
bool sphere_is_within_bound(const Sphere& s, const Tetrahedron& t, const Vertex* vertices);

}  // namespace mgdt
