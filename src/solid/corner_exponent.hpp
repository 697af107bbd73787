// SPDX-License-Identifier: MIT
// The scale of a mesh.
#pragma once

#include <algorithm>
#include <cmath>

#include "mesh/scale.hpp"
#include "solid/solid_mesh.hpp"

namespace mgdt {

// The least e such that the coordinates of all corners of tetrahedra are below 2^e in magnitude.
// Points of no tetrahedron, which may be anywhere, do not count.
inline int corner_exponent(const SolidMesh& mesh) {
    double largest = 0;
    for (const std::uint32_t v : mesh.tetrahedra)
        for (std::size_t k = 3 * std::size_t{v}; k < 3 * std::size_t{v} + 3; ++k)
            largest = std::max(largest, std::fabs(mesh.points[k]));
    return exponent_above(&largest, 1);
}

}  // namespace mgdt
