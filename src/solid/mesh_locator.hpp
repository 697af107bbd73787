// SPDX-License-Identifier: MIT
// Finds the tetrahedra of a mesh that contain places, also where the mesh is not convex.
#pragma once

#include "boundary/box_tree.hpp"
#include "solid/solid_mesh.hpp"

namespace mgdt {

class MeshLocator {
  public:
    MeshLocator(Allocator& allocator, const SolidMesh& mesh, const StopRequest& stop);

    // The first tetrahedron that contains a place, on its boundary or inside of it, exactly;
    // no_index if there is none. The result does not depend on `near`, a tetrahedron that is tried
    // first, or no_index.
    std::uint32_t locate(const double* place, std::uint32_t near) const;

  private:
    std::uint32_t walk(const double* place, std::uint32_t from) const;

    const SolidMesh& mesh_;
    Buffer<BoundingBox> boxes_;
    BoxTree tree_;
};

}  // namespace mgdt
