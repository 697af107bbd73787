// SPDX-License-Identifier: MIT
#include "dual/measures.hpp"

#include <algorithm>

#include "parallel/atomic_array.hpp"

namespace mgdt {
namespace {

// A tetrahedron of each vertex. Which one it is may depend on the threads.
void find_tetrahedra(const ExportView& view, AtomicArray<TetId>& first) {
    const Mesh& mesh = view.mesh;
    constexpr std::size_t min_slots_per_thread = 262144;
    view.team.split(mesh.tetrahedra.size(), min_slots_per_thread,
                    [&](std::size_t begin, std::size_t end, unsigned) {
                        for (std::size_t id = begin; id < end; ++id) {
                            const Tetrahedron& t = mesh.tetrahedra[id];
                            if (t.is_dead()) continue;
                            for (const VertexId v : t.v)
                                first[v].store(static_cast<TetId>(id), std::memory_order_relaxed);
                        }
                    });
}

}  // namespace

void export_measures(const ExportView& view, const Region& region, Measure measure,
                     std::size_t points, double* x) {
    const Mesh& mesh = view.mesh;
    const std::size_t width = measure == Measure::centroid ? 3 : 1;
    std::fill_n(x, width * points, 0.0);
    AtomicArray<TetId> first(view.allocator, mesh.vertices.size());
    find_tetrahedra(view, first);
    constexpr std::size_t min_vertices_per_thread = 4096;
    view.team.split(
        mesh.vertices.size() - 1, min_vertices_per_thread,
        [&](std::size_t begin, std::size_t end, unsigned) {
            Link link(view.allocator);
            CellMeasures<double> measures(view.allocator);
            CellMeasures<Twofold> again(view.allocator);
            for (std::size_t i = begin; i < end; ++i) {
                const VertexId v = static_cast<VertexId>(i + 1);
                double* const out = x + width * mesh.vertices[v].index;
                link.gather(mesh, v, first[v].load(std::memory_order_relaxed));
                if (measures.measure(mesh, v, link, region, measure, Centers::plain, out)) continue;
                if (measures.measure(mesh, v, link, region, measure, Centers::corrected, out))
                    continue;
                again.measure(mesh, v, link, region, measure, Centers::plain, out);
            }
        });
}

}  // namespace mgdt
