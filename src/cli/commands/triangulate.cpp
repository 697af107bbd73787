// SPDX-License-Identifier: MIT
// mgdt triangulate: reads points and writes tetrahedra.
#include "cli/commands/triangulate.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <functional>
#include <memory>

#include "cli/commands/arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/help.hpp"
#include "cli/counts.hpp"
#include "cli/errors.hpp"
#include "cli/peeling.hpp"
#include "cli/unused_points.hpp"

namespace mgdt::cli {
namespace {

void print_statistics(std::FILE* out, const Triangulation& t, const TriangulateOptions& options) {
    const auto line = [out](const std::string& name, const std::string& value) {
        fmt::print(out, "{:<28} {}\n", name, value);
    };
    line("order scheme", options.triangulation.scheme);
    line("instruction set", t.isa());
    line("points", fmt::format("{}", t.point_count()));
    line("tetrahedra", fmt::format("{}", t.tetrahedron_count()));
    line("hull facets", fmt::format("{}", t.hull_facet_count()));
    for (std::int32_t key = 0; key < 1000; ++key) {
        const auto statistic = static_cast<Statistic>(key);
        if (name(statistic)) line(name(statistic), fmt::format("{}", t.statistic(statistic)));
    }
    const double inserted = t.statistic(Statistic::points_inserted);
    if (inserted <= 0) return;
    const auto rate = [&](const char* title, Statistic key) {
        line(title, fmt::format("{:.3f}", t.statistic(key) / inserted));
    };
    rate("walk steps per point", Statistic::walk_steps);
    rate("conflict tests per point", Statistic::conflict_tests);
    rate("removed per point", Statistic::tetrahedra_removed);
    rate("created per point", Statistic::tetrahedra_created);
    const double seconds =
        t.statistic(Statistic::order_seconds) + t.statistic(Statistic::insert_seconds);
    if (seconds > 0) line("points per second", fmt::format("{:.0f}", inserted / seconds));
}

int triangulate(const TriangulateOptions& options) {
    if (options.periodic.is_periodic()) return triangulate_in_box(options);
    if (!options.images.empty() || !options.periodic.directions.empty())
        throw Error(exit_usage, "--images and --periodic need --box");
    if (options.parts > 0) return triangulate_in_parts(options);
    const OutputOptions& output = options.output;
    const Format* format = nullptr;
    std::vector<std::string> files;
    if (!output.path.empty()) {
        format = &mesh_format(output, files);
    } else if (options.neighbors.empty() && options.point_map.empty() && !options.statistics &&
               options.check_level == 0) {
        throw Error(exit_usage,
                    "nothing to do; say where to write with -o, or ask for --stats or "
                    "--check");
    }
    if (!options.neighbors.empty()) {
        if (options.neighbors == output.path) {
            throw Error(exit_usage, "-o and --neighbors name the same file");
        }
        files.push_back(options.neighbors);
    }
    if (!options.point_map.empty()) {
        if (options.point_map == output.path || options.point_map == options.neighbors)
            throw Error(exit_usage, "--point-map names a file that is written already");
        files.push_back(options.point_map);
    }
    for (const std::string& file : files) check_writable(file);
    // Text goes to standard error if a file goes to standard output.
    std::FILE* text = output.path == "-" || options.neighbors == "-" || options.point_map == "-"
                          ? stderr
                          : stdout;

    auto [mesh, name] = open_input(options.input, files, options.triangulation.quiet);
    const auto begin = std::chrono::steady_clock::now();
    // The handle takes three times the memory of an array, so it is freed as early as possible.
    Triangulation t = make_triangulation(options.triangulation);
    insert(t, mesh.points, name, options.triangulation.quiet);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (t.dimension() < 3 && !options.triangulation.quiet) {
        fmt::print(stderr, "mgdt: {}: {}, so there are no tetrahedra\n", name, shape(t));
    }
    if (options.statistics) print_statistics(text, t, options);
    if (options.check_level > 0) {
        const std::string defect = find_defect(t, options.check_level);
        if (!defect.empty()) {
            throw Error(exit_check_failed,
                        fmt::format("{}: check at level {} failed: {}; nothing was written", name,
                                    options.check_level, defect));
        }
        if (!options.triangulation.quiet) {
            fmt::print(text, "check at level {} passed\n", options.check_level);
        }
    }
    const std::size_t points = mesh.point_count();
    auto count = static_cast<std::size_t>(t.tetrahedron_count());
    const bool wants_neighbors =
        !options.neighbors.empty() || (format && format->write_neighbors != nullptr);
    std::vector<MeshIndex> point_map;  // the vertex that stands for each point
    if (!options.point_map.empty()) point_map = t.point_map<MeshIndex>();
    mesh.neighbors = {};
    t.set_compact(true);
    if (format) mesh.tetrahedra = tetrahedra(t);
    std::vector<bool> stays;  // of the tetrahedra; empty if all stay
    if (options.drop_flat > 0) {
        stays = find_what_stays(t.tetrahedron_measures(TetrahedronMeasure::radius_ratio),
                                neighbors(t), options.drop_flat);
        const auto dropped =
            static_cast<std::size_t>(std::count(stays.begin(), stays.end(), false));
        if (format) keep_rows(stays, mesh.tetrahedra);
        if (!options.triangulation.quiet)
            fmt::print(text, "{} taken off the hull\n",
                       counted(dropped, "flat tetrahedron", "flat tetrahedra"));
        count -= dropped;
    }
    if (!wants_neighbors) t = Triangulation();

    // An .npy file of tetrahedra does not contain points.
    if (format && format != &npy_format() && !options.all_points) {
        const std::vector<MeshIndex> numbers = take_out_unused_points(mesh);
        for (MeshIndex& v : point_map)
            if (v >= 0) v = numbers[static_cast<std::size_t>(v)];
    }
    OutputSet outputs;
    if (!options.point_map.empty())
        write_npy_integers(point_map, output.write.index_base, outputs.open(options.point_map));
    const WriteOptions write = options_after(mesh, format, output.write);
    if (format) format->write_mesh(mesh, output.path, outputs, write);
    mesh = {};
    if (wants_neighbors) {
        std::vector<MeshIndex> numbers = neighbors(t);
        t = Triangulation();
        if (!stays.empty()) keep_neighbors(stays, numbers);
        if (format && format->write_neighbors)
            format->write_neighbors(numbers, output.path, outputs, write);
        if (!options.neighbors.empty())
            write_npy_rows_of_4(numbers, output.write.index_base, outputs.open(options.neighbors));
    }
    outputs.commit();
    if (!options.triangulation.quiet && text == stdout) {
        fmt::print("{}, {}, {:.2f} s{}{}\n", counted(points, "point", "points"),
                   counted(count, "tetrahedron", "tetrahedra"), seconds, format ? ": " : "",
                   printable(output.path));
    }
    return exit_ok;
}

}  // namespace

const Command triangulate_command = {
    "triangulate", "Read points, write the tetrahedra of their Delaunay triangulation.",
    [](CLI::App& app) -> std::function<int()> {
        const auto options = std::make_shared<TriangulateOptions>();
        add_input(app, options->input, "Points; - for standard input");
        add_output(app, options->output, false);
        add_index_base(app, options->output);
        add_compress(app, options->output);
        add_triangulation(app, options->triangulation);
        add_scheme_parameters(app, options->triangulation);
        app.add_option("--neighbors", options->neighbors, "Write the neighbours too, as .npy")
            ->type_name("FILE");
        app.add_option("--point-map", options->point_map,
                       "Write for each point the number of the one that stands for it, as .npy")
            ->type_name("FILE");
        app.add_flag("--all-points", options->all_points,
                     "Write points too that are in no tetrahedron, such as repeats");
        app.add_flag("--canonical", options->triangulation.canonical,
                     "Sort the tetrahedra, so that the file depends on the points alone");
        app.add_option("--check", options->check_level,
                       "Prove the result before writing: 1 combinatorial, 2 geometric, 3 canonical")
            ->check(CLI::Range(1, 3))
            ->type_name("LEVEL");
        add_periodic(app, options->periodic);
        app.add_option("--images", options->images,
                       "Write a table of the images that are nodes: node, point and offset of each")
            ->type_name("FILE");
        app.add_option("--drop-flat", options->drop_flat,
                       "Take tetrahedra off the hull whose radius ratio is less, such as 1e-9, one "
                       "layer after another")
            ->check(number_between(0, 1))
            ->type_name("RATIO");
        app.add_flag("--stats", options->statistics, "Print counts and times");
        app.add_option(
               "--parts", options->parts,
               "Triangulate in this many parts, one in memory at a time; writes FILE.pvtu and "
               "a .vtu file for each")
            ->check(CLI::Range(1, 1 << 20))
            ->type_name("N");
        app.footer(formats_and_exit_codes);
        return [options] { return triangulate(*options); };
    }};

}  // namespace mgdt::cli
