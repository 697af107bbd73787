// SPDX-License-Identifier: MIT
// Volumes of cells by passes over the tetrahedra, without building any cell. Each tetrahedron is
// divided into one part per vertex, whose points are nearest to that vertex. The volume of a part
// is a signed sum of pyramids over parts of facets, with the circumcentre as the apex
// (docs/theory.md, "Cells"). The volumes are summed as integers, so they do not depend on the order
// of the terms.
#pragma once

#include "parallel/atomic_array.hpp"
#include "platform/stage_progress.hpp"
#include "query/mesh_view.hpp"

namespace mgdt {

class VolumePass {
  public:
    VolumePass(const MeshView& view, StageProgress& progress);

    // Whether the cell of v is unbounded.
    bool is_infinite(VertexId v) { return flags(v) & on_hull; }
    // An upper bound on the distance of the cell's corners from the vertex.
    double radius(VertexId v);
    // Computes the volume, in the mesh's scale. Returns false if its error may exceed
    // measure_error.
    bool find(VertexId v, double& volume);

  private:
    // The volumes of the parts of a tetrahedron, with the vertices sorted by index.
    struct Parts {
        VertexId v[4];
        double volume[4];
        double error;  // an upper bound on the error of each volume
        double radius;
        bool is_known;
    };
    static Parts parts_of(const Mesh& mesh, const Tetrahedron& t);
    template <bool alone>
    void run(const MeshView& view, StageProgress& progress);
    template <bool alone>
    void set_exponents(const Mesh& mesh, std::size_t begin, std::size_t end);
    template <bool alone>
    void add(const Mesh& mesh, std::size_t begin, std::size_t end);

    static constexpr std::uint32_t on_hull = 1, is_lost = 2;
    std::uint32_t flags(VertexId v) { return flags_[v].load(std::memory_order_relaxed); }

    int exponent(VertexId v);

    AtomicArray<std::int32_t> exponents_;  // for each vertex the exponent of the square of the
                                           // longest edge, minus least_exponent
    AtomicArray<std::uint32_t> radii_;     // for each vertex the largest radius, as bits of a float
    AtomicArray<std::uint32_t> flags_, counts_;
    AtomicArray<std::int64_t> sums_, errors_;
};

}  // namespace mgdt
