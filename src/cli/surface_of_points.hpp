// SPDX-License-Identifier: MIT
// What the commands share that write a surface of points.
#pragma once

#include "cli/opening.hpp"
#include "cli/program_triangulation.hpp"

namespace mgdt::cli {

struct TriangulatedPoints {
    Mesh mesh;
    Triangulation triangulation;
};
// Reads the points, and triangulates them. Says why there is no surface, if there is none.
TriangulatedPoints triangulate_input(const InputOptions& input, const OutputOptions& output,
                                     TriangulationOptions options);

void write_surface(const Surface& surface, const Format& format, const OutputOptions& output);

// A volume or an area for a message.
std::string shown(double x);

}  // namespace mgdt::cli
