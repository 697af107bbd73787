// SPDX-License-Identifier: MIT
// A mesh as refinement changes it: in the records of the kernel, with walls.
#pragma once

#include "mesh/mesh.hpp"
#include "solid/kept_edges.hpp"
#include "solid/linked_mesh.hpp"
#include "solid/pair_table.hpp"

namespace mgdt {

// A face that is a part of a facet is a wall: no cavity grows through it. Where the mesh ends, a
// ghost is the neighbour behind the face. No cavity reaches a ghost, and ghosts have no links with
// each other. Point v of the linked mesh is vertex v + 1, since vertex 0 is the one at infinity.
class WalledMesh {
  public:
    WalledMesh(const LinkedMesh& from, Team& team, Allocator& allocator);

    // Writes the vertices and tetrahedra to the linked mesh that this one was made from.
    void write(LinkedMesh& to) const;

    const double* point(VertexId v) const noexcept { return mesh.point(v); }
    bool is_wall(FacetCode code) const noexcept {
        return (walls[tetrahedron_of(code)] >> face_of(code) & 1) != 0;
    }
    // Adds vertices that have no tetrahedra yet and are at the origin.
    void add_vertices(std::size_t count);
    // Sets the place of such a vertex, whose coordinates are in the normal range.
    void set_vertex(VertexId v, const double* x) noexcept {
        for (int k = 0; k < 3; ++k) mesh.vertices[v].x[k] = x[k];
        mesh.vertices[v].index = v - 1;
    }
    // Whether the place of a vertex has been set.
    static bool is_used(const Vertex& vertex) noexcept { return vertex.index != no_index; }
    // Makes room for `count` more tetrahedra.
    void add_slots(std::size_t count);
    // Makes the ghost behind a face of a tetrahedron, in a free slot.
    void make_ghost(TetId ghost, TetId t, unsigned face);
    // Divides an edge that the mesh keeps, if it is one.
    void divide_edge(VertexId a, VertexId b, VertexId q);

    Mesh mesh;

    // For each slot: bit i says whether face i is a wall, and sides[4 * slot + i] names its facet
    // then, as LinkedMesh::Side does. The region is that of a finite tetrahedron.
    Buffer<std::uint8_t> walls;
    Buffer<LinkedMesh::Side> sides;
    Buffer<std::uint32_t> regions;

    KeptEdges edges;  // that the mesh keeps
    // Those of them that no wall has.
    PairTable loose_edges;

  private:
    void find_loose_edges(const LinkedMesh& from);

    bool has_divided_edges_ = false;
};

}  // namespace mgdt
