// SPDX-License-Identifier: MIT
// The smallest sphere through three points. Its centre is in their plane.
#pragma once

namespace mgdt {

// +1 if q is inside the smallest sphere through a, b and c, 0 on it, -1 outside. The four points
// are not in one plane.
int side_of_facet_sphere(const double* a, const double* b, const double* c, const double* q);

// The squared radius of the smallest sphere through the three points p times 2^-scale, which are
// not on one line. The relative error is below facet_radius_error. The order of the points may
// change the result within this error.
double facet_radius2(const double* const (&p)[3], int scale = 0);
constexpr double facet_radius_error = 0x1p-46;

// The squared radius of the smallest sphere through a and b times 2^-scale: a quarter of the square
// of their distance.
double edge_radius2(const double* a, const double* b, int scale = 0);

namespace exact {

// The stages of side_of_facet_sphere() and facet_radius2(), for tests. A stage that cannot decide
// returns `undecided` or false.
int facet_sphere_filter(const double* a, const double* b, const double* c, const double* q);
int facet_sphere_bounded(const double* a, const double* b, const double* c, const double* q);
int facet_sphere_integer(const double* a, const double* b, const double* c, const double* q,
                         int least_width = 0);
bool facet_radius2_plain(const double* const (&p)[3], double& square);
bool facet_radius2_twofold(const double* const (&p)[3], double& square);
bool facet_radius2_bounded(const double* const (&p)[3], int scale, double& square);
double facet_radius2_integer(const double* const (&p)[3], int scale, int least_width = 0);

}  // namespace exact
}  // namespace mgdt
