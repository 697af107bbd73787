// SPDX-License-Identifier: MIT
// The places of a mesh's boundary that are nearest to places outside of it.
#pragma once

#include "boundary/box_tree.hpp"
#include "solid/solid_mesh.hpp"

namespace mgdt {

class BoundaryPlaces {
  public:
    BoundaryPlaces(Allocator& allocator, const SolidMesh& mesh, const StopRequest& stop);

    struct Place {
        std::uint32_t tetrahedron;  // no_index if the mesh has none
        double weights[4];          // barycentric coordinates; that of the opposite corner is 0
    };
    // The nearest place, but for rounding. Of several ones whose distances are equal in doubles it
    // is that of the first face, in the order of tetrahedra and their corners.
    Place nearest(const double* place) const;

  private:
    class Distance;
    struct Candidate {
        double distance;
        double weights[3];  // of the corners of the face
    };
    const double* corner(std::uint32_t face, unsigned k) const;
    void consider(const double* const (&p)[3], const Distance& distance, const double (&w)[3],
                  Candidate& best) const;
    Candidate nearest_of_face(std::uint32_t face, const double* place,
                              const Distance& distance) const;

    const SolidMesh& mesh_;
    int scale_;                    // coordinates times 2^-scale_ are at most 1
    Buffer<std::uint32_t> faces_;  // 4 times the tetrahedron plus the position
    Buffer<BoundingBox> boxes_;    // of the faces, scaled
    BoxTree tree_;
};

}  // namespace mgdt
