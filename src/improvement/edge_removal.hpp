// SPDX-License-Identifier: MIT
// Removes an edge: the tetrahedra around it are replaced by others between the vertices around it.
#pragma once

#include "improvement/flexible_mesh.hpp"

namespace mgdt {

class EdgeRemoval {
  public:
    // `slides` allows the removal of edges inside of plane facets.
    EdgeRemoval(const FlexibleMesh& mesh, bool slides) : mesh_(mesh), slides_(slides) {}

    // Finds the best tetrahedra without the edge between corners i and j of tetrahedron t. Returns
    // whether there are some that are all better than the worst one around the edge.
    bool find(std::uint32_t t, unsigned i, unsigned j, Change& change);

  private:
    // Around more tetrahedra, better ones are rarely found, and the search takes the third power of
    // their number.
    static constexpr unsigned most_around = 10;

    bool collect(std::uint32_t t, unsigned i, unsigned j);
    unsigned find_facet(unsigned (&at)[2]) const;
    void turn(unsigned by);
    double choose(unsigned begin, unsigned end);
    void write(unsigned begin, unsigned end, std::uint32_t region, Change& change) const;
    void write_faces(unsigned middle, Change& change) const;

    const FlexibleMesh& mesh_;
    const bool slides_;
    std::uint32_t a_ = 0, b_ = 0;  // the ends of the edge
    // Tetrahedron k has the corners a, b and vertices k and k + 1, and is positive in this order.
    // Inside of the mesh the last vertex is the first one again.
    std::uint32_t tetrahedra_[most_around], vertices_[most_around + 1];
    FlexibleMesh::Side sides_[most_around + 1];  // of the face with vertex k: from tetrahedron k,
                                                 // the last one from the last tetrahedron
    unsigned count_ = 0;
    bool is_closed_ = false;
    double worst_ = 0;
    // best_[i][j] belongs to the polygon of vertices i to j, which is divided into triangles. Each
    // triangle is the face of two new tetrahedra. Of all divisions, the best one has the largest
    // worst quality, which is best_[i][j]. Its triangle with vertices i and j has apex_[i][j] as
    // the third vertex.
    double best_[most_around + 1][most_around + 1];
    unsigned char apex_[most_around + 1][most_around + 1];
};

}  // namespace mgdt
