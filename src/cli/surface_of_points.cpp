// SPDX-License-Identifier: MIT
#include "cli/surface_of_points.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

namespace mgdt::cli {

TriangulatedPoints triangulate_input(const InputOptions& input, const OutputOptions& output,
                                     TriangulationOptions options) {
    Opened opened = open_input(input, {output.path}, options.quiet);
    // The surface is then a function of the points alone, to the order of its triangles.
    options.canonical = true;
    Triangulation t = make_triangulation(options);
    insert(t, opened.mesh.points, opened.name, options.quiet);
    if (t.dimension() < 3 && !options.quiet)
        fmt::print(stderr, "mgdt: {}: {}, so there is no surface\n", opened.name, shape(t));
    return {std::move(opened.mesh), std::move(t)};
}

void write_surface(const Surface& surface, const Format& format, const OutputOptions& output) {
    OutputSet outputs;
    format.write_surface(surface, outputs.open(output.path), output.write);
    outputs.commit();
}

std::string shown(double x) {
    return std::isfinite(x) ? fmt::format("{:.6g}", x) : "beyond doubles";
}

}  // namespace mgdt::cli
