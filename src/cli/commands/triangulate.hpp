// SPDX-License-Identifier: MIT
// The options of mgdt triangulate, and its ways that have files of their own.
#pragma once

#include <string>

#include "cli/opening.hpp"
#include "cli/periodic_box.hpp"
#include "cli/program_triangulation.hpp"

namespace mgdt::cli {

struct TriangulateOptions {
    InputOptions input;
    OutputOptions output;
    TriangulationOptions triangulation;
    std::string neighbors;    // .npy file, or empty
    std::string point_map;    // .npy file, or empty
    bool all_points = false;  // also write points that are in no tetrahedron
    int check_level = 0;
    double drop_flat = 0;  // the radius ratio below which tetrahedra are taken off the hull
    bool statistics = false;
    int parts = 0;  // number of parts; 0 for one triangulation
    PeriodicOptions periodic;
    std::string images;  // a .csv file of the images that are nodes, or empty
};

// Each returns an exit code or throws Error.
int triangulate_in_parts(const TriangulateOptions& options);
int triangulate_in_box(const TriangulateOptions& options);

}  // namespace mgdt::cli
