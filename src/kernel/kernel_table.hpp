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
    if (w.slot_count != 0 && start == w.slots.data[0])
        start = choose_in_star(mesh, w, query, w.counters);
    const WalkResult found = walk(mesh, start, query, w.counters);
    if (found.duplicate != infinite_vertex) return {found.tetrahedron, found.duplicate};
    dig_cavity(mesh, w, found.tetrahedron, query);
    return {build_star(mesh, w, q), infinite_vertex};
}

inline TetId approach(const Mesh& mesh, TetId start, const double* q, Counters& counters) {
    return walk(mesh, start, Query(q), counters).tetrahedron;
}

}  // namespace MGDT_ISA
}  // namespace mgdt

#define MGDT_TEXT_OF(name) #name
#define MGDT_TEXT(name) MGDT_TEXT_OF(name)
#define MGDT_KERNEL_TABLE \
    { MGDT_TEXT(MGDT_ISA), mgdt::insert, mgdt::approach }
