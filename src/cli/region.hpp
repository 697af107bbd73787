// SPDX-License-Identifier: MIT
// The convex region to which Voronoi cells are clipped, as the command line gives it.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "cli/file_identity.hpp"

namespace mgdt::cli {

struct RegionOptions {
    // Six numbers, the least and the largest coordinates; or "auto" for those of the points; or
    // empty.
    std::string bounds;
    std::string planes;  // a file with a b c d in each line, or empty
};

using Planes = std::vector<std::array<double, 4>>;

// The planes of the region, which is where a x + b y + c z <= d; none if no region is given. Those
// of a box are in the order of Voro++'s walls: least x, largest x, least y, ...
// Adds the file of the planes to `inputs`.
Planes planes_of(const RegionOptions& options, const std::vector<double>& points,
                 std::vector<FileIdentity>& inputs);

}  // namespace mgdt::cli
