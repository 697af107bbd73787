// SPDX-License-Identifier: MIT
// A mesh that a caller gives as lists of tetrahedra, faces and edges.
#pragma once

#include "parallel/team.hpp"
#include "platform/stage_progress.hpp"
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
    // All corners and ends are numbers of points. A list of markers has one for each item that it
    // marks, or is empty.
    Buffer<std::uint32_t> tetrahedra;
    Buffer<std::int32_t> tetrahedron_markers;
    Buffer<std::uint32_t> faces;
    Buffer<std::int32_t> face_markers;
    Buffer<std::uint32_t> edges;
    Buffer<std::int32_t> edge_markers;
};

// Makes a mesh of the caller's tetrahedra, which keep their numbers. Their corners may have any
// order; the last two of a negative tetrahedron are exchanged. All tetrahedra with the same marker
// form a region. The mesh lists the caller's faces, then the other faces at which it ends or
// regions meet. Listed faces that continue each other in one plane form a facet. The mesh lists the
// caller's edges, then the other edges at which facets end. Throws
// MGDT_ERR_INVALID_ARGUMENT, with the number of what is wrong, if a tetrahedron is flat, if
// more than two tetrahedra have a face in common or two are on the same side of one, or if no
// tetrahedron has a listed face or edge.
void link_mesh(const GivenMesh& given, std::int32_t index_base, Team& team, Allocator& allocator,
               StageProgress& progress, SolidMesh& out);

}  // namespace mgdt
