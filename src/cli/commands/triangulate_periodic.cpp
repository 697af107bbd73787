// SPDX-License-Identifier: MIT
// mgdt triangulate --box: tetrahedra of points in a periodic box. Images of points that are corners
// become nodes of their own behind the points.
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "cli/commands/triangulate.hpp"
#include "cli/counts.hpp"
#include "cli/errors.hpp"
#include "cli/periodic_box.hpp"
#include "cli/unused_points.hpp"

namespace mgdt::cli {
namespace {

// An image of a point that is a node: the point and its offset.
using ImageNode = std::array<std::int64_t, 4>;

void print_statistics(std::FILE* out, const Periodic& box) {
    constexpr struct {
        const char* name;
        PeriodicStatistic key;
    } lines[] = {{"points", PeriodicStatistic::points},
                 {"vectors that repeat", PeriodicStatistic::dimensions},
                 {"vertices", PeriodicStatistic::vertices},
                 {"edges", PeriodicStatistic::edges},
                 {"tetrahedra", PeriodicStatistic::tetrahedra},
                 {"images triangulated", PeriodicStatistic::images},
                 {"rounds", PeriodicStatistic::rounds},
                 {"memory bytes", PeriodicStatistic::memory_bytes}};
    for (const auto& line : lines)
        fmt::print(out, "{:<28} {}\n", line.name, box.statistic(line.key));
}

// Sets the tetrahedra of a mesh, whose points get the images that are corners. Returns the images.
std::vector<ImageNode> take_tetrahedra(const Periodic& box, Mesh& mesh) {
    const std::vector<std::int64_t> corners = box.array(PeriodicArray::tetrahedra),
                                    offsets = box.array(PeriodicArray::tetrahedron_shifts);
    const auto image_at = [&](std::size_t i) {
        return ImageNode{corners[i], offsets[3 * i], offsets[3 * i + 1], offsets[3 * i + 2]};
    };
    const auto is_point = [](const ImageNode& node) {
        return node[1] == 0 && node[2] == 0 && node[3] == 0;
    };
    std::vector<ImageNode> images;
    for (std::size_t i = 0; i < corners.size(); ++i)
        if (const ImageNode node = image_at(i); !is_point(node)) images.push_back(node);
    std::sort(images.begin(), images.end());
    images.erase(std::unique(images.begin(), images.end()), images.end());
    const std::size_t points = mesh.point_count();
    mesh.tetrahedra.resize(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const ImageNode node = image_at(i);
        const auto at = std::lower_bound(images.begin(), images.end(), node) - images.begin();
        mesh.tetrahedra[i] = static_cast<MeshIndex>(
            is_point(node) ? node[0] : static_cast<std::int64_t>(points) + at);
    }
    const std::vector<Point> vectors = box.vectors();
    for (const ImageNode& node : images)
        for (std::size_t c = 0; c < 3; ++c) {
            double x = mesh.points[3 * static_cast<std::size_t>(node[0]) + c];
            for (std::size_t k = 0; k < vectors.size(); ++k)
                x += static_cast<double>(node[1 + k]) * vectors[k][c];
            mesh.points.push_back(x);
        }
    return images;
}

// A row for each image: its node, its point, and how often each vector is added.
void write_images(const std::vector<ImageNode>& images, const std::vector<MeshIndex>& numbers,
                  std::size_t points, std::int64_t base, OutputFile& out) {
    const auto node = [&](std::size_t i) {
        const std::int64_t number =
            numbers.empty() ? static_cast<std::int64_t>(i) : std::int64_t{numbers[i]};
        return number < 0 ? number : number + base;
    };
    out.write("node,point,i,j,k\n");
    for (std::size_t i = 0; i < images.size(); ++i) {
        out.write_integer(node(points + i));
        out.write(",");
        out.write_integer(node(static_cast<std::size_t>(images[i][0])));
        for (std::size_t k = 1; k < 4; ++k) {
            out.write(",");
            out.write_integer(images[i][k]);
        }
        out.write("\n");
    }
}

void require_periodic_options(const TriangulateOptions& options) {
    if (options.parts > 0) throw Error(exit_usage, "--box and --parts exclude each other");
    if (options.drop_flat > 0) throw Error(exit_usage, "--box and --drop-flat exclude each other");
}

}  // namespace

int triangulate_in_box(const TriangulateOptions& options) {
    require_periodic_options(options);
    const OutputOptions& output = options.output;
    const Format* format = nullptr;
    std::vector<std::string> files;
    if (!output.path.empty()) {
        format = &mesh_format(output, files);
    }
    for (const std::string& file : {options.neighbors, options.point_map, options.images}) {
        if (file.empty()) continue;
        if (std::find(files.begin(), files.end(), file) != files.end())
            throw Error(exit_usage, fmt::format("two outputs name the same file {}", quote(file)));
        files.push_back(file);
    }
    if (files.empty() && !options.statistics && options.check_level == 0)
        throw Error(exit_usage,
                    "nothing to do; say where to write with -o, or ask for --stats or --check");
    for (const std::string& file : files) check_writable(file);
    std::FILE* const text =
        std::find(files.begin(), files.end(), "-") != files.end() ? stderr : stdout;

    auto [mesh, name] = open_input(options.input, files, options.triangulation.quiet);
    const auto begin = std::chrono::steady_clock::now();
    const Periodic box = make_periodic(options.periodic, options.triangulation, mesh, name);
    const double seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const auto count = static_cast<std::size_t>(box.statistic(PeriodicStatistic::tetrahedra));
    const std::size_t points = mesh.point_count();
    if (count == 0 && points > 0 && !options.triangulation.quiet)
        fmt::print(stderr, "mgdt: {}: the points do not span space, so there are no tetrahedra\n",
                   name);
    if (options.statistics) print_statistics(text, box);
    if (options.check_level > 0) {
        try {
            box.check();
        } catch (const mgdt::Error& e) {
            if (e.status() != MGDT_ERR_CHECK_FAILED) throw;
            throw Error(
                exit_check_failed,
                fmt::format("{}: the check failed: {}; nothing was written", name, e.what()));
        }
        if (!options.triangulation.quiet) fmt::print(text, "the check passed\n");
    }
    mesh.tetrahedra.clear();
    mesh.neighbors.clear();
    std::vector<ImageNode> images;
    if (format || !options.images.empty()) images = take_tetrahedra(box, mesh);
    std::vector<MeshIndex> point_map;
    if (!options.point_map.empty()) point_map = box.array<MeshIndex>(PeriodicArray::point_map);
    std::vector<MeshIndex> numbers;
    if (format && format != &npy_format() && !options.all_points) {
        numbers = take_out_unused_points(mesh);
        for (MeshIndex& v : point_map) v = numbers[static_cast<std::size_t>(v)];
    }
    OutputSet outputs;
    const WriteOptions write = options_after(mesh, format, output.write);
    if (!options.point_map.empty())
        write_npy_integers(point_map, write.index_base, outputs.open(options.point_map));
    if (!options.images.empty())
        write_images(images, numbers, points, write.index_base, outputs.open(options.images));
    if (format) format->write_mesh(mesh, output.path, outputs, write);
    if (!options.neighbors.empty() || (format && format->write_neighbors)) {
        const std::vector<MeshIndex> neighbors = box.array<MeshIndex>(PeriodicArray::neighbors);
        if (format && format->write_neighbors)
            format->write_neighbors(neighbors, output.path, outputs, write);
        if (!options.neighbors.empty())
            write_npy_rows_of_4(neighbors, write.index_base, outputs.open(options.neighbors));
    }
    outputs.commit();
    if (!options.triangulation.quiet && text == stdout)
        fmt::print("{}, {} of images, {}, {:.2f} s{}{}\n", counted(points, "point", "points"),
                   counted(images.size(), "node", "nodes"),
                   counted(count, "tetrahedron", "tetrahedra"), seconds, format ? ": " : "",
                   printable(output.path));
    return exit_ok;
}

}  // namespace mgdt::cli
