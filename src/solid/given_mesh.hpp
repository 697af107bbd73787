// SPDX-License-Identifier: MIT
// A mesh that a caller gives as lists of tetrahedra, faces and edges.
#pragma once

#include "solid/solid_mesh.hpp"

namespace mgdt {

struct GivenMesh {
    explicit GivenMesh(Allocator& allocator)
        : points(allocator),
          tetrahedra(allocator),
          tetrahedron_markers(allocator),
          faces(allocator),
          face_markers(allocator),
          edges(allocator),
          edge_markers(allocator) {}

    Buffer<double> points;
    // Corners are below the number of points. Markers are as many as what they mark, or none.
    Buffer<std::uint32_t> tetrahedra;
    Buffer<std::int32_t> tetrahedron_markers;
    Buffer<std::uint32_t> faces;
    Buffer<std::int32_t> face_markers;
    Buffer<std::uint32_t> edges;
    Buffer<std::int32_t> edge_markers;
};

// Makes a mesh of the caller's tetrahedra, whose corners may have any order. A region is the
// tetrahedra of one marker. The faces of the mesh are the caller's, those where it ends, and those
// between regions; its edges are the caller's, and those of faces that do not continue each other
// in one plane. Such faces form a facet. Throws MGDT_ERR_INVALID_ARGUMENT, with the number of what
// is wrong, if a tetrahedron is flat, if tetrahedra at a face are more than two or on the same side
// of it, or if a face or an edge is none of a tetrahedron.
void link_mesh(const GivenMesh& given, std::int32_t index_base, Allocator& allocator,
               SolidMesh& out);

}  // namespace mgdt
