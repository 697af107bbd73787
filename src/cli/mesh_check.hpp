// SPDX-License-Identifier: MIT
// Whether tetrahedra from any program are a Delaunay triangulation of their points, by exact
// arithmetic. Where five or more points are on one sphere there are several; each is accepted.
//
// What is proved, with T the tetrahedra and H the convex hull of the points:
//   orientation  every tetrahedron has positive volume (or every one negative volume, which is
//                another program's convention, and they are turned round);
//   facets       no facet belongs to more than two tetrahedra, and two lie on opposite sides;
//   hull         every facet of a single tetrahedron lies in the boundary of H;
//   volume       the volumes add up to that of H;
//   spheres      across every shared facet, no opposite vertex is inside the circumsphere;
//   vertices     every point is a vertex.
// By facets and hull, the number of tetrahedra that cover a point inside H is the same
// everywhere, as it can change only at facets of a single one; by orientation and volume it is
// 1. So T is a triangulation of H, and one that is Delaunay at every facet is Delaunay
// (Delaunay's lemma).
#pragma once

#include <string>
#include <vector>

#include "cli/formats/mesh.hpp"

namespace mgdt::cli {

struct Finding {
    const char* what;
    bool good;
    std::string detail;
};

// The canonical triangulation of the same points, from the library.
struct Reference {
    std::vector<std::int64_t> tetrahedra;
    std::vector<std::int64_t> hull_facets;  // 3 vertices each, counter-clockwise from outside
    std::vector<std::int64_t> point_map;    // equal points to one vertex
};

struct MeshReport {
    std::vector<Finding> findings;
    bool valid = true;
    std::size_t in_common = 0;  // tetrahedra that the reference has too
};

MeshReport check_mesh(const Mesh& mesh, const Reference& reference);

}  // namespace mgdt::cli
