// SPDX-License-Identifier: MIT
// A surface of triangles, as it is written to files.
#pragma once

#include <vector>

#include "cli/formats/file_mesh.hpp"

namespace mgdt::cli {

struct Surface {
    std::vector<double> points;  // x y z of each point
    // 3 corners per triangle, counter-clockwise where it is seen from outside.
    std::vector<MeshIndex> triangles;

    std::size_t point_count() const { return points.size() / 3; }
    std::size_t triangle_count() const { return triangles.size() / 3; }
};

}  // namespace mgdt::cli
