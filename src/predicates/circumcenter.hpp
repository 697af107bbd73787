// SPDX-License-Identifier: MIT
// The centre of a tetrahedron's circumsphere and the square of its radius, correctly rounded, for
// all finite doubles and every tetrahedron, however flat.
#pragma once

#include "predicates/twofold.hpp"

namespace mgdt {

struct Circumcenter {
    double x[3];
    double radius2;
};

// The circumcentre of a positively oriented tetrahedron whose vertices are p times 2^-scale. A
// result is infinite if it exceeds the largest double. Neither the order of the vertices nor the
// scale changes the result.
Circumcenter circumcenter(const double* const (&p)[4], int scale = 0);
// The same of the tetrahedron after the translation that takes the first vertex to `first`. The
// other vertices need not be doubles there.
Circumcenter translated_circumcenter(const double* const (&p)[4], const double* first,
                                     int scale = 0);

// A point as the sum of doubles and of corrections, which keep about 77 bits of a coordinate.
struct SplitPoint {
    double x[3];   // the coordinates, rounded to the nearest double
    float low[3];  // what the rounding left out
    float error;   // an upper bound on the error of each sum, infinite if nothing is known
};

// The circumcentre with corrections. Corrections and error are multiplied by `factor`, a power of
// two, which brings the coordinates into the range of floats. The order of the vertices may change
// the corrections within the error.
SplitPoint split_circumcenter(const double* const (&p)[4], double factor);
// The point x, given with bounds on the errors of its coordinates and with the doubles that are
// nearest to the true coordinates.
SplitPoint split(const Twofold (&x)[3], const double (&error)[3], const double (&nearest)[3],
                 double factor);

// Computes the position of the centre relative to the first vertex. The error is at most
// center_offset_error times the largest coordinate. The order of the vertices may change the result
// within this error.
void center_offset(const double* const (&p)[4], double (&offset)[3]);
constexpr double center_offset_error = 0x1p-50;

namespace exact {

// Coefficients of the error bound of the correction, in units of 2^-53 (`solution`) and of 2^-106
// (`residual`). docs/theory.md, "Circumcentres", proves that 20 and 75 are enough for `solution`,
// and 225 for `residual`.
struct CircumcenterBounds {
    double solution = 128;  // for the numerators; the determinant must be above twice this
    double residual = 240;
};
inline constexpr CircumcenterBounds circumcenter_bounds{};

// |r|^2 - w.r for r = p - origin. The result is rounded once, with an additional error of at most
// sphere_residual_bound 2^-106 l (l + m), where l is the largest coordinate of r and m that of w.
double sphere_residual(const double* p, const double* origin, const double (&w)[3]);
constexpr double sphere_residual_bound = 90;

// The stages, for tests. `first` is where the first vertex is taken to. The first stage computes in
// doubles and corrects the result once. The second
// computes in twofold numbers with bounds, for coordinates of any magnitude. Both return false if
// they cannot round correctly. The third computes in integers, with the smallest of `widths` that
// fits and is at least least_width.
bool circumcenter_refined(const double* const (&p)[4], const double* first, int scale,
                          Circumcenter& c, const CircumcenterBounds& bounds = circumcenter_bounds);
bool circumcenter_bounded(const double* const (&p)[4], const double* first, int scale,
                          Circumcenter& c);
void circumcenter_integer(const double* const (&p)[4], const double* first, int scale,
                          Circumcenter& c, int least_width = 0);
bool center_offset_bounded(const double* const (&p)[4], double (&offset)[3]);
void center_offset_integer(const double* const (&p)[4], double (&offset)[3]);

}  // namespace exact
}  // namespace mgdt
