// SPDX-License-Identifier: MIT
// The star: the new point q joined to each facet of the cavity's boundary.
//
// The cavity's vertices are numbered locally, once; spheres and adjacency are then computed over
// small arrays. Everything that may run out of memory happens before the mesh changes.
#pragma once

#include <algorithm>
#include <cassert>

#include "kernel/adjacency.hpp"
#include "kernel/assertions.hpp"
#include "kernel/local_numbers.hpp"
#include "kernel/spheres.hpp"
#include "kernel/words.hpp"

namespace mgdt {
inline namespace MGDT_ISLAND {

// The local numbers of each facet's vertices: arrays of bytes for a small star, of words for any.
struct SmallCorners {
    Workspace::SmallStar* star;
    MGDT_ALWAYS_INLINE void put(std::size_t i, std::uint32_t a, std::uint32_t b,
                                std::uint32_t c) const {
        assert(i < sizeof star->a && "more facets than a small star has");
        star->a[i] = static_cast<std::uint8_t>(a);
        star->b[i] = static_cast<std::uint8_t>(b);
        star->c[i] = static_cast<std::uint8_t>(c);
    }
};
struct Corners {
    std::uint32_t *as, *bs, *cs;
    MGDT_ALWAYS_INLINE void put(std::size_t i, std::uint32_t a, std::uint32_t b,
                                std::uint32_t c) const {
        as[i] = a;
        bs[i] = b;
        cs[i] = c;
    }
};

// Writes the vertices of the new tetrahedra, (q, a, b, c) for a facet (a, b, c) seen from inside,
// and links each new tetrahedron with the one on the other side of the facet. Fills `edges` for
// link_inside(); face k of a new tetrahedron is opposite its vertex k. The function is not inlined,
// so that the loop has all registers.
template <class Tetrahedra, class Lookup, class Edges, class CornersOf>
MGDT_NOT_INLINE void link_outside(const Tetrahedra tetrahedra, const Workspace& w, VertexId q,
                                  Lookup number, Edges edges, CornersOf corners) {
    const FacetCode* const boundary = w.boundary.data;
    const FacetCode* const slots = w.slots.data;
    const std::size_t size = w.boundary_size;
    for (std::size_t i = 0; i < size; ++i) {
        const FacetCode code = boundary[i];
        const FacetCode mine = slots[i];
        Tetrahedron& outside = tetrahedra.of(code);
        Tetrahedron& t = tetrahedra.of_first(mine);
        const VertexId* const v = write_vertices(outside, code, q, t);
        assert(&outside != &t && "a facet of the boundary is inside the cavity");
        t.n[0] = code;
        outside.n[face_of(code)] = mine;
        const std::uint32_t a = number(v[0]), b = number(v[1]), c = number(v[2]);
        corners.put(i, a, b, c);
        edges.put(b, c, mine + 1);
        edges.put(c, a, mine + 2);
        edges.put(a, b, mine + 3);
    }
}

// Links the new tetrahedron of a facet (a, b, c) with other tetrahedra of the star. The neighbour
// across an edge has this edge in the opposite direction.
template <class Edges>
MGDT_ALWAYS_INLINE void link_inside(const Edges& edges, std::uint32_t a, std::uint32_t b,
                                    std::uint32_t c, Tetrahedron& t) {
    assert(a != b && b != c && c != a && "two vertices of a facet are the same");
    t.n[1] = edges.get(c, b);
    t.n[2] = edges.get(a, c);
    t.n[3] = edges.get(b, a);
}

struct GhostsOfStar {
    std::size_t count;
    TetId last;
};

// Counts the ghosts of the star, and finds the last one. The new tetrahedron of a facet is a ghost
// if vertex b or c is at infinity. The processor cannot predict this, so the code is branchless.
template <class Number>
MGDT_ALWAYS_INLINE GhostsOfStar ghosts_of_star(const Workspace& w, std::uint32_t infinite,
                                               const Number* const bs, const Number* const cs) {
    assert(w.boundary_size == w.slot_count && "a facet without a slot, or a slot without a facet");
    std::uint32_t count = 0, last = 0;
    for (std::size_t i = 0; i < w.boundary_size; ++i) {
        const std::uint32_t is_ghost = static_cast<std::uint32_t>(bs[i] == infinite) |
                                       static_cast<std::uint32_t>(cs[i] == infinite);
        count += is_ghost;
        last = std::max(last, is_ghost * static_cast<std::uint32_t>(i));
    }
    return {count, tetrahedron_of(w.slots.data[last])};
}

// Sets the bound of each new tetrahedron with an extreme vertex to infinity, which leaves every
// test to the predicates: the computed bounds are proved for the normal range only.
inline void distrust_extremes(Mesh& mesh, const Workspace& w, VertexId q) {
    const bool extreme = !in_normal_range(mesh.point(q));
    for (std::size_t i = 0; i < w.boundary_size; ++i) {
        bool trusted = !extreme;
        const TetId id = tetrahedron_of(w.slots.data[i]);
        const Tetrahedron& t = mesh.tetrahedra[id];
        for (const VertexId v : t.v)
            trusted = trusted && (v == infinite_vertex || in_normal_range(mesh.point(v)));
        if (!trusted)
            mesh.tetrahedra.sphere(id).e = upper_half(t.is_ghost() ? -infinity : infinity);
    }
}

// Chooses the slots of the star: first the slots of the cavity, which are in the cache.
template <class Access>
MGDT_ALWAYS_INLINE void choose_slots(Access access, Workspace& w) {
    const std::size_t removed = w.cavity_size, created = w.boundary_size;
    assert(removed <= w.star_removed && created <= w.star_created &&
           "there is no room for the star");
    FacetCode* const slots = w.slots.data;
    // The loop runs in blocks, so that the branch at its end is predictable. The array has room for
    // whole blocks.
    constexpr std::size_t block = 32;
    const FacetCode* const cavity = w.cavity.data;
    for (std::size_t i = 0; i < removed; i += block)
        for (std::size_t k = i; k < i + block; ++k) slots[k] = first_facet_of(cavity[k]);
    if (MGDT_UNLIKELY(created < removed)) {
        for (std::size_t i = created; i < removed; ++i) access.free_slot(tetrahedron_of(slots[i]));
    } else {
        access.take_slots(slots + removed, created - removed);
    }
    w.slot_count = created;
}

// Counts the ghosts of the cavity, without branches that cannot be predicted.
template <class Tetrahedra>
MGDT_ALWAYS_INLINE std::size_t count_ghosts(const Tetrahedra tetrahedra, const Workspace& w) {
    std::size_t ghosts = 0;
    for (std::size_t i = 0; i < w.cavity_size; ++i) {
        const VertexId* const v = tetrahedra.of(w.cavity.data[i]).v;
        ghosts += hide_from_optimizer(static_cast<std::uint32_t>(v[2] == infinite_vertex) |
                                      static_cast<std::uint32_t>(v[3] == infinite_vertex));
    }
    return ghosts;
}

// Sets the hints of all vertices of a large star, whose slots may be far apart in space. A small
// star can leave old hints in place.
template <class Access, class Tetrahedra>
MGDT_NOT_INLINE void set_hints_of_star(Access access, const Tetrahedra tetrahedra,
                                       const Workspace& w) {
    for (std::size_t i = 0; i < w.boundary_size; ++i) {
        const FacetCode slot = w.slots.data[i];
        const VertexId* const v = tetrahedra.of_first(slot).v;
        for (unsigned k = 1; k < 4; ++k) access.set_vertex_hint(v[k], tetrahedron_of(slot));
    }
}

// Builds a star of few vertices, with byte numbers and with its edges in a matrix of 32 by 32.
template <class Access, class Tetrahedra, class Numbers>
MGDT_ALWAYS_INLINE void build_small(const Tetrahedra tetrahedra, const Mesh& mesh, Workspace& w,
                                    VertexId q, const Numbers& numbers, std::uint32_t infinite) {
    Workspace::SmallStar& s = w.small;
    const EdgeMatrix<5> edges(s.edges);
    link_outside(tetrahedra, w, q, numbers.lookup(), edges, SmallCorners{&s});
    const auto link = [edges, star = &s](std::size_t i, Tetrahedron& t) {
        link_inside(edges, star->a[i], star->b[i], star->c[i], t);
    };
    if constexpr (Access::SphereSource::are_kept)
        set_spheres_small(w, mesh.vertices.data(), q, numbers.count(), infinite, tetrahedra, link);
    else
        link_each(tetrahedra, w, link);
}

// Builds a star of any size. Its edges are in a matrix if that is large enough, otherwise in a hash
// table.
template <class Access, class Tetrahedra, class Numbers>
MGDT_ALWAYS_INLINE void build_large(Access access, const Tetrahedra tetrahedra, const Mesh& mesh,
                                    Workspace& w, VertexId q, const Numbers& numbers,
                                    std::uint32_t infinite) {
    const auto link = [&](auto edges) {
        link_outside(tetrahedra, w, q, numbers.lookup(), edges,
                     Corners{w.a.data, w.b.data, w.c.data});
        link_each(tetrahedra, w, [&](std::size_t i, Tetrahedron& t) {
            link_inside(edges, w.a.data[i], w.b.data[i], w.c.data[i], t);
        });
    };
    if (numbers.count() <= Workspace::medium_vertices)
        link(EdgeMatrix<6>(w.edge_codes.data));
    else if (numbers.count() <= Workspace::matrix_vertices)
        link(EdgeMatrix<8>(w.edge_codes.data));
    else
        link(EdgeTable(w));
    if constexpr (Access::SphereSource::are_kept)
        set_spheres(w, mesh.vertices.data(), q, numbers.count(), infinite, tetrahedra);
    if (numbers.count() > Workspace::medium_vertices) set_hints_of_star(access, tetrahedra, w);
}

// Replaces the cavity, whose vertices are numbered, by the star of q.
template <class Access, class Numbers>
MGDT_ALWAYS_INLINE void replace_cavity(Access access, Mesh& mesh, Workspace& w, VertexId q,
                                       const Numbers& numbers) {
    const std::uint32_t infinite = numbers.find(infinite_vertex);
    assert(numbers.count() >= 4 && "the vertices of a cavity span space");
    const bool at_hull = infinite != no_index;
    const auto tetrahedra = mesh.tetrahedra.view<Access::SphereSource::are_kept>();
    const std::size_t ghosts_gone = at_hull ? count_ghosts(tetrahedra, w) : 0;
    choose_slots(access, w);
    const bool is_small = numbers.count() <= Workspace::SmallStar::most_vertices;
    if (is_small)
        build_small<Access>(tetrahedra, mesh, w, q, numbers, infinite);
    else
        build_large(access, tetrahedra, mesh, w, q, numbers, infinite);
    if (at_hull) {
        const GhostsOfStar ghosts = is_small ? ghosts_of_star(w, infinite, w.small.b, w.small.c)
                                             : ghosts_of_star(w, infinite, w.b.data, w.c.data);
        access.made_ghost(ghosts.last);
        access.count_ghosts(ghosts.count, ghosts_gone);
    }
}

// Replaces the cavity by the star of vertex q; returns one of its tetrahedra.
template <class Access>
TetId build_star(Access access, Mesh& mesh, Workspace& w, VertexId q) {
    const std::size_t removed = w.cavity_size, created = w.boundary_size;

    // Everything that can fail comes first.
    w.slot_count = 0;
    try {
        if (MGDT_UNLIKELY(removed > w.star_removed || created > w.star_created))
            w.grow_star(removed, created);
        access.reserve_slots(created > removed ? created - removed : 0,
                             removed > created ? removed - created : 0);
    } catch (...) {
        w.restore_cavity(mesh.tetrahedra, removed);
        throw;
    }

    assert_cavity_is_sound(access, mesh, w);
    const auto tetrahedra = mesh.tetrahedra.view<Access::SphereSource::are_kept>();
    bool is_direct;
    {
        DirectNumbers numbers(w);
        is_direct = numbers.add_cavity(w, tetrahedra);
        if (is_direct) replace_cavity(access, mesh, w, q, numbers);
    }
    if (MGDT_UNLIKELY(!is_direct)) {
        ProbedNumbers numbers(w);
        numbers.add_cavity(w, tetrahedra);
        replace_cavity(access, mesh, w, q, numbers);
    }
    if constexpr (Access::SphereSource::are_kept)
        if (MGDT_UNLIKELY(mesh.has_extremes)) distrust_extremes(mesh, w, q);
    assert_star_is_sound(mesh, w, q);

    // The new vertex and three of its neighbours get new hints. Insertions do this often enough for
    // every vertex to stay near its hint.
    const TetId first = tetrahedron_of(w.slots.data[0]);
    for (const VertexId v : mesh.tetrahedra[first].v) access.set_vertex_hint(v, first);
    w.counters.removed += removed;
    w.counters.created += created;
    return first;
}

}  // namespace MGDT_ISLAND
}  // namespace mgdt
