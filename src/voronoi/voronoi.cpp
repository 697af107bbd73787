// SPDX-License-Identifier: MIT
#include "voronoi/voronoi.hpp"

#include <functional>

#include "mesh/scale.hpp"
#include "voronoi/assembly.hpp"
#include "voronoi/cut_faces.hpp"
#include "voronoi/whole_faces.hpp"

namespace mgdt {

void build_voronoi(const MeshView& view, const Region& region, std::size_t points, std::size_t far,
                   StageProgress& progress, VoronoiDiagram& diagram, VoronoiSources* sources) {
    progress.enter(0, 0.05);
    const Mesh& mesh = view.mesh;
    const VertexIndices indices(view.team, mesh, view.allocator);
    Buffer<VertexId> vertex_of(view.allocator);
    vertex_of.resize(points + far, infinite_vertex);
    diagram.points.resize(3 * (points + far), 0.0);
    for (VertexId v = 1; v < mesh.vertices.size(); ++v) {
        const std::size_t index = indices[v];
        vertex_of[index] = v;
        for (std::size_t k = 0; k < 3; ++k)
            diagram.points[3 * index + k] = scaled(mesh.point(v)[k], -mesh.scale);
    }
    AtomicArray<TetId> first(view.allocator, mesh.vertices.size());
    find_tetrahedra(view, first, progress);
    StageProgress of_centers = progress.within(0.05, 0.25);
    Circumcenters centers(view, indices, of_centers);
    AtomicArray<std::uint8_t> is_cut(view.allocator, mesh.vertices.size());
    CutCorners corners(view, indices, region, centers, vertex_of);
    PerMember<FoundFaces> found(view.team, view.allocator, std::ref(view.allocator));
    if (region.is_bounded()) {
        progress.enter(0.25, 0.4);
        CutFaces cut(view, indices, region, centers, is_cut, corners, first, points, progress);
        cut.mark();
        cut.find(found);
    }
    progress.enter(0.4, 0.65);
    WholeFaces(view, indices, centers, is_cut, progress).find(found);
    progress.enter(0.65, 0.75);
    Assembly assembly(view, vertex_of, region, centers, corners, found, diagram, sources);
    assembly.sort_faces();
    progress.enter(0.75, 0.85);
    assembly.number_corners();
    progress.enter(0.85, 1);
    assembly.find_bounded_cells();
    assembly.list_cells();
    assembly.measure_cells(first, indices, points, progress);
    // The cells of far vertices are the last, and have no faces.
    diagram.points.resize(3 * points);
    diagram.cell_begin.resize(points + 1);
    diagram.is_bounded.resize(points);
    diagram.volumes.resize(points);
    diagram.cell_centroids.resize(3 * points);
}

}  // namespace mgdt
