// SPDX-License-Identifier: MIT
// Volumes of cells by passes over the tetrahedra, with no cell ever built: each tetrahedron is cut
// into the parts that are nearest to its vertices, pyramids over parts of its facets whose apex is
// the circumcentre, with a sign (docs/theory.md, "Cells"). Sums of integers do not depend on an
// order.
#pragma once

#include "parallel/atomic_array.hpp"
#include "query/export.hpp"

namespace mgdt {

class VolumePass {
  public:
    explicit VolumePass(const ExportView& view);

    // Whether the cell of v has no end.
    bool is_infinite(VertexId v) { return flags(v) & on_hull; }
    // Bounds the distance of the cell's corners from the vertex.
    double radius(VertexId v);
    // Whether the volume, of coordinates as the mesh has them, is known to measure_error.
    bool find(VertexId v, double& volume);

  private:
    // Of a tetrahedron whose vertices are sorted by index.
    struct Parts {
        VertexId v[4];
        double volume[4];
        double error;  // of each
        double radius;
        bool is_known;
    };
    static Parts parts_of(const Mesh& mesh, const Tetrahedron& t);
    template <bool alone>
    void run(const ExportView& view);
    template <bool alone>
    void set_exponents(const Mesh& mesh, std::size_t begin, std::size_t end);
    template <bool alone>
    void add(const Mesh& mesh, std::size_t begin, std::size_t end);

    static constexpr std::uint32_t on_hull = 1, is_lost = 2;
    std::uint32_t flags(VertexId v) { return flags_[v].load(std::memory_order_relaxed); }

    int exponent(VertexId v);

    AtomicArray<std::int32_t> exponents_;  // of the square of the longest edge, less the least one
    AtomicArray<std::uint32_t> radii_;     // bits of floats
    AtomicArray<std::uint32_t> flags_, counts_;
    AtomicArray<std::int64_t> sums_, errors_;
};

}  // namespace mgdt
