// SPDX-License-Identifier: MIT
// mgdt triangulate --parts: triangulates more points than fit in memory, and writes a file for each
// part.
#include <fmt/core.h>

#include <chrono>

#include "cli/commands/triangulate.hpp"
#include "cli/counts.hpp"
#include "cli/errors.hpp"
#include "cli/formats/pieces.hpp"
#include "cli/interrupt.hpp"
#include "cli/program_parts.hpp"

namespace mgdt::cli {
namespace {

// Inserts the points in equal runs, so that ids are positions in the file.
void insert_into(Parts& parts, const std::vector<double>& points, const std::string& name) {
    const auto n = static_cast<std::int64_t>(points.size() / 3);
    const auto count = static_cast<std::int32_t>(parts.number(PartsNumber::parts, 0));
    const auto end_of = [&](std::int32_t p) { return n / count * p + n % count * p / count; };
    try {
        for (std::int32_t p = 0; p < count; ++p) {
            check_interrupt();
            parts.insert(mgdt::Points(points.data() + 3 * end_of(p),
                                      static_cast<std::size_t>(end_of(p + 1) - end_of(p))),
                         p);
        }
    } catch (...) {
        rethrow_failure(name, parts.last_error());
    }
}

}  // namespace

int triangulate_in_parts(const TriangulateOptions& options) {
    const OutputOptions& output = options.output;
    if (!options.neighbors.empty() || !options.point_map.empty() || options.all_points ||
        options.check_level > 0 || options.drop_flat > 0 || options.statistics)
        throw Error(exit_usage,
                    "--parts goes with none of --neighbors, --point-map, --all-points, --check, "
                    "--drop-flat and --stats");
    if (!is_pieces_path(output.path) || !output.to.empty())
        throw Error(exit_usage, "--parts writes pieces: say -o FILE.pvtu");
    require_compressible(output.write, vtu_format());
    const std::vector<std::string> files = piece_paths(output.path, options.parts);
    for (const std::string& file : files) check_writable(file);
    check_writable(output.path);

    const std::string name = input_name(options.input.path);
    OutputSet outputs;
    std::int64_t vertices = 0, tetrahedra = 0;
    const auto begin = std::chrono::steady_clock::now();
    {
        Parts parts(options.parts);
        set_options(parts, options.triangulation);
        {
            // The mesh is freed before the triangulation.
            std::vector<std::string> written = files;
            written.push_back(output.path);
            const Opened input = open_input(options.input, written, options.triangulation.quiet);
            insert_into(parts, input.mesh.points, name);
        }
        with_progress(parts, name, options.triangulation.quiet, [&] {
            parts.build_each([&](const Parts& p, std::int32_t part) {
                // write_part() closes the file, so that few files are open at once.
                write_part(p, part, output.write.compress,
                           outputs.open(files[static_cast<std::size_t>(part)]));
            });
        });
        vertices = parts.number(PartsNumber::all_vertices, 0);
        tetrahedra = parts.number(PartsNumber::all_tetrahedra, 0);
    }
    write_index_of_pieces(files, outputs.open(output.path));
    const std::vector<std::string> left_over = pieces_left_over(output.path, files.size());
    outputs.commit();
    remove_pieces(left_over);
    if (!options.triangulation.quiet)
        fmt::print("{}, {}, {}, {:.2f} s: {}\n",
                   counted(static_cast<std::size_t>(vertices), "vertex", "vertices"),
                   counted(static_cast<std::size_t>(tetrahedra), "tetrahedron", "tetrahedra"),
                   counted(files.size(), "part", "parts"),
                   std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
                   printable(output.path));
    return exit_ok;
}

}  // namespace mgdt::cli
