// SPDX-License-Identifier: MIT
#include "kernel/workspace.hpp"

#include <algorithm>

namespace mgdt {

Workspace::Workspace(Allocator& allocator)
    : candidates(allocator),
      cavity(allocator),
      boundary(allocator),
      direct(allocator),
      keyed_keys(allocator),
      keyed_values(allocator),
      ids(allocator),
      tets(allocator),
      x(allocator),
      y(allocator),
      z(allocator),
      a(allocator),
      b(allocator),
      c(allocator),
      slots(allocator),
      edge_codes(allocator),
      edge_keys(allocator),
      beyond() {}

void Workspace::grow_cavity(std::size_t candidates_used, std::size_t candidates_needed,
                            std::size_t cavity_used, std::size_t cavity_needed,
                            std::size_t boundary_used, std::size_t boundary_needed) {
    constexpr std::size_t least = 256, past = 16;
    candidates.reserve(std::max(least, candidates_needed + past), candidates_used);
    candidate_capacity = candidates.buffer.capacity() - past;
    cavity.reserve(std::max(least, cavity_needed + past), cavity_used);
    cavity_capacity = cavity.buffer.capacity() - past;
    boundary.reserve(std::max(least, boundary_needed + past), boundary_used);
    boundary_capacity = boundary.buffer.capacity() - past;
}

void Workspace::grow_star(std::size_t removed, std::size_t created) {
    // A cavity of so many tetrahedra, each but the first adding one vertex, has at most 3 more.
    constexpr std::size_t past = 32;
    removed = std::max({removed, star_removed, std::size_t{64}});
    created = std::max({created, star_created, std::size_t{128}});
    const std::size_t vertices = removed + 3 + past, facets = created + past;
    star_removed = star_created = 0;
    if (!direct.data) {
        direct.reserve(direct_size, 0);
        std::fill_n(direct.data, direct_size, direct_free);
    }
    ids.reserve(std::max<std::size_t>(vertices, direct_free + 1), 0);
    std::fill_n(ids.data, ids.buffer.capacity(), infinite_vertex);
    tets.reserve(vertices, 0);
    for (Scratch<double>* s : {&x, &y, &z}) {
        s->reserve(vertices, 0);
        std::fill_n(s->data, s->buffer.capacity(), 0.0);
    }
    for (Scratch<std::uint32_t>* s : {&a, &b, &c, &slots}) {
        s->reserve(facets, 0);
        std::fill_n(s->data, s->buffer.capacity(), 0u);
    }
    slot_count = 0;
    std::size_t size = 512;
    while (size < 2 * vertices) size *= 2;
    if (size != keyed_size) {
        keyed_size = 0;
        keyed_values.reserve(size, 0);
        keyed_keys.reserve(size, 0);
        std::fill_n(keyed_keys.data, size, std::uint64_t{0});
        keyed_size = size;
    }
    std::size_t codes = matrix_vertices * matrix_vertices;
    if (vertices > matrix_vertices) {
        const std::size_t size_of_table = edge_table_size(created);
        edge_keys.reserve(size_of_table, 0);
        codes = std::max(codes, size_of_table);
    }
    edge_codes.reserve(codes, 0);
    star_removed = removed;
    star_created = created;
}

void Workspace::forget_insertions() noexcept {
    if (keyed_size != 0) std::fill_n(keyed_keys.data, keyed_size, std::uint64_t{0});
    slot_count = 0;
}

}  // namespace mgdt
