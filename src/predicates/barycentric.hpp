// SPDX-License-Identifier: MIT
// Barycentric coordinates as ratios of exact determinants, for all finite doubles and every
// tetrahedron, however flat.
#pragma once

namespace mgdt {

// The barycentric coordinates of q in the positively oriented tetrahedron with vertices p. Each is
// the ratio of two volumes, with a relative error below 3.01 * 2^-53, plus 2^-1075 if it is
// subnormal (docs/theory.md, "Barycentric weights"). So a weight is 0 if q is in the plane of the
// facet opposite the vertex, and all weights are in [0, 1] if q is in the tetrahedron. The order of
// the vertices does not change a weight.
void barycentric_weights(const double* const (&p)[4], const double* q, double (&w)[4]);

namespace exact {

// The stages, declared for tests. barycentric_native() returns false if the coordinates along an
// axis do not fit native integers. barycentric_integer() uses the smallest of `widths`
// (differences.hpp) that fits and is at least least_width.
bool barycentric_native(const double* const (&p)[4], const double* q, double (&w)[4]);
void barycentric_integer(const double* const (&p)[4], const double* q, double (&w)[4],
                         int least_width = 0);

}  // namespace exact
}  // namespace mgdt
