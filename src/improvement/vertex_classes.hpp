// SPDX-License-Identifier: MIT
// Finds out where the vertices of a mesh may move.
#pragma once

#include "improvement/flexible_mesh.hpp"

namespace mgdt {

// What the caller allows for a vertex.
enum class Permission : std::uint8_t { none, to_move, to_leave };

// Classifies all vertices. Without `slides`, vertices of faces and edges that the mesh keeps are
// fixed.
void classify_vertices(FlexibleMesh& mesh, const Buffer<Permission>& permissions, bool slides);

}  // namespace mgdt
