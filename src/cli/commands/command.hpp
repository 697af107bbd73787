// SPDX-License-Identifier: MIT
// The commands of the program. Each declares its own options.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <vector>

namespace mgdt::cli {

struct Command {
    const char* name;
    const char* description;
    // Declares the options. Returns what runs when the command line has been read; it returns an
    // exit code or throws Error.
    std::function<int()> (*declare)(CLI::App& app);
};

extern const Command triangulate_command;
extern const Command generate_command;
extern const Command check_command;
extern const Command info_command;
extern const Command interpolate_command;
extern const Command voronoi_command;
extern const Command surface_command;
extern const Command hull_command;
extern const Command relax_command;
extern const Command mesh_command;
extern const Command refine_command;
extern const Command improve_command;
extern const Command validate_command;

}  // namespace mgdt::cli
