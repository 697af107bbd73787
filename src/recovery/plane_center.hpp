// SPDX-License-Identifier: MIT
// A place that is as far as possible from all of some planes.
#pragma once

#include "recovery/flip_mesh.hpp"

namespace mgdt {

// Finds the analytic centre of a set of half-spaces: the place that maximises the product of the
// distances from their planes (Boyd and Vandenberghe, Convex Optimization, 2004, section 8.5.3).
class PlaneCenter {
  public:
    explicit PlaneCenter(Allocator& allocator) : planes_(allocator) {}

    void clear() noexcept { planes_.clear(); }
    // Adds the half-space of the places x for which the orientation of a, b, c and x is positive.
    void add(const double* a, const double* b, const double* c);
    // Moves x across the plane that is farthest on its wrong side, again and again, until x is
    // inside of all half-spaces. Returns false if that takes too many steps. (Motzkin and
    // Schoenberg, Canadian Journal of Mathematics 6, 1954.)
    bool enter(double (&x)[3]) const;
    // Moves x towards the centre, by Newton's method. The result is inside of all half-spaces, up
    // to rounding, if x is.
    void approach(double (&x)[3]) const;

  private:
    struct Plane {
        double normal[3];  // with length 1
        double origin[3];
    };
    double distance(const Plane& plane, const double (&x)[3]) const noexcept;
    bool is_inside(const double (&x)[3]) const noexcept;
    bool find_step(const double (&x)[3], double (&step)[3]) const;

    Buffer<Plane> planes_;
};

// Moves a new point, which tetrahedra from element `first` of a list have, into the half-spaces in
// which they are positive. Returns false, and does not move it, if it does not find a place.
bool enter_half_spaces(FlipMesh& mesh, std::uint32_t v, const Buffer<FlipMesh::Corners>& tetrahedra,
                       std::size_t first, PlaneCenter& center);

// Moves a new point, for which such tetrahedra are positive, towards the centre of the half-spaces,
// if they stay positive.
void center_new_point(FlipMesh& mesh, std::uint32_t v, const Buffer<FlipMesh::Corners>& tetrahedra,
                      std::size_t first, PlaneCenter& center);

}  // namespace mgdt
