// SPDX-License-Identifier: MIT
// Points get the numbers of vertices before they are inserted. Repeats, and points that are not in
// since a call was given up, leave gaps, which are closed at its end.
#include <new>

#include "core/triangulation.hpp"
#include "mesh/star_traversal.hpp"
#include "query/locate.hpp"

namespace mgdt {
namespace {

constexpr std::size_t items_of_a_part = 65536;
// Tetrahedra that a turn through all of them passes while one vertex is looked for.
constexpr std::size_t passed = 2048;

// Gives a vertex another number in all its tetrahedra, of which one is given; star is for lists.
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

// Gives vertices from `end` on that have tetrahedra the numbers in their records.
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

// The same by a turn through all tetrahedra.
void renumber_all(Team& team, Mesh& mesh, std::size_t end) {
    team.split(mesh.tetrahedra.size(), items_of_a_part,
               [&](std::size_t from, std::size_t to, unsigned) {
                   for (std::size_t t = from; t < to; ++t)
                       if (!mesh.tetrahedra[t].is_dead())
                           for (VertexId& v : mesh.tetrahedra[t].v) renumber(mesh, end, v);
               });
}

}  // namespace

// A gap is a vertex from `begin` on with no tetrahedron near. The last vertices move there. Points
// from `first_point` on may map to these.
void Triangulation::compact_vertices(Team& team, std::size_t begin,
                                     std::size_t first_point) noexcept {
    Buffer<TetId>& hints = mesh_.vertex_hint;
    const auto forget = [&](std::size_t v) {
        VertexId& of_point = point_map_[mesh_.vertices[v].index];
        if (of_point == v) of_point = infinite_vertex;
    };
    std::size_t end = mesh_.vertices.size(), moved = 0;
    for (std::size_t v = begin; v < end; ++v) {
        if (hints[v] != no_tetrahedron) continue;
        forget(v);
        while (end > v + 1 && hints[end - 1] == no_tetrahedron) forget(--end);
        if (--end == v) break;
        // Where a vertex goes lies in its old record.
        mesh_.vertices[v] = mesh_.vertices[end];
        hints[v] = hints[end];
        mesh_.vertices[end].moved_to = static_cast<VertexId>(v);
        ++moved;
    }
    if (moved > 0) {
        renumber_moved(team, end, moved);
        renumber_points(team, end, first_point);
    }
    mesh_.vertices.resize_within_capacity(end);
    hints.resize_within_capacity(end);
}

// Vertices from `end` on, of which `moved` have tetrahedra, get the numbers in their records in
// these.
void Triangulation::renumber_moved(Team& team, std::size_t end, std::size_t moved) noexcept {
    if (mesh_.live_count() == 0) return;
    bool is_done = moved <= mesh_.tetrahedra.size() / passed;
    try {
        if (is_done) renumber_stars(mesh_, calls(), end);
    } catch (const std::bad_alloc&) {
        is_done = false;
    }
    if (!is_done) renumber_all(team, mesh_, end);
}

// The same for points from `first_point` on in the map.
void Triangulation::renumber_points(Team& team, std::size_t end, std::size_t first_point) noexcept {
    VertexId* const of_points = point_map_.data() + first_point;
    team.split(point_map_.size() - first_point, items_of_a_part,
               [&](std::size_t from, std::size_t to, unsigned) {
                   for (std::size_t i = from; i < to; ++i) renumber(mesh_, end, of_points[i]);
               });
}

}  // namespace mgdt
