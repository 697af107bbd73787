// SPDX-License-Identifier: MIT
// The centre of a tetrahedron's circumsphere and the square of its radius, as the doubles nearest
// to the exact ones: for all finite doubles and every tetrahedron, however flat.
#pragma once

namespace mgdt {

struct Circumcenter {
    double x[3];
    double radius2;
};

// Of a positively oriented tetrahedron with these vertices times 2^-scale. Infinite where the
// largest double is exceeded. Neither the order of the vertices nor the scale changes the result.
Circumcenter circumcenter(const double* const (&p)[4], int scale = 0);

// The centre relative to the first vertex, with an error of at most center_offset_error times its
// largest coordinate. The order of the vertices may change it within that.
void center_offset(const double* const (&p)[4], double (&offset)[3]);
constexpr double center_offset_error = 0x1p-50;

namespace exact {

// Coefficients of the error of the correction, in units of 2^-53 and of 2^-106: docs/theory.md,
// "Circumcentres", proves 20, 75 and 225.
struct CircumcenterBounds {
    double solution = 128;  // of its numerators and of its determinant, which is above twice this
    double residual = 240;
};
inline constexpr CircumcenterBounds circumcenter_bounds{};

// |r|^2 - w.r for r = p - origin, rounded once but for an error of at most sphere_residual_bound
// 2^-106 l (l + m), where l is the largest coordinate of r and m that of w.
double sphere_residual(const double* p, const double* origin, const double (&w)[3]);
constexpr double sphere_residual_bound = 90;

// The stages, one by one. Doubles that are corrected once: false where that leaves the rounding
// open. Twofold numbers with bounds, likewise, of coordinates of any size. Integers of the least of
// `widths` that fits and is at least least_width.
bool circumcenter_refined(const double* const (&p)[4], int scale, Circumcenter& c,
                          const CircumcenterBounds& bounds = circumcenter_bounds);
bool circumcenter_bounded(const double* const (&p)[4], int scale, Circumcenter& c);
void circumcenter_integer(const double* const (&p)[4], int scale, Circumcenter& c,
                          int least_width = 0);
bool center_offset_bounded(const double* const (&p)[4], double (&offset)[3]);
void center_offset_integer(const double* const (&p)[4], double (&offset)[3]);

}  // namespace exact
}  // namespace mgdt
