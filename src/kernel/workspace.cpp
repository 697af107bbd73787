// SPDX-License-Identifier: MIT
#include "kernel/workspace.hpp"

#include <algorithm>
#include <cassert>

namespace mgdt {

Workspace::Workspace(Allocator& allocator)
    : cavity(allocator),
      boundary(allocator),
      small(),
      probed(allocator),
      ids(allocator),
      x(allocator),
      y(allocator),
      z(allocator),
      a(allocator),
      b(allocator),
      c(allocator),
      slots(allocator),
      edge_codes(allocator),
      edge_keys(allocator) {
    std::fill_n(direct, direct_size, direct_free);
}

void Workspace::grow_cavity(std::size_t members, std::size_t facets, std::size_t needed) {
    // The arrays have `past` more elements, since stores of vectors may go past the end.
    constexpr std::size_t least = 256, past = 32;
    assert(members <= needed && "fewer members are needed than there are");
    const std::size_t capacity = std::max(least, needed + needed / 2) + past;
    cavity_capacity = 0;
    cavity.reserve(capacity, members);
    boundary.reserve(2 * capacity, facets);  // n members have at most 2n + 2 boundary facets
    cavity_capacity = capacity - past;
}

void Workspace::grow_star(std::size_t removed, std::size_t created) {
    constexpr std::size_t past = 64;
    // Each tetrahedron of a cavity but the first adds at most one vertex, so n tetrahedra have at
    // most n + 3 vertices.
    constexpr std::size_t least = medium_vertices - 3;
    const auto generous = [](std::size_t wanted, std::size_t had) {
        return wanted > had ? std::max(wanted, had + had / 2) : had;
    };
    removed = generous(std::max(removed, least), star_removed);
    created = generous(std::max(created, 2 * least), star_created);
    const std::size_t vertices = removed + 3, facets = std::max(removed, created);
    star_removed = star_created = 0;
    ids.reserve(vertices + past, 0);
    std::fill_n(ids.data, ids.buffer.capacity(), infinite_vertex);
    for (Scratch<double>* s : {&x, &y, &z}) {
        s->reserve(vertices + past, 0);
        std::fill_n(s->data, s->buffer.capacity(), 0.0);
    }
    for (Scratch<std::uint32_t>* s : {&a, &b, &c, &slots}) {
        s->reserve(facets + past, 0);
        std::fill_n(s->data, s->buffer.capacity(), 0u);
    }
    slot_count = 0;
    std::size_t size = 512;
    while (size < 4 * vertices) size *= 2;
    if (size != probed_size) {
        probed_size = 0;
        probed.reserve(size, 0);
        std::fill_n(probed.data, size, no_index);
        probed_size = size;
    }
    std::size_t codes = vertices <= medium_vertices ? medium_vertices * medium_vertices
                                                    : matrix_vertices * matrix_vertices;
    if (vertices > matrix_vertices) {
        const std::size_t size_of_table = edge_table_size(created);
        edge_keys.reserve(size_of_table, 0);
        codes = std::max(codes, size_of_table);
    }
    edge_codes.reserve(codes, 0);
    star_removed = removed;
    star_created = created;
}

void Workspace::reset() noexcept {
    cavity_capacity = 0;
    slot_count = 0;
    probed_size = 0;
    star_removed = star_created = 0;
    for (Scratch<std::uint32_t>* s :
         {&cavity, &boundary, &probed, &ids, &a, &b, &c, &slots, &edge_codes})
        s->reset();
    for (Scratch<double>* s : {&x, &y, &z}) s->reset();
    edge_keys.reset();
}

void Workspace::restore_cavity(TetrahedronStore& tetrahedra, std::size_t members) noexcept {
    assert(members <= cavity.buffer.capacity() && "more members than there is room for");
    for (std::size_t i = 0; i < members; ++i)
        tetrahedra[tetrahedron_of(cavity.data[i])].v[1] &= ~in_cavity;
}

}  // namespace mgdt
