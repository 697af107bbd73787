// SPDX-License-Identifier: MIT
// What the commands have in common that read tetrahedra, change the mesh and write it.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <mgdt/mgdt.hpp>
#include <string>

#include "cli/commands/arguments.hpp"

namespace mgdt::cli {

struct TetrahedraOptions {
    InputOptions input;
    OutputOptions output;
    bool check = false;
    bool all_points = false;  // also write points that are in no tetrahedron
    int threads = 1;
    std::uint64_t memory_limit = 0;  // bytes, 0 for none
    bool quiet = false;
};

// Declares the input and the output. The command declares its own options next.
void add_tetrahedra_files(CLI::App& app, TetrahedraOptions& options);
// Declares the options that come last.
void add_tetrahedra_settings(CLI::App& app, TetrahedraOptions& options);

// Reads a mesh, calls change(mesh, name), which returns lines that say what was done, checks the
// mesh if that is wanted, and writes it. `name` is that of the file, for messages.
int change_tetrahedra(const TetrahedraOptions& options,
                      const std::function<std::string(mgdt::Mesh&, const std::string&)>& change);

}  // namespace mgdt::cli
