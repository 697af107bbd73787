// SPDX-License-Identifier: MIT
// Whether tetrahedra from any program are a Delaunay triangulation of their points, by exact
// arithmetic. Where five or more points are on one sphere there are several; each is accepted.
//
// What is tested, all of it exactly:
//   orientation  every tetrahedron has positive volume (or every one negative volume, which is
//                another program's convention, and they are turned round);
//   facets       no facet belongs to more than two tetrahedra, and two lie on opposite sides;
//   spheres      across every shared facet, no opposite vertex is inside the circumsphere;
//   hull         the facets of single tetrahedra, the boundary, meet two at an edge, neither beyond
//                the other's plane, and a point inside the first tetrahedron is beyond none;
//   cover        that point is in no other tetrahedron;
//   vertices     every point is a vertex.
// That these make a Delaunay triangulation of the points is proved in docs/theory.md, "What the
// check proves".
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

}  // namespace mgdt::cli
