// SPDX-License-Identifier: MIT
#include "dual/cell_measurer.hpp"

#include "dual/exact_measures.hpp"
#include "parallel/watched_split.hpp"

namespace mgdt {

void CellMeasurer::measure(const Mesh& mesh, VertexId v, TetId first, const Region& region,
                           Measure measure, double* out) {
    link_.gather(mesh, v, first);
    for (const Centers centers : {Centers::plain, Centers::corrected}) {
        if (in_doubles_.measure(mesh, v, link_, region, measure, centers, out)) return;
        if (measure == Measure::faces) break;
    }
    faces_.find(mesh, v, link_, in_doubles_.cell(), region);
    if (measure == Measure::faces)
        *out = static_cast<double>(faces_.size());
    else
        ExactMeasures::measure(faces_, mesh.point(v), mesh.scale, measure, out);
}

void find_tetrahedra(const MeshView& view, AtomicArray<TetId>& first, StageProgress& progress) {
    const Mesh& mesh = view.mesh;
    constexpr std::size_t min_slots_per_thread = 262144;
    watched_split(view.team, progress, mesh.tetrahedra.size(), min_slots_per_thread,
                  [&](std::size_t begin, std::size_t end) {
                      for (std::size_t id = begin; id < end; ++id) {
                          const Tetrahedron& t = mesh.tetrahedra[id];
                          if (t.is_dead()) continue;
                          for (const VertexId v : t.v)
                              first[v].store(static_cast<TetId>(id), std::memory_order_relaxed);
                      }
                  });
}

}  // namespace mgdt
