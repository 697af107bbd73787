// SPDX-License-Identifier: MIT
// Local numbers for the vertices of a cavity. They are in thread-local tables and not in the vertex
// records, because a vertex may be in the cavities of two threads.
#pragma once

#include <cassert>

#include "kernel/island.hpp"
#include "kernel/workspace.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// The vertex opposite the face that a member of the cavity is reached through.
template <class Tetrahedra>
MGDT_ALWAYS_INLINE VertexId corner(const Tetrahedra& tetrahedra, FacetCode code) {
    assert(!tetrahedra.of(code).is_dead() && "a member of the cavity is dead");
    // The second vertex may have a mark.
    return unmarked(tetrahedra.of(code).v[face_of(code)]);
}

// A table with one byte per vertex, found by its hash without probing. This suffices for nearly all
// cavities. add_cavity() returns false if two vertices have the same hash, which gives both the
// same number, or if the cavity is too large.
class DirectNumbers {
  public:
    MGDT_ALWAYS_INLINE explicit DirectNumbers(Workspace& w) : table_(w.direct), ids_(w.ids.data) {}
    DirectNumbers(const DirectNumbers&) = delete;
    DirectNumbers& operator=(const DirectNumbers&) = delete;
    MGDT_ALWAYS_INLINE ~DirectNumbers() {
        // The loop runs in blocks, so that its number of turns is predictable. The identifiers
        // behind the last one are vertices of earlier cavities, whose bytes are free anyway.
        constexpr std::uint32_t block = 16;
        for (std::uint32_t i = 0; i < count_; i += block)
            for (std::uint32_t k = i; k < i + block; ++k)
                table_[hash(ids_[k])] = Workspace::direct_free;
    }

    template <class Tetrahedra>
    MGDT_ALWAYS_INLINE bool add_cavity(const Workspace& w, const Tetrahedra& tetrahedra) {
        if (MGDT_UNLIKELY(w.cavity_size > Workspace::direct_most)) return false;
        static_assert(Workspace::direct_free == 255);  // adding 1 to any other byte does not carry
        std::uint32_t added = 0;
        // Local copies, since the compiler assumes that a store of a byte may change members.
        std::uint8_t* const table = table_;
        VertexId* const ids = ids_;
        const FacetCode* const end = w.cavity.data + w.cavity_size;
        // byte at hash(v)             fresh   new byte
        // 255: v is new                 1     added, the number of v
        // other: v has this number      0     unchanged
        const auto add = [&](VertexId v) {
            std::uint8_t& entry = table[hash(v)];
            const std::uint32_t there = entry, fresh = (there + 1) >> 8;
            entry = static_cast<std::uint8_t>(there & (added | (fresh - 1)));
            ids[added] = v;
            added += fresh;
        };
        for (const VertexId v : w.first_corners) add(v);
        for (const FacetCode* code = w.cavity.data; code != end; ++code)
            add(corner(tetrahedra, *code));
        assert(added < Workspace::direct_free && "numbers that a byte does not hold");
        count_ = added;
        // All vertices of the cavity are on its boundary, a sphere. By Euler's formula, a sphere of
        // F triangles has F / 2 + 2 vertices. If there are fewer numbers, two vertices have the
        // same hash.
        return 2 * std::size_t{added} == w.boundary_size + 4;
    }
    MGDT_ALWAYS_INLINE std::uint32_t count() const { return count_; }
    // Returns a function that maps a vertex of the cavity to its number. The function has copies of
    // all that it reads, so that a loop that writes bytes need not read this object again.
    MGDT_ALWAYS_INLINE auto lookup() const {
        return [table = table_](VertexId v) {
            assert(table[hash(v)] != Workspace::direct_free && "a vertex without a number");
            return std::uint32_t{table[hash(v)]};
        };
    }
    // The number of a vertex, or no_index.
    MGDT_ALWAYS_INLINE std::uint32_t find(VertexId v) const {
        const std::uint32_t number = table_[hash(v)];
        return number != Workspace::direct_free && ids_[number] == v ? number : no_index;
    }

  private:
    static std::uint32_t hash(VertexId v) { return v & (Workspace::direct_size - 1); }

    std::uint8_t* const table_;
    VertexId* const ids_;
    std::uint32_t count_ = 0;
};

// An open-addressed hash table, for cavities of any size.
class ProbedNumbers {
  public:
    explicit ProbedNumbers(Workspace& w)
        : table_(w.probed.data),
          ids_(w.ids.data),
          mask_(static_cast<std::uint32_t>(w.probed_size - 1)) {}
    ProbedNumbers(const ProbedNumbers&) = delete;
    ProbedNumbers& operator=(const ProbedNumbers&) = delete;
    ~ProbedNumbers() {
        for (std::uint32_t i = 0; i < count_; ++i) {
            std::uint32_t h = ids_[i] & mask_;
            while (table_[h] != i) h = (h + 1) & mask_;
            table_[h] = no_index;
        }
    }

    template <class Tetrahedra>
    void add_cavity(const Workspace& w, const Tetrahedra& tetrahedra) {
        const auto add = [&](VertexId v) {
            const std::uint32_t h = position(v);
            if (table_[h] != no_index) return;
            assert(2 * std::size_t{count_} < w.probed_size && "the table is more than half full");
            table_[h] = count_;
            ids_[count_++] = v;
        };
        for (const VertexId v : w.first_corners) add(v);
        for (std::size_t i = 0; i < w.cavity_size; ++i) add(corner(tetrahedra, w.cavity.data[i]));
    }
    std::uint32_t count() const { return count_; }
    // Like DirectNumbers::lookup().
    MGDT_ALWAYS_INLINE auto lookup() const {
        return [table = table_, ids = ids_, mask = mask_](VertexId v) {
            std::uint32_t h = v & mask;
            assert(table[h] != no_index && "a vertex without a number");
            while (MGDT_UNLIKELY(ids[table[h]] != v)) h = (h + 1) & mask;
            return table[h];
        };
    }
    std::uint32_t find(VertexId v) const { return table_[position(v)]; }

  private:
    // The position of v in the table, or the free position where v would be added.
    std::uint32_t position(VertexId v) const {
        std::uint32_t h = v & mask_;
        while (table_[h] != no_index && ids_[table_[h]] != v) h = (h + 1) & mask_;
        return h;
    }

    std::uint32_t* const table_;
    VertexId* const ids_;
    const std::uint32_t mask_;
    std::uint32_t count_ = 0;
};

}  // namespace MGDT_ISLAND
}  // namespace mgdt
