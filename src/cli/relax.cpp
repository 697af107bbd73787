// SPDX-License-Identifier: MIT
// mgdt relax: Lloyd's relaxation. Moves points to the centroids of their Voronoi cells, again and
// again, which spreads them evenly.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "cli/commands.hpp"
#include "cli/errors.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"

namespace mgdt::cli {
namespace {

// Moves the points one step. Returns the largest distance that a point moved. A point that is no
// vertex, since another one is equal to it, stays; as the other one moves away, it gets a cell of
// its own in the next step.
double move_to_centroids(Triangulation& t, const Planes& planes, std::vector<double>& points,
                         const std::string& name) {
    std::vector<double> centroids;
    try {
        centroids = t.cell_measures(Measure::centroid, planes);
    } catch (const mgdt::Error& e) {
        if (e.status() == MGDT_ERR_INVALID_ARGUMENT || e.status() == MGDT_ERR_NOT_FINITE)
            throw Error(exit_input, fmt::format("{}: {}", name, e.what()));
        rethrow_failure(name, t.last_error());
    } catch (const OutOfMemory&) {
        rethrow_failure(name, t.last_error());
    }
    const auto map = t.point_map<MeshIndex>();
    double longest = 0;
    for (std::size_t i = 0; i < map.size(); ++i) {
        if (map[i] != static_cast<MeshIndex>(i)) continue;
        double* p = points.data() + 3 * i;
        const double* c = centroids.data() + 3 * i;
        longest = std::max(longest, std::hypot(c[0] - p[0], c[1] - p[1], c[2] - p[2]));
        std::copy_n(c, 3, p);
    }
    try {
        t.move(mgdt::Points(points.data(), points.size() / 3));
    } catch (...) {
        rethrow_failure(name, t.last_error());
    }
    return longest;
}

}  // namespace

int relax(const RelaxOptions& options) {
    const OutputOptions& output = options.output;
    const Format& format = output_format(output.path, output.to);
    if (!format.write_points) {
        throw Error(exit_usage, fmt::format("{} ({}) is not for points alone; write .npy, .xyz, "
                                            ".csv, .f64, .ply or .node",
                                            format.name, format.description));
    }
    check_terminal(output, format);
    check_writable(output.path);
    Mesh mesh = read_input(options.input);
    const Planes planes = planes_of(options.region, mesh.points, mesh.inputs);
    require_apart(mesh.inputs, {output.path});
    const std::string name = input_name(options.input.path);
    if (!options.triangulation.quiet) print_left_out(mesh.mid_side_nodes, name);
    double longest = 0;
    {
        Triangulation t = make_triangulation(options.triangulation);
        insert(t, mesh.points, name, options.triangulation.quiet);
        if (t.dimension() < 3 && mesh.point_count() > 0)
            throw Error(exit_input, fmt::format("{}: {}, so there are no cells", name, shape(t)));
        const Cancellable cancelled_by_signals(t.handle());
        Progress progress("relaxing", options.triangulation.quiet);
        for (int step = 0; step < options.steps && mesh.point_count() > 0; ++step) {
            check_interrupt();
            progress.update(static_cast<double>(step) / options.steps);
            longest =
                move_to_centroids(t, planes, mesh.points,
                                  step == 0 ? name : fmt::format("{}: after step {}", name, step));
        }
    }
    OutputSet outputs;
    const WriteOptions write = options_after(mesh, &format, output.write);
    format.write_points(mesh.points, outputs.open(output.path), write);
    outputs.commit();
    if (!options.triangulation.quiet && output.path != "-") {
        fmt::print("{}, {}, moved by at most {:.3g} in the last: {}\n",
                   counted(mesh.point_count(), "point", "points"),
                   counted(static_cast<std::size_t>(options.steps), "step", "steps"), longest,
                   printable(output.path));
    }
    return exit_ok;
}

}  // namespace mgdt::cli
