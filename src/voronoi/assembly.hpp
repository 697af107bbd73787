// SPDX-License-Identifier: MIT
// Makes the diagram from the faces that were found: sorts the faces by their sides, numbers
// vertices and rays in the order of the faces, and lists the faces of each cell.
#pragma once

#include "dual/region.hpp"
#include "parallel/atomic_array.hpp"
#include "platform/objects.hpp"
#include "platform/stage_progress.hpp"
#include "voronoi/circumcenters.hpp"
#include "voronoi/cut_corners.hpp"
#include "voronoi/found_faces.hpp"
#include "voronoi/voronoi.hpp"

namespace mgdt {

class Assembly {
  public:
    // vertex_of is the vertex of each of the caller's points, or infinite_vertex.
    Assembly(const MeshView& view, const Buffer<VertexId>& vertex_of, const Region& region,
             const Circumcenters& centers, CutCorners& cut, const Objects<FoundFaces>& found,
             VoronoiDiagram& diagram, VoronoiSources* sources);

    // The steps, in this order.
    void sort_faces();
    void number_corners();
    void find_bounded_cells();
    void list_cells();
    // Computes volumes and centroids of the cells of points with indices below `measured`. `first`
    // has a tetrahedron of each vertex.
    void measure_cells(AtomicArray<TetId>& first, const VertexIndices& indices,
                       std::size_t measured, StageProgress& progress);

  private:
    // The faces of the member that an item belongs to. `item` becomes its position among them.
    const FoundFaces& member_of(std::size_t& item) const noexcept;
    void prefetch_face(std::size_t item) const noexcept;
    void prefetch_corners(std::size_t item) const noexcept;
    void prefetch_faces(std::size_t cell) const noexcept;
    void copy_faces();
    void write_circumcenter(TetId t, double* out) const;
    void set_vertices(const Buffer<std::uint32_t>& corner_of);
    std::uint32_t add_ray(TetId slot, std::uint32_t vertex);
    bool measure_cell(std::size_t cell, double& volume, double* centroid) const;

    const MeshView& view_;
    const Mesh& mesh_;
    const Buffer<VertexId>& vertex_of_;
    const Region& region_;
    const Circumcenters& centers_;
    CutCorners& cut_;
    const Objects<FoundFaces>& found_;
    VoronoiDiagram& diagram_;
    VoronoiSources* const sources_;  // or NULL
    Buffer<std::size_t> ends_;       // the end of each member's faces, as items
    Buffer<std::uint32_t> order_;    // for each face its item
};

}  // namespace mgdt
