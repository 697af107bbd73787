// SPDX-License-Identifier: MIT
// mgdt refine: divides the tetrahedra of a mesh until they have wanted sizes and shapes.
#include <fmt/core.h>

#include <functional>
#include <memory>

#include "cli/commands/command.hpp"
#include "cli/commands/tetrahedra_command.hpp"
#include "cli/errors.hpp"
#include "cli/formats/format.hpp"
#include "cli/input_file.hpp"
#include "cli/mesh_program.hpp"
#include "cli/mesh_refinement.hpp"

namespace mgdt::cli {
namespace {

struct RefineCommandOptions : TetrahedraOptions {
    RefineOptions refinement;
    std::string sizes;  // a file with those of points or tetrahedra, or none
    bool improve = false;
    ImproveOptions improvement;
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
    return change_tetrahedra(options, [&](mgdt::Mesh& mesh, const std::string& name) {
        if (!options.sizes.empty())
            set_given_sizes(mesh, read_sizes(options.sizes), input_name(options.sizes));
        set_boundary(mesh, options.improvement);
        std::string said = refine_mesh(mesh, options.refinement, options.quiet, name);
        if (options.improve) said += improve_mesh(mesh, options.improvement, options.quiet, name);
        return said;
    });
}

}  // namespace

const Command refine_command = {
    "refine", "Read tetrahedra, write smaller ones: of wanted sizes and shapes.",
    [](CLI::App& app) -> std::function<int()> {
        const auto options = std::make_shared<RefineCommandOptions>();
        add_tetrahedra_files(app, *options);
        add_refinement(app, options->refinement);
        app.add_option("--sizes", options->sizes,
                       "An .npy of lengths of edges: one for each tetrahedron or each point")
            ->type_name("FILE")
            ->check(CLI::ExistingFile);
        CLI::Option* const improve = app.add_flag(
            "--improve", options->improve,
            "Improve the tetrahedra then: exchange edges and faces, move and insert points");
        add_improvement(app, options->improvement, {"all", "fixed"});
        for (const std::string name : improvement_options)
            if (name != "--boundary") app.get_option(name)->needs(improve);
        add_tetrahedra_settings(app, *options);
        return [options] { return refine(*options); };
    }};

}  // namespace mgdt::cli
