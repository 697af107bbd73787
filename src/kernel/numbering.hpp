// SPDX-License-Identifier: MIT
// Local numbers for the vertices of a cavity. The tables are the thread's own, not marks in
// vertex records, so that two threads may have one vertex in their cavities.
#pragma once

#include "kernel/isa.hpp"
#include "kernel/workspace.hpp"

namespace mgdt {
inline namespace MGDT_ISA {

// Calls add(v) for the vertices of the cavity: all four of its first tetrahedron, and of each
// other one the vertex opposite the face it was reached through, since its others are there.
template <class Add>
MGDT_ALWAYS_INLINE void for_each_vertex(const Mesh& mesh, const Workspace& w, Add add) {
    const Tetrahedron* const tetrahedra = mesh.tetrahedra.data();
    for (const VertexId v : tetrahedra[w.cavity.data[0] >> 2].v) add(v);
    for (std::size_t i = 1; i < w.cavity_size; ++i) {
        const FacetCode code = w.cavity.data[i];
        add(tetrahedra[code >> 2].v[code & 3]);
    }
}

// One byte a vertex, found by its hash alone: right for nearly all cavities. Two vertices with
// one hash, or too many, and it gives up.
struct DirectNumbers {
    explicit DirectNumbers(Workspace& w) : table(w.direct.data) {}

    static std::uint32_t hash(VertexId v) { return (v ^ (v >> 11)) & (Workspace::direct_size - 1); }
    MGDT_ALWAYS_INLINE bool add_cavity(const Mesh& mesh, Workspace& w) {
        VertexId* const ids = w.ids.data;
        if (w.cavity_size + 3 > Workspace::direct_most) return false;
        std::uint32_t clashes = 0, added = 0;
        for_each_vertex(mesh, w, [&](VertexId v) {
            const std::uint32_t h = hash(v);
            const std::uint32_t there = table[h];
            const bool fresh = there == Workspace::direct_free;
            clashes += static_cast<unsigned>(!fresh) & static_cast<unsigned>(ids[there] != v);
            table[h] = static_cast<std::uint8_t>(fresh ? added : there);
            ids[added] = v;
            added += fresh;
        });
        count = added;
        return clashes == 0;
    }
    MGDT_ALWAYS_INLINE std::uint32_t operator[](VertexId v) const { return table[hash(v)]; }
    MGDT_ALWAYS_INLINE void reset(const Workspace& w) {
        for (std::uint32_t i = 0; i < count; ++i)
            table[hash(w.ids.data[i])] = Workspace::direct_free;
    }

    std::uint8_t* table;
    std::uint32_t count = 0;
};

// Open-addressed, for any cavity; entries expire with the insertion's number.
struct KeyedNumbers {
    KeyedNumbers(Workspace& w, std::uint32_t insertion)
        : stamp(static_cast<std::uint64_t>(insertion) << 32),
          keys(w.keyed_keys.data),
          values(w.keyed_values.data),
          mask(static_cast<std::uint32_t>(w.keyed_size - 1)) {}

    std::uint32_t hash(VertexId v) const { return (v ^ (v >> 9)) & mask; }
    void add_cavity(const Mesh& mesh, Workspace& w) {
        for_each_vertex(mesh, w, [&](VertexId v) {
            const std::uint64_t wanted = stamp | v;
            std::uint32_t h = hash(v);
            while ((keys[h] ^ stamp) >> 32 == 0 && keys[h] != wanted) h = (h + 1) & mask;
            if (keys[h] == wanted) return;
            keys[h] = wanted;
            values[h] = count;
            w.ids.data[count++] = v;
        });
    }
    std::uint32_t operator[](VertexId v) const {
        const std::uint64_t wanted = stamp | v;
        std::uint32_t h = hash(v);
        while (keys[h] != wanted) h = (h + 1) & mask;
        return values[h];
    }

    std::uint64_t stamp;
    std::uint64_t* keys;
    std::uint32_t* values;
    std::uint32_t mask;
    std::uint32_t count = 0;
};

}  // namespace MGDT_ISA
}  // namespace mgdt
