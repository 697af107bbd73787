// SPDX-License-Identifier: MIT
// Scratch arrays and counters of one thread that inserts. The arrays grow to the size of the
// largest cavity, and are kept from one insertion to the next. The kernel, which is compiled for
// several instruction sets, sees plain pointers; the functions that allocate are compiled once
// (workspace.cpp).
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
    // Makes room for `capacity` elements, and keeps the first `used` ones.
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
    // Removes the marks from the first members of a cavity that is given up.
    void restore_cavity(TetrahedronStore& tetrahedra, std::size_t members) noexcept;

    // The cavity.
    Scratch<FacetCode> cavity;    // members, each as the facet that it is reached through
    VertexId first_corners[4];    // each other corner is opposite a facet of `cavity`
    Scratch<FacetCode> boundary;  // as the facets of tetrahedra outside the cavity
    std::size_t cavity_capacity = 0;
    std::size_t cavity_size = 0, boundary_size = 0;
    std::size_t given_up = 0;  // the number of members of the last cavity that was given up

    // The star: the local numbers of its vertices, and its facets as triples of local numbers.
    // Nearly all stars are small. The arrays of a small star lie together at fixed offsets.
    struct SmallStar {
        static constexpr std::uint32_t most_vertices = 32;
        // The corners of each facet: 60 facets at most, by Euler's formula, and room for vectors.
        alignas(64) std::uint8_t a[64], b[64], c[64];
        FacetCode edges[most_vertices * most_vertices];
    } small;
    static constexpr std::uint32_t direct_size = 2048;  // a power of two
    static constexpr std::uint32_t direct_most = 96;    // members; with more, a collision is likely
    static constexpr std::uint8_t direct_free = 255;
    alignas(64) std::uint8_t direct[direct_size];  // number by hash; direct_free between insertions
    Scratch<std::uint32_t> probed;                 // an open-addressed table of local numbers
    std::size_t probed_size = 0;
    Scratch<VertexId> ids;           // by local number
    Scratch<double> x, y, z;         // by local number, relative to the new vertex
    Scratch<std::uint32_t> a, b, c;  // facets of a star that is not small
    Scratch<FacetCode> slots;        // the first facets of the new tetrahedra
    std::size_t slot_count = 0;
    static constexpr std::uint32_t medium_vertices = 64;   // the most for a matrix of 64 x 64
    static constexpr std::uint32_t matrix_vertices = 256;  // a larger star uses the edge table
    Scratch<FacetCode> edge_codes;
    Scratch<std::uint64_t> edge_keys;
    // The edge table has 3 entries per facet, and is at most half full.
    MGDT_ALWAYS_INLINE static constexpr std::size_t edge_table_size(std::size_t facets) {
        std::size_t size = 1024;
        while (size < 6 * facets) size *= 2;
        return size;
    }
    std::size_t star_removed = 0, star_created = 0;  // the largest star that there is room for

    bool may_jump = false;  // whether a walk that has become long may jump elsewhere
    Counters counters;
};

}  // namespace mgdt
