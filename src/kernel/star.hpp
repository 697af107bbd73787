// SPDX-License-Identifier: MIT
// The star: the new point q joined to each facet of the cavity's boundary.
//
// The cavity's vertices are numbered locally, once, and their coordinates taken relative to q;
// spheres and adjacency are then computed over those small arrays. Two new tetrahedra are
// neighbours where their facets share an edge, which one enters as (a, b) and the other as
// (b, a) in a small matrix over the local numbers, or in a hash table for large cavities.
// Everything that may run out of memory happens before the mesh changes.
#pragma once

#include "kernel/workspace.hpp"

namespace mgdt {

// Local numbers of vertices: an open-addressed table whose entries expire with the insertion.
// It is the thread's own, so that two threads may have the same vertex in their cavities.
struct LocalNumbering {
    LocalNumbering(Workspace& w, std::uint32_t insertion, std::size_t at_most)
        : stamp(static_cast<std::uint64_t>(insertion) << 32) {
        std::size_t size = w.numbering_keys.size();
        if (size < 2 * at_most) {
            if (size == 0) size = 512;
            while (size < 2 * at_most) size *= 2;
            // Keys last: their number tells that both are there.
            w.numbering_keys.clear();
            w.numbering_values.resize(size);
            w.numbering_keys.resize(size, 0);
        }
        w.local_ids.grow(at_most + 1);
        keys = w.numbering_keys.data();
        values = w.numbering_values.data();
        ids = w.local_ids.data();
        mask = static_cast<std::uint32_t>(size - 1);
    }

    std::uint32_t hash(VertexId v) const { return (v ^ (v >> 9)) & mask; }
    // An entry of this insertion has its number in the upper half.
    bool is_current(std::uint64_t key) const { return ((key ^ stamp) >> 32) == 0; }

    void add(VertexId v) {
        const std::uint64_t wanted = stamp | v;
        std::uint32_t h = hash(v);
        while (__builtin_expect(is_current(keys[h]) & (keys[h] != wanted), 0)) h = (h + 1) & mask;
        const bool fresh = keys[h] != wanted;
        values[h] = fresh ? count : values[h];
        keys[h] = wanted;
        ids[count] = v;
        count += fresh;
    }
    std::uint32_t operator[](VertexId v) const {
        const std::uint64_t wanted = stamp | v;
        std::uint32_t h = hash(v);
        while (__builtin_expect(keys[h] != wanted, 0)) h = (h + 1) & mask;
        return values[h];
    }

    std::uint64_t stamp;
    std::uint64_t* keys;
    std::uint32_t* values;
    VertexId* ids;
    std::uint32_t mask;
    std::uint32_t count = 0;
};

// Adjacency by a matrix: entry (a, b) is the facet code that has the directed edge a b.
struct EdgeMatrix {
    static constexpr std::uint32_t max_vertices = 128;

    EdgeMatrix(Workspace& w, std::uint32_t vertices) : shift(5) {
        while ((1u << shift) < vertices) ++shift;
        w.edge_codes.resize(std::size_t{1} << (2 * shift));
        codes = w.edge_codes.data();
    }
    void put(std::uint32_t a, std::uint32_t b, FacetCode code) { codes[(a << shift) + b] = code; }
    FacetCode get(std::uint32_t a, std::uint32_t b) const { return codes[(a << shift) + b]; }

    std::uint32_t* codes;
    unsigned shift;
};

// The same by hashing, for cavities of any size.
struct EdgeTable {
    EdgeTable(Workspace& w, std::size_t facets) {
        std::size_t size = 1024;
        while (size < 6 * facets) size *= 2;
        w.edge_keys.clear();
        w.edge_keys.resize(size, ~std::uint64_t{0});
        w.edge_codes.resize(size);
        keys = w.edge_keys.data();
        codes = w.edge_codes.data();
        mask = size - 1;
    }
    std::size_t slot(std::uint32_t a, std::uint32_t b) const {
        const std::uint64_t key = (static_cast<std::uint64_t>(a) << 32) | b;
        std::size_t h = static_cast<std::size_t>((key * 0x9E3779B97F4A7C15u) >> 20) & mask;
        while (keys[h] != key && keys[h] != ~std::uint64_t{0}) h = (h + 1) & mask;
        return h;
    }
    void put(std::uint32_t a, std::uint32_t b, FacetCode code) {
        const std::size_t h = slot(a, b);
        keys[h] = (static_cast<std::uint64_t>(a) << 32) | b;
        codes[h] = code;
    }
    FacetCode get(std::uint32_t a, std::uint32_t b) const { return codes[slot(a, b)]; }

    std::uint64_t* keys;
    std::uint32_t* codes;
    std::size_t mask;
};

// Numbers the cavity's vertices. A tetrahedron that was reached through a face adds at most the
// vertex opposite; only the first adds four.
inline std::uint32_t number_vertices(const Mesh& mesh, Workspace& w, LocalNumbering& numbering) {
    const Tetrahedron* tetrahedra = mesh.tetrahedra.data();
    const Tetrahedron& first = tetrahedra[w.cavity[0] >> 2];
    for (const VertexId v : first.v) numbering.add(v);
    for (std::size_t i = 1; i < w.cavity.size(); ++i) {
        const FacetCode code = w.cavity[i];
        numbering.add(tetrahedra[code >> 2].v[code & 3]);
    }
    return numbering.count;
}

template <class Edges>
inline void enter_edges(Workspace& w, const LocalNumbering& numbering, Edges& edges) {
    const std::size_t facets = w.boundary.size();
    for (std::size_t i = 0; i < facets; ++i) {
        const BoundaryFacet& f = w.boundary[i];
        const std::uint32_t a = numbering[f.v[0]], b = numbering[f.v[1]], c = numbering[f.v[2]];
        w.local_facets[i] = {a, b, c};
        const FacetCode code = 4 * w.slots[i];
        edges.put(b, c, code + 1);
        edges.put(c, a, code + 2);
        edges.put(a, b, code + 3);
    }
}

template <class Edges>
inline void write_tetrahedra(Mesh& mesh, Workspace& w, VertexId q, const Edges& edges) {
    Tetrahedron* tetrahedra = mesh.tetrahedra.data();
    const LocalVertex* local = w.local_vertices.data();
    const std::size_t facets = w.boundary.size();
    for (std::size_t i = 0; i < facets; ++i) {
        const BoundaryFacet& f = w.boundary[i];
        const auto [a, b, c] = w.local_facets[i];
        const TetId slot = w.slots[i];
        Tetrahedron& t = tetrahedra[slot];
        t.v[0] = q;
        t.v[1] = f.v[0];
        t.v[2] = f.v[1];
        t.v[3] = f.v[2];
        t.n[0] = f.outside;
        t.n[1] = edges.get(c, b);
        t.n[2] = edges.get(a, c);
        t.n[3] = edges.get(b, a);
        set_sphere(local[a], local[b], local[c], t);
        tetrahedra[f.outside >> 2].n[f.outside & 3] = 4 * slot;
    }
}

// Facets with the vertex at infinity got the sphere of nonsense; they are ghosts.
inline std::size_t write_ghosts(Mesh& mesh, const Workspace& w) {
    std::size_t ghosts = 0;
    for (std::size_t i = 0; i < w.boundary.size(); ++i) {
        const auto [a, b, c] = w.local_facets[i];
        const std::uint32_t at = w.infinite_local;
        if (a != at && b != at && c != at) continue;
        const LocalVertex* local = w.local_vertices.data();
        // The two vertices that follow the one at infinity in cyclic order.
        const std::uint32_t first = a == at ? b : b == at ? c : a;
        const std::uint32_t second = a == at ? c : b == at ? a : b;
        set_normal(local[first], local[second], mesh.tetrahedra[w.slots[i]]);
        ++ghosts;
    }
    return ghosts;
}

// Outside the normal range the bounds prove nothing: leave every test to the predicates.
inline void distrust_extremes(Mesh& mesh, const Workspace& w, VertexId q) {
    const bool extreme = !in_normal_range(mesh.point(q));
    for (std::size_t i = 0; i < w.boundary.size(); ++i) {
        bool trusted = !extreme, ghost = false;
        for (const VertexId v : w.boundary[i].v) {
            ghost = ghost || v == infinite_vertex;
            trusted = trusted && (v == infinite_vertex || in_normal_range(mesh.point(v)));
        }
        if (!trusted) mesh.tetrahedra[w.slots[i]].e = ghost ? -distrusted : distrusted;
    }
}

// Replaces the cavity by the star of vertex q; returns one of its tetrahedra.
inline TetId build_star(Mesh& mesh, Workspace& w, VertexId q) {
    const std::size_t removed = w.cavity.size(), created = w.boundary.size();

    // All that can fail.
    LocalNumbering numbering(w, mesh.insertion, removed + 3);
    const std::uint32_t vertices = number_vertices(mesh, w, numbering);
    w.local_vertices.clear();
    w.local_vertices.grow(vertices);
    w.local_facets.clear();
    w.local_facets.grow(created);
    w.slots.clear();
    w.slots.grow(created);
    if (created > removed)
        mesh.reserve_slots(created - removed);
    else
        mesh.free_slots.grow(mesh.free_slots.size() + removed - created);
    const bool small = vertices <= EdgeMatrix::max_vertices;
    if (!small) EdgeTable(w, created);
    EdgeMatrix matrix(w, small ? vertices : 1);

    // Slots of the cavity serve again: their lines are at hand.
    std::size_t removed_ghosts = 0;
    for (std::size_t i = 0; i < removed; ++i) {
        const TetId t = w.cavity[i] >> 2;
        removed_ghosts += mesh.tetrahedra[t].is_ghost();
        if (i < created)
            w.slots.push_back(t);
        else
            mesh.free_slot(t);
    }
    for (std::size_t i = removed; i < created; ++i) w.slots.push_back(mesh.take_slot());

    w.infinite_local = no_index;
    const double* base = mesh.point(q);
    w.local_vertices.resize(vertices);
    for (std::uint32_t i = 0; i < vertices; ++i) {
        const VertexId v = w.local_ids.data()[i];
        if (v == infinite_vertex) w.infinite_local = i;
        w.local_vertices[i] = relative_to(mesh.point(v), base);
    }
    w.local_facets.resize(created);
    if (small) {
        enter_edges(w, numbering, matrix);
        write_tetrahedra(mesh, w, q, matrix);
    } else {
        EdgeTable table(w, created);
        enter_edges(w, numbering, table);
        write_tetrahedra(mesh, w, q, table);
    }
    const std::size_t created_ghosts =
        w.infinite_local == no_index ? 0 : write_ghosts(mesh, w);
    mesh.ghost_count = mesh.ghost_count + created_ghosts - removed_ghosts;
    if (mesh.has_extremes) distrust_extremes(mesh, w, q);

    // Any tetrahedron of the star will do as a vertex's own; the last that has it is at hand.
    Vertex* all = mesh.vertices.data();
    for (std::size_t i = 0; i < created; ++i) {
        const BoundaryFacet& f = w.boundary[i];
        all[f.v[0]].tet = w.slots[i];
        all[f.v[1]].tet = w.slots[i];
        all[f.v[2]].tet = w.slots[i];
    }
    all[q].tet = w.slots[0];
    w.counters.removed += removed;
    w.counters.created += created;
    return w.slots[0];
}

}  // namespace mgdt
