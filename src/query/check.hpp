// SPDX-License-Identifier: MIT
// Proof that a mesh is a Delaunay triangulation, by local tests in linear time.
#pragma once

#include "mesh/mesh.hpp"
#include "parallel/team.hpp"

namespace mgdt {

// Throws MGDT_ERR_CHECK_FAILED with a message that says what is wrong and where. `level` is an
// MGDT_CHECK_ value; `base` numbers points in messages.
void check_mesh(Team& team, const Mesh& mesh, const Buffer<VertexId>& point_map,
                Allocator& allocator, std::int32_t level, std::int32_t base);

}  // namespace mgdt
