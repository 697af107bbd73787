// SPDX-License-Identifier: MIT
// mgdt improve: makes the worst tetrahedra of a mesh better.
#include <functional>
#include <memory>

#include "cli/commands/command.hpp"
#include "cli/commands/tetrahedra_command.hpp"
#include "cli/mesh_program.hpp"

namespace mgdt::cli {
namespace {

struct ImproveCommandOptions : TetrahedraOptions {
    ImproveOptions improvement;
};

int improve(const ImproveCommandOptions& options) {
    return change_tetrahedra(options, [&](mgdt::Mesh& mesh, const std::string& name) {
        return improve_mesh(mesh, options.improvement, options.quiet, name);
    });
}

}  // namespace

const Command improve_command = {
    "improve", "Read tetrahedra, write better ones: no small dihedral angles.",
    [](CLI::App& app) -> std::function<int()> {
        const auto options = std::make_shared<ImproveCommandOptions>();
        add_tetrahedra_files(app, *options);
        add_improvement(app, options->improvement, {"numbers", "fixed"});
        add_tetrahedra_settings(app, *options);
        return [options] { return improve(*options); };
    }};

}  // namespace mgdt::cli
