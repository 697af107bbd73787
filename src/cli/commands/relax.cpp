// SPDX-License-Identifier: MIT
// mgdt relax: Lloyd's relaxation. Moves points to the centroids of their Voronoi cells, again and
// again, which spreads them evenly.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

#include "cli/commands/arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/help.hpp"
#include "cli/counts.hpp"
#include "cli/errors.hpp"
#include "cli/interrupt.hpp"
#include "cli/progress.hpp"

namespace mgdt::cli {
namespace {

struct RelaxOptions {
    InputOptions input;
    OutputOptions output;
    RegionOptions region = {"auto", ""};
    int steps = 0;
    TriangulationOptions triangulation;
};

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

int relax(const RelaxOptions& options) {
    const OutputOptions& output = options.output;
    const Format& format = points_format(output);
    check_writable(output.path);
    auto [mesh, name] = open_input(options.input, {output.path}, options.triangulation.quiet);
    const Planes planes = planes_of(options.region, mesh.points, mesh.inputs);
    require_apart(mesh.inputs, {output.path});
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

}  // namespace

const Command relax_command = {
    "relax", "Read points, move them to the centroids of their cells, write them.",
    [](CLI::App& app) -> std::function<int()> {
        const auto options = std::make_shared<RelaxOptions>();
        add_input(app, options->input, "Points; - for standard input");
        add_output(app, options->output, true);
        add_index_base(app, options->output);
        app.add_option("--steps", options->steps, "Number of steps")
            ->required()
            ->check(CLI::Range(0, 1000000))
            ->type_name("N");
        add_region(app, options->region);
        add_triangulation(app, options->triangulation);
        app.footer(formats_and_exit_codes);
        return [options] { return relax(*options); };
    }};

}  // namespace mgdt::cli
