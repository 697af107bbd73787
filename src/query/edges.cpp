// SPDX-License-Identifier: MIT
// Exports the edges, and the neighbours of each vertex.
#include <algorithm>
#include <cstdint>

#include "query/edge_lists.hpp"
#include "query/export.hpp"
#include "query/vertex_indices.hpp"

namespace mgdt {

// Edges are sorted by their ends: by the caller's indices in canonical exports, otherwise by vertex
// numbers.
template <class Int>
void export_edges(const MeshView& view, Int* out) {
    const VertexIndices indices(view.team, view.mesh, view.allocator);
    const auto name = [&](VertexId v) { return view.canonical ? indices[v] : v; };
    const std::size_t names = view.canonical ? indices.end() : view.mesh.vertices.size();
    const EdgeLists lists(view, names, edges_from_lesser(view.mesh, name));
    const Int base = static_cast<Int>(view.base);
    lists.write(
        [&](std::size_t k, std::size_t position, const std::uint32_t* others, std::size_t size) {
            Int* to = out + 2 * position;
            for (std::size_t i = 0; i < size; ++i) {
                std::uint32_t a = static_cast<std::uint32_t>(k), b = others[i];
                if (!view.canonical) {
                    const std::uint32_t index_a = indices[a], index_b = indices[b];
                    a = std::min(index_a, index_b);
                    b = std::max(index_a, index_b);
                }
                *to++ = static_cast<Int>(a) + base;
                *to++ = static_cast<Int>(b) + base;
            }
        });
}

template <class Int>
void export_vertex_neighbors(const MeshView& view, std::size_t points, Int* offsets, Int* list) {
    const VertexIndices indices(view.team, view.mesh, view.allocator);
    const auto name = [&](VertexId v) { return indices[v]; };
    const EdgeLists lists(view, points, [&](std::size_t begin, std::size_t end, auto f) {
        for_each_edge(view.mesh, begin, end, name, [&](std::uint32_t a, std::uint32_t b) {
            f(a, b);
            f(b, a);
        });
    });
    const Int base = static_cast<Int>(view.base);
    offsets[0] = base;
    lists.write(
        [&](std::size_t k, std::size_t position, const std::uint32_t* others, std::size_t size) {
            for (std::size_t i = 0; i < size; ++i)
                list[position + i] = static_cast<Int>(others[i]) + base;
            offsets[k + 1] = static_cast<Int>(position + size) + base;
        });
}

#define MGDT_INSTANTIATE(Int)                          \
    template void export_edges(const MeshView&, Int*); \
    template void export_vertex_neighbors(const MeshView&, std::size_t, Int*, Int*);
MGDT_INSTANTIATE(std::int64_t)
MGDT_INSTANTIATE(std::int32_t)
#undef MGDT_INSTANTIATE

}  // namespace mgdt
