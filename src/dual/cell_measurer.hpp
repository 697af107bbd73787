// SPDX-License-Identifier: MIT
// Measures single cells: in doubles if doubles are accurate enough, otherwise from the exact faces.
#pragma once

#include "dual/cell_faces.hpp"
#include "dual/cell_measures.hpp"
#include "parallel/atomic_array.hpp"
#include "platform/stage_progress.hpp"
#include "query/mesh_view.hpp"

namespace mgdt {

class CellMeasurer {
  public:
    explicit CellMeasurer(Allocator& allocator)
        : link_(allocator), in_doubles_(allocator), faces_(allocator) {}

    // Measures the cell of vertex v, which is a vertex of the tetrahedron `first`. Writes one
    // double, or three for a centroid.
    void measure(const Mesh& mesh, VertexId v, TetId first, const Region& region, Measure measure,
                 double* out);

  private:
    Link link_;
    CellMeasures in_doubles_;
    CellFaces faces_;
};

// Finds a tetrahedron for each vertex. Which one it is may depend on the threads.
void find_tetrahedra(const MeshView& view, AtomicArray<TetId>& first, StageProgress& progress);

}  // namespace mgdt
