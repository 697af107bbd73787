// SPDX-License-Identifier: MIT
// Scratch arrays and counters of one thread of insertion. They grow to the largest cavity met
// and are kept from one insertion to the next. The kernel, which is compiled for several
// instruction sets, sees plain pointers; what allocates is compiled once (workspace.cpp).
#pragma once

#include "mesh/mesh.hpp"

namespace mgdt {

// A facet of the cavity's boundary: vertices (a, b, c) such that (q, a, b, c) is positive, and
// the facet code on the side that stays.
struct BoundaryFacet {
    VertexId v[3];
    FacetCode outside;
};

struct Counters {
    std::uint64_t walk_steps = 0;
    std::uint64_t walk_tests = 0;
    std::uint64_t conflict_tests = 0;
    std::uint64_t removed = 0;
    std::uint64_t created = 0;
    std::uint64_t exact_calls = 0;
};

// An array with a known capacity; what its elements mean is its user's affair.
template <class T>
struct Scratch {
    explicit Scratch(Allocator& allocator) : buffer(allocator) {}
    // Keeps the first `used` elements.
    void reserve(std::size_t capacity, std::size_t used) {
        buffer.clear();
        buffer.resize(used);
        buffer.grow(capacity);
        data = buffer.data();
    }

    T* data = nullptr;
    Buffer<T> buffer;
};

struct Workspace {
    explicit Workspace(Allocator& allocator);
    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;

    // Room for cavities with so many candidates, members and boundary facets; what is there so far
    // is kept.
    void grow_cavity(std::size_t candidates_used, std::size_t candidates_needed,
                     std::size_t cavity_used, std::size_t cavity_needed, std::size_t boundary_used,
                     std::size_t boundary_needed);
    // Room for the star of a cavity with so many tetrahedra and boundary facets. The arrays have
    // what a vector of 8 stores past their ends.
    void grow_star(std::size_t removed, std::size_t created);
    // Forgets what is known by insertion numbers, before they begin again.
    void forget_insertions() noexcept;

    // The cavity.
    Scratch<FacetCode> candidates;  // tetrahedra to test, each as the facet it is reached through
    Scratch<FacetCode> cavity;      // tetrahedra in conflict, likewise
    Scratch<BoundaryFacet> boundary;
    std::size_t candidate_capacity = 0, cavity_capacity = 0, boundary_capacity = 0;
    std::size_t cavity_size = 0, boundary_size = 0;

    // The star: its vertices numbered locally, and facets over those numbers.
    static constexpr std::uint32_t direct_size = 2048;  // a power of two
    static constexpr std::uint32_t direct_most = 254;   // vertices
    static constexpr std::uint8_t direct_free = 255;
    Scratch<std::uint8_t> direct;       // local number by hash; all free between insertions
    Scratch<std::uint64_t> keyed_keys;  // open-addressed: insertion number and vertex
    Scratch<std::uint32_t> keyed_values;
    std::size_t keyed_size = 0;
    Scratch<VertexId> ids;           // by local number
    Scratch<TetId> tets;             // a new tetrahedron of each, by local number
    Scratch<double> x, y, z;         // by local number, relative to the new vertex
    Scratch<std::uint32_t> a, b, c;  // facets
    Scratch<TetId> slots;            // of the new tetrahedra
    std::size_t slot_count = 0;
    static constexpr std::uint32_t matrix_vertices = 128;  // a larger star uses the edge table
    Scratch<FacetCode> edge_codes;
    Scratch<std::uint64_t> edge_keys;
    // Half full at most: 3 entries a facet.
    static constexpr std::size_t edge_table_size(std::size_t facets) {
        std::size_t size = 1024;
        while (size < 6 * facets) size *= 2;
        return size;
    }
    std::size_t star_removed = 0, star_created = 0;  // what there is room for

    alignas(64) Tetrahedron beyond;  // takes what a vector writes past the last facet
    Counters counters;
};

}  // namespace mgdt
