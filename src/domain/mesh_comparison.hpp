// SPDX-License-Identifier: MIT
// Whether a mesh is that of a domain.
#pragma once

#include "boundary/complex.hpp"
#include "platform/stage_progress.hpp"
#include "solid/solid_mesh.hpp"

namespace mgdt {

// Throws MGDT_ERR_CHECK_FAILED, with a message that says what is wrong and where, unless
// - the points of the input are those of the mesh;
// - every facet of the input is the union of faces that the mesh lists, exactly, and every segment
//   the union of edges that it lists;
// - the regions have the markers of the places in them, and contain no hole.
// The input is valid, and check_mesh() has found no defect. Which of the parts that facets enclose
// are filled is not found anew.
void compare_mesh(const DomainInput& input, const SolidMesh& mesh, std::int32_t index_base,
                  Allocator& allocator, StageProgress& progress);

}  // namespace mgdt
