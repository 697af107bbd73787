// SPDX-License-Identifier: MIT
// Scratch arrays and counters of one thread of insertion. They grow to the largest cavity met
// and are kept from one insertion to the next. The kernel, which is compiled for several
// instruction sets, sees plain pointers; what allocates is compiled once (workspace.cpp).
#pragma once

#include <cassert>

#include "mesh/mesh.hpp"

namespace mgdt {

struct Counters {
    std::uint64_t walk_steps = 0;
    std::uint64_t walk_tests = 0;
    std::uint64_t conflict_tests = 0;
    std::uint64_t removed = 0;
    std::uint64_t created = 0;
    std::uint64_t exact_calls = 0;

    void operator+=(const Counters& other) noexcept {
        walk_steps += other.walk_steps;
        walk_tests += other.walk_tests;
        conflict_tests += other.conflict_tests;
        removed += other.removed;
        created += other.created;
        exact_calls += other.exact_calls;
    }
};

// An array with a known capacity. Its owner decides what the elements mean.
template <class T>
struct Scratch {
    explicit Scratch(Allocator& allocator) : buffer(allocator) {}
    // Keeps the first `used` elements.
    void reserve(std::size_t capacity, std::size_t used) {
        assert(used <= buffer.capacity() && "more elements are kept than there are");
        buffer.clear();
        buffer.resize(used);
        buffer.grow(capacity);
        data = buffer.data();
    }

    void reset() noexcept {
        buffer.reset();
        data = nullptr;
    }

    T* data = nullptr;
    Buffer<T> buffer;
};

struct Workspace {
    explicit Workspace(Allocator& allocator);
    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;

    // Makes room for cavities of `needed` members. The first `members` and `facets` keep their
    // values.
    void grow_cavity(std::size_t members, std::size_t facets, std::size_t needed);
    // Makes room for a star that replaces `removed` tetrahedra by `created` ones. The arrays are
    // padded, so that stores of vectors of 8 may go past their ends.
    void grow_star(std::size_t removed, std::size_t created);
    // Frees all arrays.
    void reset() noexcept;
    // Undoes the marks on the first members of a cavity that is given up.
    void restore_cavity(TetrahedronStore& tetrahedra, std::size_t members) noexcept;

    // The cavity.
    Scratch<FacetCode> cavity;    // tetrahedra in conflict, each as the facet it is reached through
    VertexId first_corners[4];    // with the vertices opposite those faces, all of the cavity's
    Scratch<FacetCode> boundary;  // facets, on the side that stays
    std::size_t cavity_capacity = 0;
    std::size_t cavity_size = 0, boundary_size = 0;
    std::size_t given_up = 0;  // members of the cavity that was given up last

    // The star: its vertices numbered locally, and facets over those numbers. Nearly all stars are
    // small, and for those everything lies together at fixed places.
    struct SmallStar {
        static constexpr std::uint32_t most_vertices = 32;
        // Facets: 60 at most, by Euler, and what a vector reads past them.
        alignas(64) std::uint8_t a[64], b[64], c[64];
        FacetCode edges[most_vertices * most_vertices];
    } small;
    static constexpr std::uint32_t direct_size = 2048;  // a power of two
    static constexpr std::uint32_t direct_most = 96;    // corners; with more, two will clash
    static constexpr std::uint8_t direct_free = 255;
    alignas(64) std::uint8_t direct[direct_size];  // local number by hash; free between insertions
    Scratch<std::uint32_t> probed;                 // the same, open-addressed
    std::size_t probed_size = 0;
    Scratch<VertexId> ids;           // by local number
    Scratch<double> x, y, z;         // by local number, relative to the new vertex
    Scratch<std::uint32_t> a, b, c;  // facets of a star that is not small
    Scratch<FacetCode> slots;        // of the new tetrahedra, by their first facets
    std::size_t slot_count = 0;
    static constexpr std::uint32_t medium_vertices = 64;   // two sizes of matrices
    static constexpr std::uint32_t matrix_vertices = 256;  // a larger star uses the edge table
    Scratch<FacetCode> edge_codes;
    Scratch<std::uint64_t> edge_keys;
    // Half full at most: 3 entries a facet.
    MGDT_ALWAYS_INLINE static constexpr std::size_t edge_table_size(std::size_t facets) {
        std::size_t size = 1024;
        while (size < 6 * facets) size *= 2;
        return size;
    }
    std::size_t star_removed = 0, star_created = 0;  // what there is room for

    bool may_jump = false;  // whether a walk that has become long may go on elsewhere
    Counters counters;
};

}  // namespace mgdt
