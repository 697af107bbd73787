// SPDX-License-Identifier: MIT
// Functions of the program for meshes of the library: they are made of files of tetrahedra and made
// into contents of files, and improved. Failures are thrown as Error.
#pragma once

#include <CLI/CLI.hpp>
#include <mgdt/mgdt.hpp>
#include <string>

#include "cli/formats/file_mesh.hpp"

namespace mgdt::cli {

// A mesh of the library with the tetrahedra, markers, triangles and segments of a file. `name` is
// the file's, for messages.
mgdt::Mesh make_mesh(const Mesh& mesh, int threads, std::uint64_t memory_limit,
                     const std::string& name);
// The tetrahedra and faces of a mesh, with the points that were set first.
Mesh mesh_of(const mgdt::Mesh& made);

struct ImproveOptions {
    int goal = 25;         // degrees
    std::string keep;      // "all", "numbers" or "none"
    std::string boundary;  // "fixed" or "slide"
    int mean_passes = 0;
    int most_passes = 100;
};

struct ImproveDefaults {
    const char* keep;
    const char* boundary;
};

// The names of the options that add_improvement() declares.
inline constexpr const char* improvement_options[] = {"--goal", "--boundary", "--keep",
                                                      "--mean-passes", "--passes"};
// Declares the options of an improvement.
void add_improvement(CLI::App& app, ImproveOptions& options, const ImproveDefaults& defaults);
// Checks a mesh. A defect is a fault of the library.
void require_sound(const mgdt::Mesh& mesh, const std::string& name);
// Lets an improvement, or a refinement, change the boundary, or not.
void set_boundary(mgdt::Mesh& mesh, const ImproveOptions& options);
// Improves a mesh. Returns lines that say what has become better.
std::string improve_mesh(mgdt::Mesh& mesh, const ImproveOptions& options, bool quiet,
                         const std::string& name);

}  // namespace mgdt::cli
