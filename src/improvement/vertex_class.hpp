// SPDX-License-Identifier: MIT
// Where a vertex of a mesh may move.
#pragma once

#include <cstdint>

namespace mgdt {

enum class Freedom : std::uint8_t {
    fixed,
    on_line,   // on the line of the two edges that the vertex is between
    in_plane,  // in the plane of the one facet that the vertex is inside of
    free
};

struct VertexClass {
    Freedom freedom;
    bool may_leave;       // whether the mesh may lose the vertex
    double direction[3];  // the unit vector of its line, or the unit normal of its plane

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

inline constexpr VertexClass free_vertex = {Freedom::free, true, {0, 0, 0}};

}  // namespace mgdt
