// SPDX-License-Identifier: MIT
// Where the vertices of a mesh may move.
#pragma once

#include "improvement/flexible_mesh.hpp"

namespace mgdt {

enum class Freedom : std::uint8_t {
    fixed,
    on_line,   // on the line of the two edges that the vertex is between
    in_plane,  // in the plane of the one facet that the vertex is inside of
    free
};

// What a vertex may do, and the unit vector of its line, or the unit normal of its plane.
struct VertexClass {
    Freedom freedom;
    double direction[3];

    // Removes the part of a vector along which the vertex may not move.
    void project(double (&v)[3]) const noexcept {
        if (freedom == Freedom::free) return;
        const double along = (v[0] * direction[0] + v[1] * direction[1]) + v[2] * direction[2];
        for (int k = 0; k < 3; ++k)
            v[k] = freedom == Freedom::in_plane  ? v[k] - along * direction[k]
                   : freedom == Freedom::on_line ? along * direction[k]
                                                 : 0.0;
    }
};

// Classifies all vertices. Those for which `stays` is not 0 are fixed, and without `slides` all
// vertices of faces and edges that the mesh keeps.
void classify_vertices(const FlexibleMesh& mesh, const Buffer<std::uint8_t>& stays, bool slides,
                       Buffer<VertexClass>& classes);

}  // namespace mgdt
