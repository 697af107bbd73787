// SPDX-License-Identifier: MIT
// Scratch arrays and counters of one thread of insertion. They grow to the largest cavity met
// and are kept from one insertion to the next.
#pragma once

#include "kernel/circumsphere.hpp"
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

    void add(const Counters& other) {
        walk_steps += other.walk_steps;
        walk_tests += other.walk_tests;
        conflict_tests += other.conflict_tests;
        removed += other.removed;
        created += other.created;
        exact_calls += other.exact_calls;
    }
};

struct Workspace {
    explicit Workspace(Allocator& allocator)
        : candidates(allocator),
          cavity(allocator),
          boundary(allocator),
          local_ids(allocator),
          local_vertices(allocator),
          numbering_keys(allocator),
          numbering_values(allocator),
          local_facets(allocator),
          edge_keys(allocator),
          edge_codes(allocator),
          slots(allocator) {}

    // The cavity.
    Buffer<FacetCode> candidates;  // tetrahedra to test, each as the facet it is reached through
    Buffer<FacetCode> cavity;      // tetrahedra in conflict, likewise
    Buffer<BoundaryFacet> boundary;

    // The star: its vertices numbered locally.
    Buffer<VertexId> local_ids;
    Buffer<LocalVertex> local_vertices;
    Buffer<std::uint64_t> numbering_keys;  // open-addressed: insertion number and vertex
    Buffer<std::uint32_t> numbering_values;
    struct LocalFacet {
        std::uint32_t a, b, c;
    };
    Buffer<LocalFacet> local_facets;
    Buffer<std::uint64_t> edge_keys;    // large cavities only: directed edges
    Buffer<std::uint32_t> edge_codes;   // edge matrix, or values of edge_keys
    Buffer<TetId> slots;                // of the new tetrahedra
    std::uint32_t infinite_local = no_index;  // the vertex at infinity's local number, if any

    Counters counters;
};

}  // namespace mgdt
