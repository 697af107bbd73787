// SPDX-License-Identifier: MIT
// The star: the new point q joined to each facet of the cavity's boundary.
//
// The cavity's vertices are numbered locally, once, and their coordinates taken relative to q;
// spheres and adjacency are then computed over those small arrays. Two new tetrahedra are
// neighbours where their facets share an edge, which one enters as (a, b) and the other as
// (b, a) in a matrix over the local numbers, or in a hash table for large cavities.
// Everything that may run out of memory happens before the mesh changes.
#pragma once

#include "kernel/numbering.hpp"
#include "kernel/spheres.hpp"

namespace mgdt {
inline namespace MGDT_ISA {

// Adjacency by a matrix of 2^shift columns: entry (a, b) is the facet code that has the directed
// edge a b. Entries are written before they are read, so it needs no clearing.
struct EdgeMatrix {
    MGDT_ALWAYS_INLINE void put(std::uint32_t a, std::uint32_t b, FacetCode code) {
        codes[(a << shift) + b] = code;
    }
    MGDT_ALWAYS_INLINE FacetCode get(std::uint32_t a, std::uint32_t b) const {
        return codes[(a << shift) + b];
    }
    FacetCode* codes;
    unsigned shift;
};

// The same by hashing, for cavities of any size.
struct EdgeTable {
    explicit EdgeTable(Workspace& w) : keys(w.edge_keys.data), codes(w.edge_codes.data) {
        // As large as this star wants, not as the largest so far had: it is cleared each time.
        const std::size_t size = Workspace::edge_table_size(w.boundary_size);
        for (std::size_t i = 0; i < size; ++i) keys[i] = free;
        mask = size - 1;
    }
    std::size_t slot(std::uint32_t a, std::uint32_t b) const {
        const std::uint64_t key = (static_cast<std::uint64_t>(a) << 32) | b;
        std::size_t h = static_cast<std::size_t>((key * 0x9E3779B97F4A7C15u) >> 20) & mask;
        while (keys[h] != key && keys[h] != free) h = (h + 1) & mask;
        return h;
    }
    void put(std::uint32_t a, std::uint32_t b, FacetCode code) {
        const std::size_t h = slot(a, b);
        keys[h] = (static_cast<std::uint64_t>(a) << 32) | b;
        codes[h] = code;
    }
    FacetCode get(std::uint32_t a, std::uint32_t b) const { return codes[slot(a, b)]; }

    static constexpr std::uint64_t free = ~std::uint64_t{0};
    std::uint64_t* keys;
    FacetCode* codes;
    std::size_t mask;
};

// Numbers the facets' vertices and enters their edges.
template <class Numbers, class Edges>
MGDT_ALWAYS_INLINE void enter_edges(Workspace& w, const Numbers& numbers, Edges& edges) {
    const BoundaryFacet* const boundary = w.boundary.data;
    std::uint32_t* const as = w.a.data;
    std::uint32_t* const bs = w.b.data;
    std::uint32_t* const cs = w.c.data;
    TetId* const tets = w.tets.data;
    for (std::size_t i = 0; i < w.boundary_size; ++i) {
        const BoundaryFacet& f = boundary[i];
        const std::uint32_t a = numbers[f.v[0]], b = numbers[f.v[1]], c = numbers[f.v[2]];
        as[i] = a;
        bs[i] = b;
        cs[i] = c;
        const TetId slot = w.slots.data[i];
        tets[a] = slot;
        tets[b] = slot;
        tets[c] = slot;
        edges.put(b, c, 4 * slot + 1);
        edges.put(c, a, 4 * slot + 2);
        edges.put(a, b, 4 * slot + 3);
    }
}

template <class Edges>
MGDT_ALWAYS_INLINE void write_links(Tetrahedron* tetrahedra, const Workspace& w, VertexId q,
                                    const Edges& edges) {
    for (std::size_t i = 0; i < w.boundary_size; ++i) {
        const BoundaryFacet f = w.boundary.data[i];
        const std::uint32_t a = w.a.data[i], b = w.b.data[i], c = w.c.data[i];
        const TetId slot = w.slots.data[i];
        Tetrahedron& t = tetrahedra[slot];
        t.v[0] = q;
        t.v[1] = f.v[0];
        t.v[2] = f.v[1];
        t.v[3] = f.v[2];
        t.n[0] = f.outside;
        t.n[1] = edges.get(c, b);
        t.n[2] = edges.get(a, c);
        t.n[3] = edges.get(b, a);
        tetrahedra[f.outside >> 2].n[f.outside & 3] = 4 * slot;
    }
}

template <class Numbers>
MGDT_ALWAYS_INLINE void link_star(Mesh& mesh, Workspace& w, VertexId q, const Numbers& numbers) {
    const auto link = [&](auto edges) {
        enter_edges(w, numbers, edges);
        write_links(mesh.tetrahedra.data(), w, q, edges);
    };
    if (numbers.count <= 32)
        link(EdgeMatrix{w.edge_codes.data, 5});
    else if (numbers.count <= Workspace::matrix_vertices)
        link(EdgeMatrix{w.edge_codes.data, 7});
    else
        link(EdgeTable(w));
}

// Facets with the vertex at infinity got the sphere of nonsense; they are ghosts.
inline std::size_t write_ghosts(Mesh& mesh, const Workspace& w, std::uint32_t infinite) {
    std::size_t ghosts = 0;
    for (std::size_t i = 0; i < w.boundary_size; ++i) {
        const std::uint32_t a = w.a.data[i], b = w.b.data[i], c = w.c.data[i];
        if (a != infinite && b != infinite && c != infinite) continue;
        // The two vertices that follow the one at infinity in cyclic order.
        const std::uint32_t first = a == infinite ? b : b == infinite ? c : a;
        const std::uint32_t second = a == infinite ? c : b == infinite ? a : b;
        set_normal(local_vertex(w, first), local_vertex(w, second),
                   mesh.tetrahedra[w.slots.data[i]]);
        ++ghosts;
    }
    return ghosts;
}

// Outside the normal range the bounds prove nothing: leave every test to the predicates.
inline void distrust_extremes(Mesh& mesh, const Workspace& w, VertexId q) {
    const bool extreme = !in_normal_range(mesh.point(q));
    for (std::size_t i = 0; i < w.boundary_size; ++i) {
        bool trusted = !extreme, ghost = false;
        for (const VertexId v : w.boundary.data[i].v) {
            ghost = ghost || v == infinite_vertex;
            trusted = trusted && (v == infinite_vertex || in_normal_range(mesh.point(v)));
        }
        if (!trusted) mesh.tetrahedra[w.slots.data[i]].e = ghost ? -distrusted : distrusted;
    }
}

// Slots of the cavity serve again: their lines are at hand. Returns how many ghosts went.
MGDT_ALWAYS_INLINE std::size_t choose_slots(Mesh& mesh, Workspace& w) {
    const std::size_t removed = w.cavity_size, created = w.boundary_size;
    const std::size_t reused = removed < created ? removed : created;
    std::size_t ghosts = 0;
    for (std::size_t i = 0; i < reused; ++i) {
        const TetId t = w.cavity.data[i] >> 2;
        ghosts += mesh.tetrahedra[t].is_ghost();
        w.slots.data[i] = t;
    }
    for (std::size_t i = reused; i < removed; ++i) {
        const TetId t = w.cavity.data[i] >> 2;
        ghosts += mesh.tetrahedra[t].is_ghost();
        mesh.free_slot(t);
    }
    for (std::size_t i = reused; i < created; ++i) w.slots.data[i] = mesh.take_slot();
    w.slot_count = created;
    return ghosts;
}

// Replaces the cavity by the star of vertex q; returns one of its tetrahedra.
inline TetId build_star(Mesh& mesh, Workspace& w, VertexId q) {
    const std::size_t removed = w.cavity_size, created = w.boundary_size;

    // All that can fail.
    w.slot_count = 0;
    if (MGDT_UNLIKELY(removed > w.star_removed || created > w.star_created))
        w.grow_star(removed, created);
    mesh.reserve_slots(created > removed ? created - removed : 0,
                       removed > created ? removed - created : 0);

    // The cavity's vertices are read before its slots are given away.
    DirectNumbers direct(w);
    KeyedNumbers keyed(w, mesh.insertion);
    const bool is_direct = direct.add_cavity(mesh, w);
    if (MGDT_UNLIKELY(!is_direct)) {
        direct.reset(w);
        keyed.add_cavity(mesh, w);
    }
    const std::uint32_t vertices = is_direct ? direct.count : keyed.count;
    const std::size_t ghosts_gone = choose_slots(mesh, w);
    if (is_direct) {
        link_star(mesh, w, q, direct);
        direct.reset(w);
    } else {
        link_star(mesh, w, q, keyed);
    }

    // Coordinates relative to q, and any tetrahedron of the star as each vertex's own.
    Vertex* const all = mesh.vertices.data();
    const double* const base = all[q].x;
    std::uint32_t infinite = no_index;
    for (std::uint32_t i = 0; i < vertices; ++i) {
        const VertexId v = w.ids.data[i];
        infinite = v == infinite_vertex ? i : infinite;
        w.x.data[i] = all[v].x[0] - base[0];
        w.y.data[i] = all[v].x[1] - base[1];
        w.z.data[i] = all[v].x[2] - base[2];
        all[v].tet = w.tets.data[i];
    }
    set_spheres(w, vertices, mesh.tetrahedra.data());
    std::size_t ghosts_new = 0;
    if (infinite != no_index) ghosts_new = write_ghosts(mesh, w, infinite);
    mesh.ghost_count = mesh.ghost_count + ghosts_new - ghosts_gone;
    if (MGDT_UNLIKELY(mesh.has_extremes)) distrust_extremes(mesh, w, q);

    all[q].tet = w.slots.data[0];
    w.counters.removed += removed;
    w.counters.created += created;
    return w.slots.data[0];
}

}  // namespace MGDT_ISA
}  // namespace mgdt
