// SPDX-License-Identifier: MIT
// Whether the tetrahedra of a mesh overlap or leave gaps.
#pragma once

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

}  // namespace mgdt
