// SPDX-License-Identifier: MIT
#include "dual/measures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dual/exact_measures.hpp"
#include "dual/volume_pass.hpp"
#include "parallel/atomic_array.hpp"

namespace mgdt {
namespace {

// Finds a tetrahedron for each vertex. Which one it is may depend on the threads.
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

constexpr std::size_t min_vertices_per_thread = 4096;

// Measures single cells: in doubles if doubles are accurate enough, otherwise from the exact faces.
class Measurer {
  public:
    explicit Measurer(Allocator& allocator)
        : link_(allocator), in_doubles_(allocator), faces_(allocator) {}

    void measure(const Mesh& mesh, VertexId v, TetId first, const Region& region, Measure measure,
                 double* out) {
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

  private:
    Link link_;
    CellMeasures in_doubles_;
    CellFaces faces_;
};

// Writes the volumes that the passes over the tetrahedra give. Measures a cell on its own if the
// region may cut the cell, or if the passes leave its volume undecided.
void export_volumes(const ExportView& view, const Region& region, AtomicArray<TetId>& first,
                    double* x) {
    const Mesh& mesh = view.mesh;
    VolumePass pass(view);
    view.team.split(
        mesh.vertices.size() - 1, min_vertices_per_thread,
        [&](std::size_t begin, std::size_t end, unsigned) {
            Measurer measurer(view.allocator);
            for (std::size_t i = begin; i < end; ++i) {
                const auto v = static_cast<VertexId>(i + 1);
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

void export_measures(const ExportView& view, const Region& region, Measure measure,
                     std::size_t points, double* x) {
    const Mesh& mesh = view.mesh;
    const std::size_t width = measure == Measure::centroid ? 3 : 1;
    std::fill_n(x, width * points, 0.0);
    AtomicArray<TetId> first(view.allocator, mesh.vertices.size());
    find_tetrahedra(view, first);
    if (measure == Measure::volume) return export_volumes(view, region, first, x);
    view.team.split(mesh.vertices.size() - 1, min_vertices_per_thread,
                    [&](std::size_t begin, std::size_t end, unsigned) {
                        Measurer measurer(view.allocator);
                        for (std::size_t i = begin; i < end; ++i) {
                            const auto v = static_cast<VertexId>(i + 1);
                            measurer.measure(mesh, v, first[v].load(std::memory_order_relaxed),
                                             region, measure, x + width * mesh.vertices[v].index);
                        }
                    });
}

}  // namespace mgdt
