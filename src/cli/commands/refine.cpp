// SPDX-License-Identifier: MIT
// mgdt refine: divides the tetrahedra of a mesh until they have wanted sizes and shapes.
#include <fmt/core.h>

#include <functional>
#include <memory>

#include "cli/commands/arguments.hpp"
#include "cli/commands/command.hpp"
#include "cli/commands/help.hpp"
#include "cli/counts.hpp"
#include "cli/errors.hpp"
#include "cli/formats/format.hpp"
#include "cli/input_file.hpp"
#include "cli/mesh_program.hpp"
#include "cli/mesh_refinement.hpp"
#include "cli/unused_points.hpp"

namespace mgdt::cli {
namespace {

struct RefineCommandOptions {
    InputOptions input;
    OutputOptions output;
    RefineOptions refinement;
    std::string sizes;  // a file with those of points or tetrahedra, or none
    bool improve = false;
    ImproveOptions improvement;
    bool check = false;
    bool all_points = false;  // also write points that are in no tetrahedron
    int threads = 1;
    std::uint64_t memory_limit = 0;  // bytes, 0 for none
    bool quiet = false;
};

// The sizes in a file: values in a column, or an array.
std::vector<double> read_sizes(const std::string& path) {
    const InputFile file(path);
    const Field field = read_npy_values(file.source());
    if (field.components != 1)
        throw Error(exit_input, fmt::format("{}: {} columns; sizes have one", input_name(path),
                                            field.components));
    return field.values;
}

int refine(const RefineCommandOptions& options) {
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
        if (!options.sizes.empty())
            set_given_sizes(made, read_sizes(options.sizes), input_name(options.sizes));
        said = refine_mesh(made, options.refinement, options.quiet, name);
        if (options.improve)
            said += improve_mesh(made, options.improvement, false, options.quiet, name);
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

}  // namespace

const Command refine_command = {
    "refine", "Read tetrahedra, write smaller ones: of wanted sizes and shapes.",
    [](CLI::App& app) -> std::function<int()> {
        const auto options = std::make_shared<RefineCommandOptions>();
        add_input(app, options->input, "Tetrahedra");
        add_output(app, options->output, true);
        add_index_base(app, options->output);
        add_compress(app, options->output);
        add_refinement(app, options->refinement);
        app.add_option("--sizes", options->sizes,
                       "An .npy of lengths of edges: one for each tetrahedron or each point")
            ->type_name("FILE")
            ->check(CLI::ExistingFile);
        CLI::Option* const improve = app.add_flag(
            "--improve", options->improve,
            "Improve the tetrahedra then: exchange edges and faces, move and insert points");
        add_improvement(app, options->improvement, {"all", "fixed"});
        for (const char* const name : improvement_options) app.get_option(name)->needs(improve);
        app.add_flag("--check", options->check, "Prove the mesh before writing");
        app.add_flag("--all-points", options->all_points,
                     "Also write points that are in no tetrahedron");
        add_limits(app, options->threads, options->memory_limit);
        app.add_flag("-q,--quiet", options->quiet, "Print nothing but errors");
        app.footer(formats_and_exit_codes);
        return [options] { return refine(*options); };
    }};

}  // namespace mgdt::cli
