// SPDX-License-Identifier: MIT
// A walk through a mesh along a facet. It finds the faces that are parts of the facet, and the
// tetrahedra that the facet crosses.
#pragma once

#include "domain/constrained_mesh.hpp"
#include "solid/pair_table.hpp"

namespace mgdt {

class FacetWalk {
  public:
    // `subsegments` contains the ends of all subsegments.
    FacetWalk(ConstrainedMesh& mesh, const PairTable& subsegments, Allocator& allocator)
        : mesh_(mesh),
          subsegments_(subsegments),
          faces_(allocator),
          crossed_(allocator),
          signs_(allocator),
          stamps_(allocator),
          face_stamps_(allocator) {}

    // Walks along a facet. The facet is in the plane of the three points `corner`. The walk begins
    // at the subsegment from a to b, on the side of corner[2].
    void run(const std::uint32_t (&corner)[3], std::uint32_t a, std::uint32_t b);

    // Faces of the mesh that are parts of the facet, each on one of its sides.
    const Buffer<std::uint32_t>& faces() const noexcept { return faces_; }
    // The tetrahedra whose insides the facet meets.
    const Buffer<std::uint32_t>& crossed() const noexcept { return crossed_; }
    // The side of the plane on which a point is: the orientation of the three corners and the
    // point.
    int side(std::uint32_t v);
    // Whether a face of a tetrahedron has corners strictly on both sides of the plane.
    bool crosses(const ConstrainedMesh::Tetrahedron& t, unsigned face);

  private:
    void begin(std::uint32_t a, std::uint32_t b, std::uint32_t towards);
    void leave_tetrahedron(std::uint32_t t);
    void leave_face(std::uint32_t face);
    void enter_tetrahedron(std::uint32_t t);
    void enter_face(std::uint32_t face);
    bool turn(std::uint32_t face, std::uint32_t a, std::uint32_t b);

    ConstrainedMesh& mesh_;
    const PairTable& subsegments_;
    const double* plane_[3] = {};
    Buffer<std::uint32_t> faces_, crossed_;
    struct Sign {
        std::uint32_t walk;
        int side;
    };
    Buffer<Sign> signs_;                          // the sides that were computed, by point
    Buffer<std::uint32_t> stamps_, face_stamps_;  // by tetrahedron and by face: the last walk there
    std::uint32_t walk_ = 0;
};

}  // namespace mgdt
