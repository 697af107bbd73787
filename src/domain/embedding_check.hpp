// SPDX-License-Identifier: MIT
// Whether the tetrahedra of a domain's mesh leave out nothing and do not overlap.
#pragma once

#include "domain/domain_mesh.hpp"
#include "platform/stage_progress.hpp"

namespace mgdt {

// Throws MGDT_ERR_CHECK_FAILED if a tetrahedron meets one of these, elsewhere than in common
// corners, edges and faces: one face of each sheet of faces with a side without a tetrahedron, a
// point that is no corner of a tetrahedron, or a listed edge that is no edge of one. If no
// tetrahedron does, tetrahedra do not overlap, and all points and listed edges that are inside of
// the domain are in the mesh (docs/theory.md, "Meshes of domains"). The tetrahedra are positive,
// and the faces are those at which they end.
void check_embedding(const DomainMesh& mesh, std::int32_t index_base, Allocator& allocator,
                     StageProgress& progress);

}  // namespace mgdt
