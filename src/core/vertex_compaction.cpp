// SPDX-License-Identifier: MIT
#include "core/vertex_compaction.hpp"

#include <algorithm>
#include <new>

#include "kernel/circumsphere.hpp"
#include "mesh/star_traversal.hpp"
#include "query/locate.hpp"

namespace mgdt {
namespace {

constexpr std::size_t items_of_a_part = 65536;
// Renumbering one vertex in its star takes as long as a loop over this many tetrahedra.
constexpr std::size_t passed = 2048;

// Replaces vertex `from` by `to` in all tetrahedra of `from`. `first` is one of these tetrahedra;
// `star` is working memory.
void renumber_star(Mesh& mesh, TetId first, VertexId from, VertexId to, Buffer<TetId>& star) {
    star.clear();
    const auto renumber = [&](TetId t) {
        for (VertexId& v : mesh.tetrahedra[t].v) {
            if (v != from) continue;
            star.push_back(t);
            v = to;
        }
    };
    renumber(first);
    traverse_star(mesh, to, star, [&](FacetCode facet) { renumber(tetrahedron_of(facet)); });
}

// Gives each vertex from `end` on the number in its record (`moved_to`), star by star. Vertices
// without tetrahedra are skipped.
void renumber_stars(Mesh& mesh, const KernelCalls& calls, std::size_t end) {
    const Locator locator{mesh, calls, nullptr};
    Buffer<TetId> star(mesh.vertex_hint.allocator());
    for (std::size_t v = end; v < mesh.vertices.size(); ++v) {
        if (mesh.vertex_hint[v] == no_tetrahedron) continue;
        const auto from = static_cast<VertexId>(v);
        renumber_star(mesh, locator.tetrahedron_of(from), from, mesh.vertices[v].moved_to, star);
    }
}

void renumber(const Mesh& mesh, std::size_t end, VertexId& v) noexcept {
    if (v >= end) v = mesh.vertices[v].moved_to;
}

// Does the same as renumber_stars(), in one loop over all tetrahedra.
void renumber_all(Team& team, Mesh& mesh, std::size_t end) {
    team.split(mesh.tetrahedra.size(), items_of_a_part,
               [&](std::size_t from, std::size_t to, unsigned) {
                   for (std::size_t t = from; t < to; ++t)
                       if (!mesh.tetrahedra[t].is_dead())
                           for (VertexId& v : mesh.tetrahedra[t].v) renumber(mesh, end, v);
               });
}

// Gives vertices from `end` on the numbers in their records. `moved` of them have tetrahedra.
void renumber_moved(State& state, Team& team, std::size_t end, std::size_t moved) noexcept {
    if (state.mesh.live_count() == 0) return;
    bool is_done = moved <= state.mesh.tetrahedra.size() / passed;
    try {
        if (is_done) renumber_stars(state.mesh, state.calls(), end);
    } catch (const std::bad_alloc&) {
        is_done = false;
    }
    if (!is_done) renumber_all(team, state.mesh, end);
}

// Gives points from `first_point` on, which may map to vertices from `end` on, their new vertices.
void renumber_points(State& state, Team& team, std::size_t end, std::size_t first_point) noexcept {
    VertexId* const of_points = state.points.map.data() + first_point;
    team.split(state.points.map.size() - first_point, items_of_a_part,
               [&](std::size_t from, std::size_t to, unsigned) {
                   for (std::size_t i = from; i < to; ++i) renumber(state.mesh, end, of_points[i]);
               });
}

// Does the same for the points at the vertices that closed gaps.
void renumber_points_at(State& state, Team& team, const Buffer<VertexId>& gaps,
                        std::size_t end) noexcept {
    Buffer<VertexId>& map = state.points.map;
    const EqualPointLists& equals = state.points.equals;
    const bool are_listed = equals.have_all(map.size());
    for (const VertexId gap : gaps) {
        if (gap >= end) continue;
        const Vertex& vertex = state.mesh.vertices[gap];
        const VertexId before = map[vertex.index];
        if (vertex.moved_to != has_equals)
            map[vertex.index] = gap;
        else if (are_listed)
            equals.for_each(map, vertex, before, [&](std::uint32_t i) { map[i] = gap; });
        else
            return renumber_points(state, team, end, 0);
    }
}

}  // namespace

void compact_vertices(State& state, Team& team, std::size_t begin,
                      std::size_t first_point) noexcept {
    Buffer<TetId>& hints = state.mesh.vertex_hint;
    const auto forget = [&](std::size_t v) {
        VertexId& of_point = state.points.map[state.mesh.vertices[v].index];
        if (of_point == v) of_point = infinite_vertex;
    };
    std::size_t end = state.mesh.vertices.size(), moved = 0;
    for (std::size_t v = begin; v < end; ++v) {
        if (hints[v] != no_tetrahedron) continue;
        forget(v);
        while (end > v + 1 && hints[end - 1] == no_tetrahedron) forget(--end);
        if (--end == v) break;
        // The old record of a moved vertex keeps the new number of the vertex.
        state.mesh.vertices[v] = state.mesh.vertices[end];
        hints[v] = hints[end];
        state.mesh.vertices[end].moved_to = static_cast<VertexId>(v);
        ++moved;
    }
    if (moved > 0) {
        renumber_moved(state, team, end, moved);
        renumber_points(state, team, end, first_point);
    }
    state.mesh.vertices.resize_within_capacity(end);
    hints.resize_within_capacity(end);
}

void close_gaps(State& state, Buffer<VertexId>& gaps) noexcept {
    if (gaps.empty()) return;
    std::sort(gaps.begin(), gaps.end());
    Buffer<TetId>& hints = state.mesh.vertex_hint;
    std::size_t end = state.mesh.vertices.size(), moved = 0;
    for (std::size_t i = 0, left = gaps.size(); i < left; ++i) {
        // Gaps at the end of the array are closed by making it shorter.
        while (left > i && gaps[left - 1] == end - 1) --left, --end;
        if (left == i) break;
        const VertexId gap = gaps[i];
        --end;
        state.mesh.vertices[gap] = state.mesh.vertices[end];
        if (!hints.empty()) hints[gap] = hints[end];
        state.mesh.vertices[end].moved_to = gap;
        ++moved;
    }
    Team team;
    if (moved > 0) {
        renumber_moved(state, team, end, moved);
        renumber_points_at(state, team, gaps, end);
    }
    state.mesh.vertices.resize_within_capacity(end);
    if (!hints.empty()) hints.resize_within_capacity(end);
    if (state.mesh.live_count() == 0) {
        // The remaining points do not span space. They are held until further points span space
        // with them.
        AffineBasis basis;
        for (VertexId v = 1; v < state.mesh.vertices.size() && basis.dimension() < 3; ++v)
            basis.add(state.mesh.point(v));
        state.points.basis = basis;
        state.points.held.clear();
    }
}

// Insertion stores the vertices of a record from the newest to the oldest, so that neighbours agree
// on the newest vertex of their facet. Filling a hole and closing gaps break that order, so records
// are sorted by vertex number here. Vertices that are inserted later have larger numbers.
void make_guards_agree(Mesh& mesh) noexcept {
    if (mesh.guards_agree) return;
    mesh.guards_agree = true;
    for (TetId t = 0; t < mesh.tetrahedra.size(); ++t) {
        Tetrahedron& record = mesh.tetrahedra[t];
        if (record.is_dead()) continue;
        const Tetrahedron before = record;
        unsigned position[4];
        if (!positions_by_number(before.v, position)) continue;
        for (unsigned i = 0; i < 4; ++i) {
            record.v[position[i]] = before.v[i];
            record.n[position[i]] = before.n[i];
            mesh.tetrahedra[tetrahedron_of(before.n[i])].n[face_of(before.n[i])] =
                facet_code(t, position[i]);
        }
        if (mesh.tetrahedra.has_spheres())
            mesh.tetrahedra.sphere(t) = rounded(circumsphere(record, mesh.vertices.data()));
    }
}

}  // namespace mgdt
