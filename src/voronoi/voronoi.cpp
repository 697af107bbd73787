// SPDX-License-Identifier: MIT
#include "voronoi/voronoi.hpp"

#include <functional>

#include "mesh/scale.hpp"
#include "voronoi/assembly.hpp"
#include "voronoi/cut_faces.hpp"
#include "voronoi/whole_faces.hpp"

namespace mgdt {

void build_voronoi(const ExportView& view, const Region& region, std::size_t points,
                   std::size_t far, const StopRequest& stop, VoronoiDiagram& diagram,
                   VoronoiSources* sources) {
    stop.poll();
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
    find_tetrahedra(view, first);
    Circumcenters centers(view, indices);
    AtomicArray<std::uint8_t> is_cut(view.allocator, mesh.vertices.size());
    CutCorners corners(view, indices, region, centers, vertex_of);
    PerMember<FoundFaces> found(view.team, view.allocator, std::ref(view.allocator));
    if (region.is_bounded()) {
        CutFaces cut(view, indices, region, centers, is_cut, corners, first, points, stop);
        cut.mark();
        cut.find(found);
    }
    WholeFaces(view, indices, centers, is_cut, stop).find(found);
    Assembly assembly(view, vertex_of, region, centers, corners, found, diagram, sources);
    assembly.sort_faces();
    stop.poll();
    assembly.number_corners();
    stop.poll();
    assembly.find_bounded_cells();
    assembly.list_cells();
    assembly.measure_cells(first, indices, points, stop);
    // The cells of far vertices are the last, and have no faces.
    diagram.points.resize(3 * points);
    diagram.cell_begin.resize(points + 1);
    diagram.is_bounded.resize(points);
    diagram.volumes.resize(points);
    diagram.cell_centroids.resize(3 * points);
}

}  // namespace mgdt
