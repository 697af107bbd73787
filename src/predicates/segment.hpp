// SPDX-License-Identifier: MIT
// Predicates of a line that is displaced, and where a segment crosses a facet.
#pragma once

namespace mgdt {

// The sign of (b - a) x (d - a) . (p - q). If the line ab moves by an infinitesimal multiple of
// d - a, orientation(a, b, p, q) changes by this multiple of the triple product.
int change_of_orientation(const double* a, const double* b, const double* d, const double* p,
                          const double* q);

// The number t for which a + t (b - a) is in the plane of the triangle p, correctly rounded. a is
// not in the plane, and ab is not parallel to it.
double crossing_parameter(const double* a, const double* b, const double* const (&p)[3]);

namespace exact {

// The stages, declared for tests. Those whose names do not end in _integer may be undecided, or
// return false.
int change_of_orientation_bounded(const double* a, const double* b, const double* d,
                                  const double* p, const double* q);
int change_of_orientation_integer(const double* a, const double* b, const double* d,
                                  const double* p, const double* q, int least_width = 0);
// The error of a determinant in twofold numbers, over 2^-102 times the sum of its terms' magnitudes
// (docs/theory.md, "Walks along a segment").
constexpr double crossing_bound = 6;
bool crossing_parameter_twofold(const double* a, const double* b, const double* const (&p)[3],
                                double& t, double bound = crossing_bound);
bool crossing_parameter_bounded(const double* a, const double* b, const double* const (&p)[3],
                                double& t);
double crossing_parameter_integer(const double* a, const double* b, const double* const (&p)[3],
                                  int least_width = 0);

}  // namespace exact
}  // namespace mgdt
