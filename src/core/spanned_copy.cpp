// SPDX-License-Identifier: MIT
#include "core/spanned_copy.hpp"

#include <algorithm>
#include <cmath>

#include "mesh/scale.hpp"
#include "platform/error.hpp"

namespace mgdt {

void copy_spanned(const Triangulation& flat, double reach, std::size_t points,
                  Triangulation& copy) {
    const Mesh& mesh = flat.mesh();
    Buffer<std::uint32_t> indices(copy.allocator());
    Buffer<double> xyz(copy.allocator());
    for (VertexId v = 1; v < mesh.vertices.size(); ++v) {
        indices.push_back(mesh.vertices[v].index);
        for (int c = 0; c < 3; ++c) xyz.push_back(scaled(mesh.point(v)[c], -mesh.scale));
    }
    // The corners of a tetrahedron about the first vertex: 8 sqrt(3) times the reach away from it.
    constexpr int corner[far_points][3] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    for (std::size_t k = 0; k < far_points; ++k) {
        indices.push_back(static_cast<std::uint32_t>(points + k));
        for (std::size_t c = 0; c < 3; ++c) {
            const double x = xyz[c] + corner[k][c] * 8 * reach;
            if (!std::isfinite(x))
                fail(MGDT_ERR_INVALID_ARGUMENT,
                     "the points do not span space, and the region is too large for doubles");
            xyz.push_back(x);
        }
    }
    const double* const axis[3] = {xyz.begin(), xyz.begin() + 1, xyz.begin() + 2};
    copy.insert(indices.size(), axis, 3);
    copy.set_indices(indices);
}

}  // namespace mgdt
