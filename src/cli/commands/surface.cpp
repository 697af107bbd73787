// SPDX-License-Identifier: MIT
// mgdt surface: reads points and writes the surface of their alpha shape.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <optional>

#include "cli/commands/arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/help.hpp"
#include "cli/counts.hpp"
#include "cli/errors.hpp"
#include "cli/formats/number.hpp"
#include "cli/solids.hpp"
#include "cli/surface_of_points.hpp"

namespace mgdt::cli {
namespace {

struct SurfaceOptions {
    InputOptions input;
    OutputOptions output;
    std::string alpha = "auto";  // the radius of the alpha shape; or "auto" for one solid
    bool largest = false;        // write the solid of largest volume only
    TriangulationOptions triangulation;
};

// The square of the radius, or no value for "auto".
std::optional<double> squared_alpha(const std::string& text) {
    if (text == "auto") return {};
    double radius = 0;
    if (!is_value(parse_number(text, radius)) || !(radius >= 0)) {
        throw Error(
            exit_usage,
            fmt::format("--alpha is {}; a radius of at least 0 or auto is needed", quote(text)));
    }
    const double square = radius * radius;
    if (std::isfinite(radius) && radius > 0 && !(square > 0 && std::isfinite(square)))
        throw Error(exit_usage, fmt::format("--alpha is {}, whose square is beyond doubles; scale "
                                            "the points and the radius",
                                            quote(text)));
    return square;
}

// A radius whose square is not below this one, so that --alpha takes it.
double radius_of(double alpha2) {
    double radius = std::sqrt(alpha2);
    while (radius * radius < alpha2) radius = std::nextafter(radius, HUGE_VAL);
    return radius;
}

int write_alpha_surface(const SurfaceOptions& options) {
    const Format& format = surface_format(options.output);
    check_writable(options.output.path);
    std::optional<double> alpha2 = squared_alpha(options.alpha);
    Surface surface;
    std::size_t n_solids = 0, n_points = 0;
    {
        auto [mesh, t] = triangulate_input(options.input, options.output, options.triangulation);
        n_points = mesh.point_count();
        if (!alpha2) {
            alpha2 = t.dimension() < 3 ? 0 : t.solid_alpha();
            if (t.dimension() == 3 && !(*alpha2 > 0 && std::isfinite(*alpha2)))
                throw Error(exit_input, fmt::format("{}: the square of the least radius is beyond "
                                                    "doubles; scale the points",
                                                    input_name(options.input.path)));
        }
        mesh.tetrahedra = tetrahedra(t);
        mesh.neighbors = neighbors(t);
        std::vector<bool> is_in_body;
        for (const double x : t.alphas(3)) is_in_body.push_back(x <= *alpha2);
        t = Triangulation();
        const Solids solids = find_solids(is_in_body, mesh.neighbors);
        n_solids = solids.count;
        if (options.largest && n_solids > 1) {
            const std::vector<double> volumes = volumes_of(solids, mesh);
            const auto largest = static_cast<MeshIndex>(
                std::max_element(volumes.begin(), volumes.end()) - volumes.begin());
            for (std::size_t i = 0; i < is_in_body.size(); ++i)
                is_in_body[i] = solids.of_tetrahedron[i] == largest;
        }
        surface = with_own_points(surface_of(is_in_body, mesh, mesh.neighbors), mesh.points);
    }
    write_surface(surface, format, options.output);
    if (!options.triangulation.quiet && options.output.path != "-") {
        fmt::print("{}, alpha {}, {}{}: {} with volume {}, {} that {} not manifold: {}\n",
                   counted(n_points, "point", "points"), radius_of(*alpha2),
                   counted(n_solids, "solid", "solids"),
                   options.largest && n_solids > 1 ? ", the largest" : "",
                   counted(surface.triangle_count(), "triangle", "triangles"),
                   shown(volume_inside(surface)),
                   counted(count_edges_that_are_not_manifold(surface), "edge", "edges"),
                   count_edges_that_are_not_manifold(surface) == 1 ? "is" : "are",
                   printable(options.output.path));
    }
    return exit_ok;
}

}  // namespace

const Command surface_command = {
    "surface", "Read points, write the surface of their alpha shape.",
    [](CLI::App& app) -> std::function<int()> {
        const auto options = std::make_shared<SurfaceOptions>();
        add_input(app, options->input, "Points; - for standard input");
        add_output(app, options->output, true);
        add_compress(app, options->output);
        app.add_option(
               "--alpha", options->alpha,
               "Radius of the largest gap that is filled; or auto for the least one that gives "
               "one solid with all points (default auto)")
            ->type_name("R");
        app.add_flag("--largest", options->largest, "Write the solid of largest volume only");
        add_triangulation(app, options->triangulation);
        app.footer(formats_and_exit_codes);
        return [options] { return write_alpha_surface(*options); };
    }};

}  // namespace mgdt::cli
