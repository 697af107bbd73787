// SPDX-License-Identifier: MIT
// A part of a plane that several polygons bound, as TetGen's facets are.
#pragma once

#include <vector>

#include "cli/formats/file_facets.hpp"

namespace mgdt::cli {

// Adds facets that fill what the polygons bound, except where a hole is. A polygon inside of
// another one divides it. A facet around others walks to each of them and back. Polygons of two
// corners become segments; those of one corner are left out, since every point is in the mesh.
// Returns false if polygons cross.
bool add_planar_region(const std::vector<double>& points,
                       std::vector<std::vector<std::int64_t>> polygons,
                       const std::vector<std::array<double, 3>>& holes, std::int32_t marker,
                       FileFacets& facets);

}  // namespace mgdt::cli
