// SPDX-License-Identifier: MIT
#include "mesh/mesh.hpp"

#include <algorithm>

#include "platform/error.hpp"

namespace mgdt {

void Mesh::clear() {
    vertices.resize(1);
    vertices[0] = Vertex{{0, 0, 0}, no_index, no_tetrahedron};
    tetrahedra.clear();
    free_slots.clear();
    ghost_count = 0;
    has_extremes = false;
}

void Mesh::grow_slots(std::size_t taken, std::size_t freed) {
    free_slots.grow(free_slots.size() + freed);
    const std::size_t needed = tetrahedra.size() + taken - std::min(taken, free_slots.size());
    if (needed <= tetrahedra.capacity()) return;
    if (needed > max_tetrahedra)
        fail(MGDT_ERR_TOO_LARGE, "more than 2^30 tetrahedra (%zu vertices are in)",
             vertices.size() - 1);
    // Grow by a quarter; where a memory limit refuses that, by what is needed and a little.
    const std::size_t generous =
        std::min<std::size_t>(max_tetrahedra, needed + tetrahedra.capacity() / 4);
    try {
        tetrahedra.reserve(generous);
    } catch (const std::bad_alloc&) {
        tetrahedra.reserve(needed);
    }
}

}  // namespace mgdt
