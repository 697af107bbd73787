// SPDX-License-Identifier: MIT
// Writes meshes as Gmsh's .msh: version 4.1 in binary, or 2.2 in text, which older programs read.
// Tetrahedra of regions, and triangles of facets, with one marker make an entity and a physical
// group. Its number is the marker, or the next free one for a marker that is not positive, which
// has no meaning in Gmsh; then its name has the marker. Gmsh saves only elements that are in
// groups.
#pragma once

#include <string>

#include "cli/formats/file_mesh.hpp"
#include "cli/output_file.hpp"

namespace mgdt::cli {

struct WriteOptions;

void write_gmsh_4(const Mesh& mesh, const std::string& path, OutputSet& outputs,
                  const WriteOptions& options);
void write_gmsh_2(const Mesh& mesh, const std::string& path, OutputSet& outputs,
                  const WriteOptions& options);

}  // namespace mgdt::cli
