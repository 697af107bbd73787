// SPDX-License-Identifier: MIT
// mgdt triangulate: points in, tetrahedra out.
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>

#include "cli/commands.hpp"
#include "cli/errors.hpp"

namespace mgdt::cli {
namespace {

double statistic(const Triangulation& t, std::int32_t key) {
    double value = 0;
    mgdt_get_stat(t.get(), key, &value);
    return value;
}

void print_statistics(std::FILE* out, const Triangulation& t, const TriangulateOptions& options) {
    const auto line = [out](const std::string& name, const std::string& value) {
        fmt::print(out, "{:<28} {}\n", name, value);
    };
    line("order scheme", options.triangulation.scheme);
    line("instruction set", mgdt_isa_name(t.get()));
    line("points", fmt::format("{}", mgdt_point_count(t.get())));
    line("tetrahedra", fmt::format("{}", mgdt_tetrahedron_count(t.get())));
    line("hull facets", fmt::format("{}", mgdt_hull_facet_count(t.get())));
    for (std::int32_t key = 0; key < 1000; ++key) {
        const char* name = mgdt_stat_name(key);
        double value = 0;
        if (name && mgdt_get_stat(t.get(), key, &value) == MGDT_OK) {
            line(name, fmt::format("{}", value));
        }
    }
    const double inserted = statistic(t, MGDT_STAT_POINTS_INSERTED);
    if (inserted <= 0) return;
    const auto rate = [&](const char* name, std::int32_t key) {
        line(name, fmt::format("{:.3f}", statistic(t, key) / inserted));
    };
    rate("walk steps per point", MGDT_STAT_WALK_STEPS);
    rate("conflict tests per point", MGDT_STAT_CONFLICT_TESTS);
    rate("removed per point", MGDT_STAT_TETRAHEDRA_REMOVED);
    rate("created per point", MGDT_STAT_TETRAHEDRA_CREATED);
    const double seconds =
        statistic(t, MGDT_STAT_ORDER_SECONDS) + statistic(t, MGDT_STAT_INSERT_SECONDS);
    if (seconds > 0) line("points per second", fmt::format("{:.0f}", inserted / seconds));
}

// Takes the points out that are in no tetrahedron, such as repeats: solvers stop at nodes without
// elements. Where there are no tetrahedra, all stay. Returns the new number of each point.
std::vector<MeshIndex> take_out_unused_points(Mesh& mesh) {
    std::vector<MeshIndex> numbers(mesh.point_count(), mesh.tetrahedra.empty() ? 0 : -1);
    for (const MeshIndex v : mesh.tetrahedra) numbers[static_cast<std::size_t>(v)] = 0;
    std::size_t kept = 0;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        if (numbers[i] < 0) continue;
        std::copy_n(mesh.points.data() + 3 * i, 3, mesh.points.data() + 3 * kept);
        numbers[i] = static_cast<MeshIndex>(kept++);
    }
    mesh.points.resize(3 * kept);
    for (MeshIndex& v : mesh.tetrahedra) v = numbers[static_cast<std::size_t>(v)];
    return numbers;
}

}  // namespace

int triangulate(const TriangulateOptions& options) {
    if (options.parts > 0) return triangulate_in_parts(options);
    const OutputOptions& output = options.output;
    const Format* format = nullptr;
    std::vector<std::string> files;
    if (!output.path.empty()) {
        format = &output_format(output.path, output.to);
        if (!format->write_mesh) {
            throw Error(exit_usage,
                        fmt::format("{} ({}) has no place for tetrahedra; write .vtu, .msh, .ele "
                                    "or .npy",
                                    format->name, format->description));
        }
        require_compressible(output.write, *format);
        check_terminal(output, *format);
        files = format->mesh_files ? format->mesh_files(output.path)
                                   : std::vector<std::string>{output.path};
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
    // Standard output carries the file when it is asked to.
    std::FILE* text = output.path == "-" || options.neighbors == "-" || options.point_map == "-"
                          ? stderr
                          : stdout;

    Mesh mesh = read_input(options.input);
    require_apart(mesh.inputs, files);
    const std::string name = input_name(options.input.path);
    if (!options.triangulation.quiet) print_left_out(mesh.mid_side_nodes, name);
    const auto begin = std::chrono::steady_clock::now();
    // The handle takes three times the memory of an array: it goes as soon as nothing is left to
    // ask.
    std::optional<Triangulation> t(std::in_place, options.triangulation);
    t->insert(mesh.points, name);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (mgdt_dimension(t->get()) < 3 && !options.triangulation.quiet) {
        fmt::print(stderr, "mgdt: {}: {}, so there are no tetrahedra\n", name, t->shape());
    }
    if (options.statistics) print_statistics(text, *t, options);
    if (options.check_level > 0) {
        const std::string defect = t->check(options.check_level);
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
    const auto tetrahedra = static_cast<std::size_t>(mgdt_tetrahedron_count(t->get()));
    const bool wants_neighbors =
        !options.neighbors.empty() || (format && format->write_neighbors != nullptr);
    std::vector<MeshIndex> point_map;  // the vertex that stands for each point
    if (!options.point_map.empty()) point_map = t->point_map();
    mesh.neighbors = {};
    mgdt_set_compact(t->get(), 1);
    if (format) mesh.tetrahedra = t->tetrahedra();
    if (!wants_neighbors) t.reset();

    // An .npy of tetrahedra has no points of its own.
    if (format && format != &npy_format() && !options.all_points) {
        const std::vector<MeshIndex> numbers = take_out_unused_points(mesh);
        for (MeshIndex& v : point_map)
            if (v >= 0) v = numbers[static_cast<std::size_t>(v)];
    }
    OutputSet outputs;
    if (!options.point_map.empty())
        write_npy_integers(point_map, output.write.index_base, outputs.open(options.point_map));
    WriteOptions write = output.write;
    // As the points came: they have these numbers in other files of the same set.
    if (format == &tetgen_format() && !write.is_base_chosen)
        write.index_base = mesh.first_number.value_or(0);
    if (format) format->write_mesh(mesh, output.path, outputs, write);
    mesh = {};
    if (wants_neighbors) {
        const std::vector<MeshIndex> neighbors = t->neighbors();
        t.reset();
        if (format && format->write_neighbors)
            format->write_neighbors(neighbors, output.path, outputs, write);
        if (!options.neighbors.empty())
            write_npy_rows_of_4(neighbors, output.write.index_base,
                                outputs.open(options.neighbors));
    }
    outputs.commit();
    if (!options.triangulation.quiet && text == stdout) {
        fmt::print("{}, {}, {:.2f} s{}{}\n", counted(points, "point", "points"),
                   counted(tetrahedra, "tetrahedron", "tetrahedra"), seconds, format ? ": " : "",
                   printable(output.path));
    }
    return exit_ok;
}

}  // namespace mgdt::cli
