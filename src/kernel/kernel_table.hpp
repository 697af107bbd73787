// SPDX-License-Identifier: MIT
// The body of each kernel_*.cpp: the table of functions for the instruction set that MGDT_ISA
// names and the file's compiler flags give.
#pragma once

#include "kernel/cavity.hpp"
#include "kernel/kernel.hpp"
#include "kernel/star.hpp"
#include "kernel/walk.hpp"

namespace mgdt {
inline namespace MGDT_ISA {

inline Insertion insert(Mesh& mesh, Workspace& w, VertexId q, TetId start) {
    const Query query(mesh.point(q));
    const bool is_in_star = w.slot_count != 0 && start == w.slots.data[0];
    const WalkResult found = walk(mesh,
                                  is_in_star ? start_in_star(mesh, w, query, w.counters)
                                             : start_at(mesh, start, query, w.counters),
                                  query, w.counters);
    if (found.duplicate != infinite_vertex) return {found.start.tetrahedron, found.duplicate};
    dig_cavity(mesh, w, found.start, query);
    return {build_star(mesh, w, q), infinite_vertex};
}

}  // namespace MGDT_ISA
}  // namespace mgdt

#define MGDT_TEXT_OF(name) #name
#define MGDT_TEXT(name) MGDT_TEXT_OF(name)
#define MGDT_KERNEL_TABLE \
    { MGDT_TEXT(MGDT_ISA), mgdt::insert, mgdt::locate_begin, mgdt::locate_step }
