// SPDX-License-Identifier: MIT
#include "refinement/walled_mesh.hpp"

#include <algorithm>
#include <utility>

#include "kernel/circumsphere.hpp"
#include "platform/error.hpp"
#include "predicates/normal_range.hpp"

namespace mgdt {
namespace {

constexpr std::size_t tetrahedra_per_thread = 4096;

}  // namespace

WalledMesh::WalledMesh(const LinkedMesh& from, Team& team, Allocator& allocator)
    : mesh(allocator),
      walls(allocator),
      sides(allocator),
      regions(allocator),
      edges(allocator),
      loose_edges(allocator) {
    mesh.clear();
    const std::size_t points = from.x.size() / 3;
    add_vertices(points);
    for (std::uint32_t v = 0; v < points; ++v) {
        set_vertex(v + 1, from.point(v));
        if (!in_normal_range(from.point(v))) mesh.has_extremes = true;
    }
    const std::size_t count = from.tetrahedra.size();
    std::size_t open = 0;
    for (const LinkedMesh::Tetrahedron& t : from.tetrahedra)
        for (const std::uint32_t behind : t.n) open += behind == no_index;
    add_slots(count + open);
    mesh.tetrahedra.resize_within_capacity(count);
    team.split(count, tetrahedra_per_thread, [&](std::size_t begin, std::size_t end, unsigned) {
        for (std::size_t t = begin; t < end; ++t) {
            const LinkedMesh::Tetrahedron& given = from.tetrahedra[t];
            Tetrahedron& made = mesh.tetrahedra[t];
            unsigned bits = 0;
            for (unsigned i = 0; i < 4; ++i) {
                made.v[i] = given.v[i] + 1;
                made.n[i] = given.n[i];
                sides[4 * t + i] = given.facets[i];
                if (given.facets[i] != no_index || given.n[i] == no_index) bits |= 1u << i;
            }
            walls[t] = static_cast<std::uint8_t>(bits);
            regions[t] = from.regions[t];
            mesh.tetrahedra.sphere(t) = rounded(circumsphere(made, mesh.vertices.data()));
        }
    });
    for (std::uint32_t t = 0; t < count; ++t)
        for (unsigned i = 0; i < 4; ++i)
            if (from.tetrahedra[t].n[i] == no_index) {
                const auto ghost = static_cast<TetId>(mesh.tetrahedra.size());
                mesh.tetrahedra.resize_within_capacity(std::size_t{ghost} + 1);
                make_ghost(ghost, t, i);
                ++mesh.ghost_count;
            }
    find_loose_edges(from);
}

void WalledMesh::add_vertices(std::size_t count) {
    const std::size_t all = mesh.vertices.size() + count;
    if (all > mesh.vertex_limit)
        fail(MGDT_ERR_TOO_LARGE, "more than %u points", static_cast<unsigned>(mesh.vertex_limit));
    mesh.vertices.grow(all);
    while (mesh.vertices.size() < all) mesh.vertices.push_back({{0, 0, 0}, no_index, 0});
}

void WalledMesh::add_slots(std::size_t count) {
    const std::size_t all = mesh.tetrahedra.size() + count;
    mesh.reserve_tetrahedra(all);
    walls.grow(all);
    sides.grow(4 * all);
    regions.grow(all);
    walls.resize(all);
    sides.resize(4 * all);
    regions.resize(all);
    mesh.tetrahedra.resize_within_capacity(all);
}

void WalledMesh::make_ghost(TetId ghost, TetId t, unsigned face) {
    Tetrahedron& behind = mesh.tetrahedra[t];
    const unsigned char* const f = outer_face[face];
    Tetrahedron& made = mesh.tetrahedra[ghost];
    // Nothing goes from one ghost to another one, so those faces are linked with themselves.
    made = {
        {behind.v[f[0]], behind.v[f[2]], behind.v[f[1]], infinite_vertex},
        {facet_code(ghost, 0), facet_code(ghost, 1), facet_code(ghost, 2), facet_code(t, face)}};
    behind.n[face] = facet_code(ghost, 3);
    mesh.tetrahedra.sphere(ghost) = rounded(circumsphere(made, mesh.vertices.data()));
    walls[ghost] = 0xF;
}

void WalledMesh::find_loose_edges(const LinkedMesh& from) {
    bool has_edges = false;
    from.edges.for_each([&](std::uint32_t a, std::uint32_t b, const KeptEdges::Origin& origin) {
        edges.add(a + 1, b + 1, origin);
        has_edges = true;
    });
    if (!has_edges) return;
    PairTable of_walls(walls.allocator());
    for (TetId t = 0; t < from.tetrahedra.size(); ++t)
        for (unsigned i = 0; i < 4; ++i) {
            if ((walls[t] >> i & 1) == 0) continue;
            const std::uint32_t(&v)[4] = from.tetrahedra[t].v;
            for (int k = 0; k < 3; ++k)
                of_walls.add(v[outer_face[i][k]], v[outer_face[i][(k + 1) % 3]]);
        }
    from.edges.for_each([&](std::uint32_t a, std::uint32_t b, const KeptEdges::Origin&) {
        if (of_walls.find(a, b) == no_index) loose_edges.add(a + 1, b + 1);
    });
}

void WalledMesh::divide_edge(VertexId a, VertexId b, VertexId q) {
    if (!edges.has(a, b)) return;
    const KeptEdges::Origin origin = edges.origin(a, b);
    edges.add(a, q, origin);
    edges.add(q, b, origin);
    edges.remove(a, b);
    has_divided_edges_ = true;
}

void WalledMesh::write(LinkedMesh& to) const {
    Allocator& allocator = walls.allocator();
    Buffer<std::uint32_t> number(allocator);
    number.resize(mesh.tetrahedra.size(), no_index);
    std::uint32_t count = 0;
    for (TetId t = 0; t < mesh.tetrahedra.size(); ++t)
        if (!mesh.tetrahedra[t].is_dead() && !mesh.tetrahedra[t].is_ghost()) number[t] = count++;
    // Vertices are numbered without gaps; those that were there keep their numbers.
    Buffer<std::uint32_t> vertex(allocator);
    vertex.resize(mesh.vertices.size(), no_index);
    std::uint32_t points = 0;
    for (VertexId v = 1; v < vertex.size(); ++v)
        if (is_used(mesh.vertices[v])) vertex[v] = points++;
    to.x.resize(3 * std::size_t{points});
    to.is_lost.resize(points, 0);
    to.hints.resize(points, no_tetrahedron);
    to.tetrahedra.resize(count);
    to.regions.resize(count);
    for (VertexId v = 1; v < vertex.size(); ++v)
        if (vertex[v] != no_index)
            std::copy_n(mesh.vertices[v].x, 3, to.x.begin() + 3 * std::size_t{vertex[v]});
    if (has_divided_edges_) {
        KeptEdges divided(allocator);
        edges.for_each([&](VertexId a, VertexId b, const KeptEdges::Origin& origin) {
            divided.add(vertex[a], vertex[b], origin);
        });
        to.edges = std::move(divided);
    }
    for (TetId t = 0; t < mesh.tetrahedra.size(); ++t) {
        const std::uint32_t into = number[t];
        if (into == no_index) continue;
        const Tetrahedron& from = mesh.tetrahedra[t];
        LinkedMesh::Tetrahedron& made = to.tetrahedra[into];
        for (unsigned i = 0; i < 4; ++i) {
            made.v[i] = vertex[from.v[i]];
            to.hints[made.v[i]] = into;
            const std::uint32_t behind = number[tetrahedron_of(from.n[i])];
            made.n[i] = behind == no_index ? no_index : 4 * behind + face_of(from.n[i]);
            made.facets[i] = is_wall(facet_code(t, i)) ? sides[4 * std::size_t{t} + i] : no_index;
        }
        to.regions[into] = regions[t];
    }
}

}  // namespace mgdt
