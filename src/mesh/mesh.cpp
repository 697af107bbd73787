// SPDX-License-Identifier: MIT
#include "mesh/mesh.hpp"

#include <algorithm>

#include "platform/error.hpp"

namespace mgdt {

void Mesh::clear() {
    vertices.resize(1);
    vertices[0] = Vertex{{0, 0, 0}, no_index, 0};
    vertex_hint.clear();
    drop_tetrahedra();
    has_extremes = false;
}

void Mesh::drop_tetrahedra() noexcept {
    tetrahedra.clear();
    free_slots.clear();
    ghost_count = 0;
    guards_agree = true;
}

void Mesh::shrink() noexcept {
    vertices.shrink();
    vertex_hint.shrink();
    tetrahedra.shrink();
    free_slots.shrink();
    prefaulted_slots = std::min(prefaulted_slots, tetrahedra.capacity());
}

void Mesh::reserve_tetrahedra(std::size_t count) {
    // The capacity never exceeds the limit, so every slot within it has a number.
    if (count > slot_limit)
        fail(MGDT_ERR_TOO_LARGE, "more than %u tetrahedra", static_cast<unsigned>(slot_limit));
    const std::size_t capacity = tetrahedra.capacity();
    if (count <= capacity) return;
    // If a memory limit refuses generous growth, the exact size may still fit. A large store grows
    // by remapping pages, so growing often costs little.
    constexpr std::size_t large = std::size_t{1} << 18;
    const std::size_t step = capacity < large ? capacity / 4 : capacity / 16;
    const std::size_t generous =
        std::min<std::size_t>(slot_limit, std::max(count, capacity + step));
    try {
        tetrahedra.reserve(generous);
    } catch (const std::bad_alloc&) {
        tetrahedra.reserve(count);
    }
}

void Mesh::grow_slots(std::size_t taken, std::size_t freed) {
    free_slots.grow(free_slots.size() + freed);
    const std::size_t needed = tetrahedra.size() + taken - std::min(taken, free_slots.size());
    reserve_tetrahedra(needed);
    if (needed <= prefaulted_slots) return;
    // Prefault the needed slots and 65,536 more (3 MiB with spheres), up to the capacity.
    constexpr std::size_t stretch = 65536;
    const std::size_t end = std::min(tetrahedra.capacity(), needed + stretch);
    tetrahedra.prefault(prefaulted_slots, end);
    prefaulted_slots = end;
}

}  // namespace mgdt
