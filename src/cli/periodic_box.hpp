// SPDX-License-Identifier: MIT
// Periodic boxes of the program: as the command line gives them, and as the library has them.
#pragma once

#include <mgdt/mgdt.hpp>
#include <string>

#include "cli/formats/file_mesh.hpp"
#include "cli/program_triangulation.hpp"

namespace mgdt::cli {

struct PeriodicOptions {
    // Three lengths or nine numbers, with blanks or commas between them; "file" for the box that
    // the file has; or empty.
    std::string box;
    std::string directions;  // of x, y and z those whose vectors repeat; empty for all

    bool is_periodic() const { return !box.empty(); }
};

// The box with the points of a file, triangulated, with a progress bar unless it is quiet. `name`
// is the file's, for messages.
Periodic make_periodic(const PeriodicOptions& options, const TriangulationOptions& settings,
                       const Mesh& mesh, const std::string& name);

}  // namespace mgdt::cli
