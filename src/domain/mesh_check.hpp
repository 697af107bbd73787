// SPDX-License-Identifier: MIT
// Whether a mesh is that of a domain.
#pragma once

#include "domain/domain_mesh.hpp"

namespace mgdt {

// Throws MGDT_ERR_CHECK_FAILED, with a message that says what is wrong and where, unless
// - every tetrahedron is positive, and neighbours share a face;
// - every facet of the input is the union of faces that the mesh lists, exactly, and every segment
//   the union of its parts;
// - the regions end at these faces, have the markers of the places in them, and contain no hole;
// - tetrahedra do not overlap, and no point and no segment that is not of the mesh is inside of it;
// - every other face is locally Delaunay, so that the mesh is the constrained Delaunay
//   triangulation (docs/theory.md, "Meshes of domains").
// Which of the parts that facets enclose are filled is not found anew. The input is valid. The
// check uses nothing of what the build computed but the mesh.
void check_mesh(const DomainInput& input, const DomainMesh& mesh, std::int32_t index_base,
                Allocator& allocator);

}  // namespace mgdt
