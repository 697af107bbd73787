// SPDX-License-Identifier: MIT
#include "cli/commands/tetrahedra_command.hpp"

#include <fmt/core.h>

#include "cli/commands/help.hpp"
#include "cli/counts.hpp"
#include "cli/errors.hpp"
#include "cli/mesh_program.hpp"
#include "cli/unused_points.hpp"

namespace mgdt::cli {

void add_tetrahedra_files(CLI::App& app, TetrahedraOptions& options) {
    add_input(app, options.input, "Tetrahedra");
    add_output(app, options.output, true);
    add_index_base(app, options.output);
    add_compress(app, options.output);
}

void add_tetrahedra_settings(CLI::App& app, TetrahedraOptions& options) {
    app.add_flag("--check", options.check, "Prove the mesh before writing");
    app.add_flag("--all-points", options.all_points,
                 "Also write points that are in no tetrahedron");
    add_limits(app, options.threads, options.memory_limit);
    app.add_flag("-q,--quiet", options.quiet, "Print nothing but errors");
    app.footer(formats_and_exit_codes);
}

int change_tetrahedra(const TetrahedraOptions& options,
                      const std::function<std::string(mgdt::Mesh&, const std::string&)>& change) {
    const OutputOptions& output = options.output;
    std::vector<std::string> files;
    const Format& format = mesh_format(output, files);
    InputOptions input = options.input;
    input.read.has_markers = true;
    auto [read, name] = open_input(input, files, options.quiet);
    if (!read.has_tetrahedra)
        throw Error(exit_input, fmt::format("{}: there are no tetrahedra", name));
    const WriteOptions write = options_after(read, &format, output.write);
    Mesh mesh;
    std::string said;
    {
        mgdt::Mesh made = make_mesh(read, options.threads, options.memory_limit, name);
        said = change(made, name);
        if (options.check) require_sound(made, name);
        mesh = mesh_of(made);
    }
    // A file without markers gets none.
    if (read.regions.empty()) mesh.regions.clear();
    mesh.faces.names = read.facets.names;
    if (!options.all_points) take_out_unused_points(mesh);
    OutputSet outputs;
    format.write_mesh(mesh, output.path, outputs, write);
    if (format.write_neighbors) format.write_neighbors(mesh.neighbors, output.path, outputs, write);
    outputs.commit();
    if (!options.quiet && output.path != "-")
        fmt::print("{}{}, {}{}: {}\n", said, counted(mesh.point_count(), "point", "points"),
                   counted(mesh.tetrahedron_count(), "tetrahedron", "tetrahedra"),
                   options.check ? ", checked" : "", printable(output.path));
    return exit_ok;
}

}  // namespace mgdt::cli
