// SPDX-License-Identifier: MIT
// Divides a mesh into zones in which threads refine it.
#pragma once

#include "order/curve_sort.hpp"
#include "refinement/refined_mesh.hpp"

namespace mgdt {

// A zone has the tetrahedra between its vertices, which are a part of a curve through all vertices.
// Tetrahedra between zones are closed while threads work.
class ZoneDivision {
  public:
    explicit ZoneDivision(Allocator& allocator)
        : zones(allocator),
          tetrahedra(allocator),
          zone_of_(allocator),
          closed_(allocator),
          of_bad_(allocator) {}

    // Divides the mesh into `count` zones. Different shifts, from 0 to 1, have different borders.
    void divide(const RefinedMesh& mesh, std::size_t count, double shift, Team& team);
    // Closes the tetrahedra between zones, and opens them again.
    void close(Mesh& mesh) const noexcept;
    void open(Mesh& mesh) const noexcept;

    struct Zone {
        std::size_t begin, end;  // of its bad tetrahedra in the list
        std::size_t vertices, tetrahedra;
        double wanted;  // roughly, how many points its bad tetrahedra need
    };
    Buffer<Zone> zones;
    Buffer<TetId> tetrahedra;  // the bad ones in zones
    // Those between zones: their number, and how many points they need.
    std::size_t bad_between = 0;
    double wanted_between = 0, wanted_inside = 0;

  private:
    void sort_vertices(const RefinedMesh& mesh, std::size_t count, double shift, Team& team);

    Buffer<std::uint32_t> zone_of_;  // of each vertex
    Buffer<TetId> closed_;
    struct Bad {
        TetId tetrahedron;
        std::uint32_t zone;
    };
    Buffer<Bad> of_bad_;
};

}  // namespace mgdt
