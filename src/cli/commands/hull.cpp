// SPDX-License-Identifier: MIT
// mgdt hull: reads points and writes the surface of their convex hull.
#include <fmt/core.h>

#include <functional>
#include <memory>

#include "cli/commands/arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/help.hpp"
#include "cli/counts.hpp"
#include "cli/errors.hpp"
#include "cli/solids.hpp"
#include "cli/surface_of_points.hpp"

namespace mgdt::cli {
namespace {

struct HullOptions {
    InputOptions input;
    OutputOptions output;
    TriangulationOptions triangulation;
};

int write_hull(const HullOptions& options) {
    const Format& format = surface_format(options.output);
    check_writable(options.output.path);
    Surface surface;
    std::size_t n_points = 0;
    {
        const auto [mesh, t] =
            triangulate_input(options.input, options.output, options.triangulation);
        n_points = mesh.point_count();
        std::vector<MeshIndex> triangles(3 * static_cast<std::size_t>(t.hull_facet_count()));
        t.hull_facets(triangles);
        surface = with_own_points(triangles, mesh.points);
    }
    write_surface(surface, format, options.output);
    if (!options.triangulation.quiet && options.output.path != "-") {
        fmt::print("{}, {} on the hull, {}, volume {}, area {}: {}\n",
                   counted(n_points, "point", "points"), surface.point_count(),
                   counted(surface.triangle_count(), "triangle", "triangles"),
                   shown(volume_inside(surface)), shown(area_of(surface)),
                   printable(options.output.path));
    }
    return exit_ok;
}

}  // namespace

const Command hull_command = {"hull", "Read points, write the surface of their convex hull.",
                              [](CLI::App& app) -> std::function<int()> {
                                  const auto options = std::make_shared<HullOptions>();
                                  add_input(app, options->input, "Points; - for standard input");
                                  add_output(app, options->output, true);
                                  add_compress(app, options->output);
                                  add_triangulation(app, options->triangulation);
                                  app.footer(formats_and_exit_codes);
                                  return [options] { return write_hull(*options); };
                              }};

}  // namespace mgdt::cli
