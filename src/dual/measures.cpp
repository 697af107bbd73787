// SPDX-License-Identifier: MIT
#include "dual/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dual/cell_measurer.hpp"
#include "dual/volume_pass.hpp"
#include "parallel/atomic_array.hpp"

namespace mgdt {
namespace {

constexpr std::size_t min_vertices_per_thread = 4096;

// Writes the volumes that the passes over the tetrahedra give. Measures a cell on its own if the
// region may cut the cell, or if the passes leave its volume undecided.
void export_volumes(const MeshView& view, const Region& region, std::size_t points,
                    AtomicArray<TetId>& first, StageProgress& progress, double* x) {
    const Mesh& mesh = view.mesh;
    StageProgress of_pass = progress.within(0.1, 0.7);
    VolumePass pass(view, of_pass);
    progress.enter(0.7, 1);
    view.team.split(
        mesh.vertices.size() - 1, min_vertices_per_thread,
        [&](std::size_t begin, std::size_t end, unsigned member) {
            CellMeasurer measurer(view.allocator);
            for (std::size_t i = begin; i < end; ++i) {
                progress.step(i, begin, end, member);
                const auto v = static_cast<VertexId>(i + 1);
                if (mesh.vertices[v].index >= points) continue;
                double& out = x[mesh.vertices[v].index];
                double volume;
                const bool may_be_cut =
                    region.is_bounded() &&
                    (pass.is_infinite(v) || !(region.clearance(mesh.point(v)) > pass.radius(v)));
                if (!region.is_bounded() && pass.is_infinite(v))
                    out = std::numeric_limits<double>::infinity();
                else if (!may_be_cut && pass.find(v, volume))
                    out = std::ldexp(volume, -3 * mesh.scale);
                else
                    measurer.measure(mesh, v, first[v].load(std::memory_order_relaxed), region,
                                     Measure::volume, &out);
            }
        });
}

}  // namespace

void export_measures(const MeshView& view, const Region& region, Measure measure,
                     std::size_t points, StageProgress& progress, double* x) {
    const Mesh& mesh = view.mesh;
    const std::size_t width = width_of(measure);
    std::fill_n(x, width * points, 0.0);
    AtomicArray<TetId> first(view.allocator, mesh.vertices.size());
    progress.enter(0, 0.1);
    find_tetrahedra(view, first, progress);
    if (measure == Measure::volume) {
        export_volumes(view, region, points, first, progress, x);
        return;
    }
    progress.enter(0.1, 1);
    view.team.split(mesh.vertices.size() - 1, min_vertices_per_thread,
                    [&](std::size_t begin, std::size_t end, unsigned member) {
                        CellMeasurer measurer(view.allocator);
                        for (std::size_t i = begin; i < end; ++i) {
                            progress.step(i, begin, end, member);
                            const auto v = static_cast<VertexId>(i + 1);
                            if (mesh.vertices[v].index >= points) continue;
                            measurer.measure(mesh, v, first[v].load(std::memory_order_relaxed),
                                             region, measure, x + width * mesh.vertices[v].index);
                        }
                    });
}

}  // namespace mgdt
