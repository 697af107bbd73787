// SPDX-License-Identifier: MIT
// Where a walk starts when the schedule gives no hint: at the nearest of a few vertices, as in
// jump-and-walk (Muecke, Saias, Zhu, Computational Geometry 12, 1999).
#pragma once

#include "mesh/mesh.hpp"

namespace mgdt {

// A tetrahedron at the nearest to q of about V^(1/4) vertices sampled from 1 to V = `vertices`, and
// of `last`'s base vertex. Deterministic: the sample depends on q and V alone.
TetId jump(const Mesh& mesh, std::size_t vertices, const double* q, TetId last);

}  // namespace mgdt
