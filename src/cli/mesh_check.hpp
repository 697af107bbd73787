// SPDX-License-Identifier: MIT
// Checks by exact arithmetic that tetrahedra from any program are a Delaunay triangulation of their
// points. If five or more points are on one sphere, there may be several; each is accepted.
//
// These tests are made:
//   orientation  All tetrahedra have positive volume. If all have negative volume, which is the
//                convention of some programs, their orientation is reversed first.
//   facets       A facet belongs to at most two tetrahedra, which lie on opposite sides of it.
//   spheres      For every shared facet, neither opposite vertex is inside the circumsphere of the
//                tetrahedron on the other side.
//   hull         The boundary consists of the facets that belong to one tetrahedron. Two boundary
//                facets meet at each boundary edge, and neither is beyond the plane of the other. A
//                point inside the first tetrahedron is beyond no boundary facet.
//   cover        That point is in no other tetrahedron.
//   vertices     Every point is a vertex.
// docs/theory.md, "What the check proves", shows that tetrahedra which pass these tests are a
// Delaunay triangulation of the points.
//
// A constrained mesh may have a concave boundary, and tetrahedra that are not Delaunay. It has to
// pass orientation, facets and cover, and the next test:
//   boundary     An even number of boundary facets meet at each edge of the boundary. Whether
//                boundary facets cross is tested by the caller.
// The report also has a line "Delaunay", which counts the shared facets that have an opposite
// vertex inside a circumsphere and are not constrained. It is never bad.
#pragma once

#include <string>
#include <vector>

#include "cli/formats/file_mesh.hpp"

namespace mgdt::cli {

struct Finding {
    const char* what;
    bool good;
    std::string detail;
};

// The canonical triangulation of the same points, from the library.
struct Reference {
    std::vector<MeshIndex> tetrahedra;
    std::vector<MeshIndex> point_map;  // the vertex of each point; equal points have the same
};

struct MeshReport {
    std::vector<Finding> findings;
    bool valid = true;
    std::size_t in_common = 0;  // the number of tetrahedra that the reference has too
};

MeshReport check_mesh(const Mesh& mesh, const Reference& reference);

struct ConstrainedReport {
    MeshReport report;
    std::vector<MeshIndex> boundary;  // the corners of the boundary facets, 3 each
};

// The triangles of `mesh.facets` are the constrained facets.
ConstrainedReport check_constrained_mesh(const Mesh& mesh, const Reference& reference);

}  // namespace mgdt::cli
