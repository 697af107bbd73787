// SPDX-License-Identifier: MIT
// The kernel: insertion of one point, in a table so that the same code can be compiled for
// several instruction sets and chosen once per handle.
#pragma once

#include "kernel/workspace.hpp"

namespace mgdt {

struct Insertion {
    TetId tetrahedron;   // a tetrahedron of the new star, or one that has the duplicate
    VertexId duplicate;  // the vertex that was there before, or infinite_vertex
};

struct Kernel {
    const char* isa;
    // Inserts vertex q, whose record is in the mesh, walking from `start`. Strong guarantee: when
    // it throws (std::bad_alloc, Error with MGDT_ERR_TOO_LARGE) the triangulation is unchanged.
    Insertion (*insert)(Mesh& mesh, Workspace& workspace, VertexId q, TetId start);
    // A tetrahedron in conflict with point q near `start`; see walk.hpp.
    TetId (*approach)(const Mesh& mesh, TetId start, const double* q, Counters& counters);
};

// The kernel of that name, or the best for NULL; nullptr if this processor does not run it.
const Kernel* find_kernel(const char* name) noexcept;

// The kernel that MGDT_ISA in the environment names if the processor runs it, else the best.
const Kernel& default_kernel() noexcept;

}  // namespace mgdt
