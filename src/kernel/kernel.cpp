// SPDX-License-Identifier: MIT
#include "kernel/kernel.hpp"

#include "kernel/cavity.hpp"
#include "kernel/star.hpp"
#include "kernel/walk.hpp"

namespace mgdt {
namespace {

Insertion insert(Mesh& mesh, Workspace& w, VertexId q, TetId start) {
    const Query query(mesh.point(q));
    if (!w.slots.empty() && start == w.slots[0])
        start = choose_in_star(mesh, w, query, w.counters);
    const WalkResult found = walk(mesh, start, query, w.counters);
    if (found.duplicate != infinite_vertex) return {found.tetrahedron, found.duplicate};
    dig_cavity(mesh, w, found.tetrahedron, query);
    return {build_star(mesh, w, q), infinite_vertex};
}

TetId approach(const Mesh& mesh, TetId start, const Query& q, Counters& counters) {
    return walk(mesh, start, q, counters).tetrahedron;
}

constexpr Kernel baseline{"baseline", insert, approach};

}  // namespace

const Kernel& select_kernel() noexcept {
    return baseline;
}

}  // namespace mgdt
