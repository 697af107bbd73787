// SPDX-License-Identifier: MIT
// Whether a mesh is valid in itself.
#pragma once

#include "platform/stage_progress.hpp"
#include "solid/solid_mesh.hpp"

namespace mgdt {

// Throws MGDT_ERR_CHECK_FAILED, with a message that says what is wrong and where, unless
// - every tetrahedron is positive, and neighbours share a face;
// - every Steiner point is on its edge, if the mesh is constrained Delaunay;
// - regions end at the faces that the mesh lists, and nowhere else;
// - tetrahedra do not overlap, and no edge of the mesh that is not of a tetrahedron is inside of
// one,
//   nor, if the mesh is constrained Delaunay, a point;
// - every other face is locally Delaunay, if the mesh says that it is the constrained Delaunay
//   triangulation (docs/theory.md, "Meshes of domains").
void check_mesh(const SolidMesh& mesh, std::int32_t index_base, Allocator& allocator,
                StageProgress& progress);

}  // namespace mgdt
