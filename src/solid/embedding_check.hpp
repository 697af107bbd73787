// SPDX-License-Identifier: MIT
// Whether the tetrahedra of a mesh overlap or leave gaps.
#pragma once

#include "parallel/team.hpp"
#include "platform/stage_progress.hpp"
#include "solid/solid_mesh.hpp"

namespace mgdt {

// Throws MGDT_ERR_CHECK_FAILED if a tetrahedron meets one of the following simplices elsewhere than
// in a common corner, edge or face: points that are no corner of a tetrahedron; listed edges that
// are no edge of a tetrahedron; and boundary faces, which have no tetrahedron on one side. Of each
// connected sheet of boundary faces, one is tested. If the check passes, the tetrahedra do not
// overlap, and all points and listed edges inside of the domain are in the mesh (docs/theory.md,
// "Meshes of domains"). The caller has checked that the tetrahedra are positive, and that the
// listed faces are those at which they end.
void check_embedding(const SolidMesh& mesh, std::int32_t index_base, Allocator& allocator,
                     StageProgress& progress);

// Whether boundary faces meet in common corners and edges alone, and no tetrahedron overlaps
// another one. The mesh is as check_embedding() takes it. Where the boundary is one sheet, this
// takes a test of the boundary alone: tetrahedra that are positive and linked cover a place as
// often as the boundary winds around it, and a closed surface that does not meet itself winds once
// around what is inside of it.
bool is_embedded(const SolidMesh& mesh, Team& team, Allocator& allocator, StageProgress& progress);

}  // namespace mgdt
