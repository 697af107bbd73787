// SPDX-License-Identifier: MIT
// Finds which facets of a cavity's boundary share an edge. A facet (a, b, c), seen from the new
// point, has the directed edges ab, bc and ca; the adjacent facet has the reversed edge.
#pragma once

#include <cassert>

#include "kernel/island.hpp"
#include "kernel/workspace.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// A matrix of 2^shift columns: entry (a, b) is the facet code of the edge ab. Each entry is written
// before it is read, so the matrix needs no clearing.
template <unsigned shift>
class EdgeMatrix {
  public:
    MGDT_ALWAYS_INLINE explicit EdgeMatrix(FacetCode* codes) : codes_(codes) {}
    MGDT_ALWAYS_INLINE void put(std::uint32_t a, std::uint32_t b, FacetCode code) {
        assert(a >> shift == 0 && b >> shift == 0 && "the matrix is too small");
        assert(a != b && "an edge from a vertex to itself");
        codes_[(a << shift) + b] = code;
    }
    MGDT_ALWAYS_INLINE FacetCode get(std::uint32_t a, std::uint32_t b) const {
        assert(a >> shift == 0 && b >> shift == 0 && "the matrix is too small");
        return codes_[(a << shift) + b];
    }

  private:
    FacetCode* const codes_;
};

// A hash table of the edges, for cavities of any size.
class EdgeTable {
  public:
    explicit EdgeTable(Workspace& w) : keys_(w.edge_keys.data), codes_(w.edge_codes.data) {
        // The table is cleared for each star, so it is no larger than this star needs.
        const std::size_t size = Workspace::edge_table_size(w.boundary_size);
        for (std::size_t i = 0; i < size; ++i) keys_[i] = free;
        mask_ = size - 1;
    }
    void put(std::uint32_t a, std::uint32_t b, FacetCode code) {
        const std::size_t h = slot(a, b);
        assert(keys_[h] == free && "two facets have an edge in the same direction");
        keys_[h] = key(a, b);
        codes_[h] = code;
    }
    FacetCode get(std::uint32_t a, std::uint32_t b) const {
        assert(keys_[slot(a, b)] != free && "no facet has this edge");
        return codes_[slot(a, b)];
    }
    // The upper half of the product depends on all bits of both a and b.
    static std::size_t hash(std::uint32_t a, std::uint32_t b) {
        constexpr std::uint64_t golden = 0x9E3779B97F4A7C15u;
        return static_cast<std::size_t>(((a * golden + b) * golden) >> 32);
    }

  private:
    static std::uint64_t key(std::uint32_t a, std::uint32_t b) {
        return (static_cast<std::uint64_t>(a) << 32) | b;
    }
    std::size_t slot(std::uint32_t a, std::uint32_t b) const {
        std::size_t h = hash(a, b) & mask_;
        while (keys_[h] != key(a, b) && keys_[h] != free) h = (h + 1) & mask_;
        return h;
    }

    static constexpr std::uint64_t free = ~std::uint64_t{0};
    std::uint64_t* const keys_;
    FacetCode* const codes_;
    std::size_t mask_;
};

}  // namespace MGDT_ISLAND
}  // namespace mgdt
