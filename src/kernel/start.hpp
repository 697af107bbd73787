// SPDX-License-Identifier: MIT
// Where a walk starts when the schedule gives no hint: at the nearest of a few vertices, as in
// jump-and-walk (Muecke, Saias, Zhu, Computational Geometry 12, 1999).
#pragma once

#include "mesh/mesh.hpp"

namespace mgdt {

// A finite tetrahedron at the nearest to q of about V^(1/4) sampled vertices and of `last`'s base
// vertex. Deterministic: the sample depends on q and the number of vertices alone.
TetId jump(const Mesh& mesh, const double* q, TetId last);

}  // namespace mgdt
