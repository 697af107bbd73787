// SPDX-License-Identifier: MIT
// Functions of the program for triangulations in parts.
#pragma once

#include <cstdint>
#include <functional>
#include <mgdt/mgdt.hpp>
#include <string>

#include "cli/output_file.hpp"
#include "cli/program_triangulation.hpp"

namespace mgdt::cli {

// Sets the options of the parts.
void set_options(Parts& parts, const TriangulationOptions& options);

// Runs `work`, which builds, with a progress bar unless it is quiet. `name` is the file's, for
// messages.
void with_progress(Parts& parts, const std::string& name, bool quiet,
                   const std::function<void()>& work);

// Writes the tetrahedra that a part owns as a piece of a mesh, and closes the file.
void write_part(const Parts& parts, std::int32_t part, bool compress, OutputFile& out);

}  // namespace mgdt::cli
