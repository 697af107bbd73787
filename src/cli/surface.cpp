// SPDX-License-Identifier: MIT
// mgdt surface and mgdt hull: read points and write the surface of their alpha shape or of their
// convex hull.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "cli/commands.hpp"
#include "cli/errors.hpp"
#include "cli/formats/number.hpp"
#include "cli/solids.hpp"

namespace mgdt::cli {
namespace {

const Format& surface_format(const OutputOptions& output) {
    const Format& format = output_format(output.path, output.to);
    if (!format.write_surface) {
        throw Error(exit_usage, fmt::format("{} ({}) has no place for triangles; write .ply, .stl, "
                                            ".off, .obj or .vtp",
                                            format.name, format.description));
    }
    require_compressible(output.write, format);
    check_terminal(output, format);
    check_writable(output.path);
    return format;
}

// Reads the points, and triangulates them. Says why there is no surface, if there is none.
std::pair<Mesh, Triangulation> triangulate_input(const InputOptions& input,
                                                 const OutputOptions& output,
                                                 TriangulationOptions options) {
    std::pair<Mesh, Triangulation> result;
    auto& [mesh, t] = result;
    mesh = read_input(input);
    require_apart(mesh.inputs, {output.path});
    const std::string name = input_name(input.path);
    if (!options.quiet) print_left_out(mesh.mid_side_nodes, name);
    // The surface is then a function of the points alone, to the order of its triangles.
    options.canonical = true;
    t = make_triangulation(options);
    insert(t, mesh.points, name, options.quiet);
    if (t.dimension() < 3 && !options.quiet)
        fmt::print(stderr, "mgdt: {}: {}, so there is no surface\n", name, shape(t));
    return result;
}

void write_surface(const Surface& surface, const Format& format, const OutputOptions& output) {
    OutputSet outputs;
    format.write_surface(surface, outputs.open(output.path), output.write);
    outputs.commit();
}

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

// A volume or an area for a message.
std::string shown(double x) {
    return std::isfinite(x) ? fmt::format("{:.6g}", x) : "beyond doubles";
}

}  // namespace

int write_alpha_surface(const SurfaceOptions& options) {
    const Format& format = surface_format(options.output);
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

int write_hull(const HullOptions& options) {
    const Format& format = surface_format(options.output);
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

}  // namespace mgdt::cli
