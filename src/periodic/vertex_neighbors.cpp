// SPDX-License-Identifier: MIT
#include "periodic/vertex_neighbors.hpp"

#include <algorithm>

#include "query/edge_lists.hpp"

namespace mgdt {

// The star of a point of the box is complete in the triangulation of the points and their halo.
VertexNeighbors::VertexNeighbors(Allocator& allocator, const Halo& halo)
    : begin(allocator), images(allocator) {
    const std::size_t points = halo.own_count();
    begin.resize(points + 1, std::uint64_t{0});
    if (points == 0 || halo.triangulation().dimension() < 3) return;
    constexpr std::size_t slots_per_thread = 65536, vertices_per_thread = 16384;
    const Mesh& mesh = halo.triangulation().mesh();
    const std::size_t vertices = mesh.vertices.size();
    Team team(halo.triangulation().threads_for(mesh.tetrahedra.size(), slots_per_thread));
    // The lists are made by vertex first, because vertices with near numbers are near each other in
    // memory.
    Buffer<std::uint64_t> ends(allocator), found(allocator);
    ends.resize(vertices + 1);
    const auto index = [&](std::size_t v) { return mesh.vertices[static_cast<VertexId>(v)].index; };
    make_lists(
        team, allocator, mesh.tetrahedra.size(), slots_per_thread, vertices, ends.data(),
        [&](std::size_t from, std::size_t to, auto f) {
            for_each_edge(
                mesh, from, to, [](VertexId v) { return v; },
                [&](VertexId a, VertexId b) {
                    const std::uint32_t of_a = index(a), of_b = index(b);
                    if (halo.is_own(of_a)) f(a, of_b);
                    if (halo.is_own(of_b)) f(b, of_a);
                });
        },
        [&](std::size_t size) {
            found.resize(size);
            found.prefault(0, size);
        },
        [&](std::size_t position, std::uint32_t other) {
            found[position] = order_of(halo.image(other));
        });
    // Removes repeats. Few edges are found twice.
    team.split(vertices, vertices_per_thread, [&](std::size_t from, std::size_t to, unsigned) {
        for (std::size_t v = from; v < to; ++v) {
            if (ends[v] == ends[v + 1]) continue;
            std::uint64_t* const first = found.begin() + ends[v];
            std::uint64_t* const last = found.begin() + ends[v + 1];
            std::sort(first, last);
            begin[index(v) + std::size_t{1}] =
                static_cast<std::uint64_t>(std::unique(first, last) - first);
        }
    });
    for (std::size_t p = 0; p < points; ++p) begin[p + 1] += begin[p];
    images.resize(static_cast<std::size_t>(begin[points]));
    images.prefault(0, images.size());
    team.split(vertices, vertices_per_thread, [&](std::size_t from, std::size_t to, unsigned) {
        for (std::size_t v = from; v < to; ++v) {
            if (ends[v] == ends[v + 1]) continue;
            const std::uint32_t p = index(v);
            const std::uint64_t* const first = found.begin() + ends[v];
            std::transform(first, first + (begin[p + std::size_t{1}] - begin[p]),
                           images.begin() + begin[p], image_of_order);
        }
    });
}

}  // namespace mgdt
