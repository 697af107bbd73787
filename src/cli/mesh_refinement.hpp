// SPDX-License-Identifier: MIT
// The options of a refinement, and what the program says of it.
#pragma once

#include <CLI/CLI.hpp>
#include <mgdt/mgdt.hpp>
#include <string>
#include <vector>

namespace mgdt::cli {

struct RefineOptions {
    double size = 0, gradation = 0.3, radius_edge = 1.4, volume = 0;
    bool surface_sizes = false;
    std::vector<double> region_sizes;  // the marker and the size for each
    std::string size_field;            // a file with points and the sizes there, or none
    int most_points = 0;

    // Whether something says how large tetrahedra should be.
    bool is_asked_for() const {
        return size > 0 || volume > 0 || surface_sizes || !region_sizes.empty() ||
               !size_field.empty();
    }
};

// Declares the options of a refinement.
void add_refinement(CLI::App& app, RefineOptions& options);
// Sets the sizes of tetrahedra or points for a refinement: `sizes` has one for each of one of
// these.
void set_given_sizes(mgdt::Mesh& mesh, const std::vector<double>& sizes, const std::string& name);
// Refines a mesh. Returns lines that say what was done.
std::string refine_mesh(mgdt::Mesh& mesh, const RefineOptions& options, bool quiet,
                        const std::string& name);

}  // namespace mgdt::cli
